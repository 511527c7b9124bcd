package fieldcal.diagnosis;

import fieldcal.ball.Parameter;
import fieldcal.effect.Effect;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Coordinates of an effect that are smooth at its absence, for the fit: a magnitude with a direction (a slope, a tilt) is two Cartesian components, everything else is itself. Only
 * the magnitudes that are named are free, the others stay zero. Immutable.
 */
final class Chart {
  /** Width of what is expected of a magnitude before seeing data, in the parameter's scales: a common value of the effect. */
  private static final double EXPECTED = 4;

  /** One magnitude, with the index of its direction or -1. */
  private record Axis(int magnitude, int direction) {
    int coordinates() {
      return direction < 0 ? 1 : 2;
    }
  }

  private final Effect template;
  private final List<Axis> axes = new ArrayList<>();
  private final double[] scales;
  private final double[] limits;

  private Chart(Effect template, List<String> magnitudes) {
    this.template = template.withNone();
    List<Parameter> parameters = template.parameters();
    List<Double> scale = new ArrayList<>();
    List<Double> limit = new ArrayList<>();
    for (int i = 0; i < parameters.size(); i++) {
      Parameter p = parameters.get(i);
      if (magnitudes.contains(p.name())) {
        boolean turns = i + 1 < parameters.size() && isDirection(parameters.get(i + 1));
        Axis axis = new Axis(i, turns ? i + 1 : -1);
        axes.add(axis);
        for (int k = 0; k < axis.coordinates(); k++) {
          scale.add(p.scale());
          limit.add(p.max());
        }
      }
    }
    scales = scale.stream().mapToDouble(s -> s).toArray();
    limits = limit.stream().mapToDouble(s -> s).toArray();
  }

  private static boolean isDirection(Parameter p) {
    return p.estimated() && p.name().matches("direction|axis");
  }

  /** All magnitudes of an effect. */
  static Chart of(Effect template) {
    return new Chart(template, template.magnitudes());
  }

  /** Some magnitudes of an effect. */
  static Chart of(Effect template, String... magnitudes) {
    return new Chart(template, List.of(magnitudes));
  }

  String id() {
    return template.id();
  }

  Effect template() {
    return template;
  }

  /** How many coordinates there are. */
  int size() {
    return scales.length;
  }

  /** A small change of a coordinate. */
  double scale(int coordinate) {
    return scales[coordinate];
  }

  /** Standard deviation of a coordinate before any data. */
  double expected(int coordinate) {
    return EXPECTED * scales[coordinate];
  }

  /** Coordinates stay within plus and minus this. */
  double limit(int coordinate) {
    return limits[coordinate];
  }

  /** The effect at coordinates that begin at {@code from}. */
  Effect effect(double[] coordinates, int from) {
    double[] values = template.parameters().stream().mapToDouble(Parameter::value).toArray();
    int k = from;
    for (Axis axis : axes) {
      if (axis.direction < 0) {
        values[axis.magnitude] = within(axis.magnitude, coordinates[k++]);
      } else {
        double c = coordinates[k++];
        double s = coordinates[k++];
        values[axis.magnitude] = within(axis.magnitude, Math.hypot(c, s));
        values[axis.direction] = Math.atan2(s, c);
      }
    }
    return template.withParameters(values);
  }

  private double within(int index, double value) {
    return template.parameters().get(index).clamp(value);
  }

  /** Standard errors of the effect's parameters by name, from the covariance of coordinates that begin at {@code from}. */
  Map<String, Double> errors(double[] coordinates, double[][] covariance, int from) {
    Map<String, Double> errors = new LinkedHashMap<>();
    List<Parameter> parameters = template.parameters();
    int k = from;
    for (Axis axis : axes) {
      String name = parameters.get(axis.magnitude).name();
      if (axis.direction < 0) {
        errors.put(name, Math.sqrt(covariance[k][k]));
        k++;
        continue;
      }
      double size = Math.hypot(coordinates[k], coordinates[k + 1]);
      double c = size > 0 ? coordinates[k] / size : 1;
      double s = size > 0 ? coordinates[k + 1] / size : 0;
      double xx = covariance[k][k];
      double xy = covariance[k][k + 1];
      double yy = covariance[k + 1][k + 1];
      errors.put(name, Math.sqrt(c * c * xx + 2 * c * s * xy + s * s * yy));
      String turn = parameters.get(axis.direction).name();
      errors.put(turn, Math.sqrt(s * s * xx - 2 * c * s * xy + c * c * yy) / size);
      k += 2;
    }
    return errors;
  }

  /** Whether this is the same cause at the same place, maybe with other magnitudes free. */
  boolean sameCause(Chart other) {
    return template.equals(other.template);
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(template.id());
    for (Axis axis : axes) {
      text.append(' ').append(template.parameters().get(axis.magnitude).name());
    }
    for (Parameter p : template.parameters()) {
      if (!p.estimated()) {
        text.append(' ').append(p.name()).append('=').append(p.value());
      }
    }
    return text.toString();
  }
}
