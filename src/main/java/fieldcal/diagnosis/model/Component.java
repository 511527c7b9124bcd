package fieldcal.diagnosis.model;

import fieldcal.ball.Parameter;
import fieldcal.effect.Area;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.fit.joint.SharedProblem.Prior;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * One effect within a model, in coordinates that are smooth at its absence: a magnitude with a direction (a slope, a tilt) is two Cartesian components, every other magnitude is itself. The magnitudes that are not free stay zero. Once
 * found, an effect's place (a region, a line, an instant) may be free, too. Immutable.
 */
public final class Component {
  /** Standard deviation of a magnitude's prior, in the parameter's scales: a common value of the effect. A place has the same about where it was. */
  private static final double EXPECTED = 4;

  /** The same for a mean that is not estimated, because a parameter of the ball takes its place. */
  private static final double NO_MEAN = 0.001;

  /** One magnitude, with the index of its direction or -1. */
  private record Axis(int magnitude, int direction) {}

  private final Effect template;

  /** The template's, which a learned map of the carpet has a hundred of. */
  private final List<Parameter> parameters;

  private final List<String> magnitudes;
  private final boolean perKick;
  private final boolean placesFree;
  private final List<Axis> axes = new ArrayList<>();
  private final List<Integer> places = new ArrayList<>();
  private final List<Parameter> coordinates = new ArrayList<>();
  private final List<Prior> priors = new ArrayList<>();

  private Component(Effect template, List<String> magnitudes, boolean perKick, boolean placesFree) {
    this.template = template;
    this.magnitudes = List.copyOf(magnitudes);
    this.perKick = perKick;
    this.placesFree = placesFree;
    parameters = List.copyOf(template.parameters());
    for (int i = 0; i < parameters.size(); i++) {
      Parameter p = parameters.get(i);
      if (magnitudes.contains(p.name())) {
        boolean turns = i + 1 < parameters.size() && isDirection(template, parameters.get(i + 1));
        axes.add(new Axis(i, turns ? i + 1 : -1));
        if (turns) {
          double angle = parameters.get(i + 1).value();
          addMagnitude(p, " x", p.value() * Math.cos(angle));
          addMagnitude(p, " y", p.value() * Math.sin(angle));
        } else {
          addMagnitude(p, "", p.value());
        }
      }
    }
    if (placesFree) {
      for (int i = 0; i < parameters.size(); i++) {
        if (template.places().contains(parameters.get(i).name())) {
          places.add(i);
          Parameter p = parameters.get(i);
          coordinates.add(named(p.free(), ""));
          // A bound that no ball crossed stays where it is.
          priors.add(new Prior(p.value(), 1 / (EXPECTED * p.scale() * EXPECTED * p.scale())));
        }
      }
    }
  }

  private void addMagnitude(Parameter p, String axis, double value) {
    // Along an axis a magnitude has either sign.
    double min = axis.isEmpty() ? p.min() : -p.max();
    coordinates.add(named(p.withBounds(min, p.max()).withValue(value).free(), axis));
    double deviation = (isChance() ? NO_MEAN : EXPECTED) * p.scale();
    // A law that replaces another is not expected near its absence, but near where it starts.
    double mean = template.starts().isEmpty() ? 0 : value;
    priors.add(new Prior(mean, 1 / (deviation * deviation)));
  }

  private Parameter named(Parameter p, String axis) {
    return new Parameter(
        template.id() + " " + p.name() + axis,
        p.unit(),
        p.value(),
        p.scale(),
        p.min(),
        p.max(),
        true,
        p.source());
  }

  /** An angle that is estimated and is not a magnitude gives the direction of the magnitude before it. */
  private static boolean isDirection(Effect template, Parameter p) {
    return p.estimated() && p.unit().equals("rad") && !template.magnitudes().contains(p.name());
  }

  /**
   * An effect with some of its magnitudes free.
   *
   * @param template with the numbers to start from
   * @param magnitudes those that are free
   * @return the component
   */
  public static Component of(Effect template, List<String> magnitudes) {
    return new Component(template, magnitudes, false, false);
  }

  /**
   * An effect whose first magnitude differs from kick to kick: that coordinate is the mean. Other magnitudes are the same for all kicks.
   *
   * @param template with the mean to start from
   * @return the component
   */
  public static Component perKick(Effect template) {
    return new Component(template, template.magnitudes(), true, false);
  }

  /**
   * The same with its place free.
   *
   * @return the changed copy
   */
  public Component withPlaceFree() {
    return new Component(template, magnitudes, perKick, true);
  }

  /**
   * The same with its place held.
   *
   * @return the changed copy
   */
  public Component withPlaceHeld() {
    return placesFree ? new Component(template, magnitudes, perKick, false) : this;
  }

  /**
   * The same from other numbers on.
   *
   * @param start the same effect with other numbers
   * @return the changed copy
   */
  public Component startingAt(Effect start) {
    return new Component(start, magnitudes, perKick, placesFree);
  }

  /**
   * The same with more magnitudes, which show finer detail.
   *
   * @return from the template's numbers on; empty where there is none
   */
  public Optional<Component> finer() {
    return template.finer().map(e -> of(e, e.magnitudes()));
  }

  /**
   * The same in another recording, which may determine more or fewer of the magnitudes that differ from kick to kick.
   *
   * @param arena what was recorded
   * @return the component with the magnitudes that can show there
   */
  public Component in(Arena arena) {
    if (!perKick) {
      return this;
    }
    double[] values = parameters.stream().mapToDouble(Parameter::value).toArray();
    return template.candidates(arena).stream()
        .map(e -> perKick(e.withParameters(values)))
        .filter(this::isSameCause)
        .findFirst()
        .orElse(this);
  }

  /**
   * The effect with the numbers to start from.
   *
   * @return the template
   */
  public Effect template() {
    return template;
  }

  /**
   * Whether it is a law that replaces another, and has no absence to be compared with.
   *
   * @return false for what may be absent
   */
  public boolean isLaw() {
    return !template.starts().isEmpty();
  }

  /**
   * Whether it has a place that could be free.
   *
   * @return false for effects that act everywhere
   */
  public boolean hasPlace() {
    return !template.places().isEmpty();
  }

  /**
   * Whether its place is a moment of the session, from which on it acts.
   *
   * @return false for places on the field
   */
  public boolean isInstant() {
    return template.changesWithTime() && template.places().size() == 1;
  }

  /**
   * Whether the first magnitude differs from kick to kick.
   *
   * @return true for a random effect
   */
  public boolean isPerKick() {
    return perKick;
  }

  /**
   * Whether it has another value in each kick and no cause: its mean is a parameter of the ball, or zero.
   *
   * @return true for a random effect without a mean of its own
   */
  public boolean isChance() {
    return perKick && !template.hasOwnMean();
  }

  /**
   * Its global parameters.
   *
   * @return magnitudes first, then free places
   */
  public List<Parameter> coordinates() {
    return coordinates;
  }

  /**
   * What is known of them before any data.
   *
   * @return one prior for each coordinate
   */
  public List<Prior> priors() {
    return priors;
  }

  /**
   * How many global parameters it has.
   *
   * @return their number
   */
  public int size() {
    return coordinates.size();
  }

  /**
   * How many of them are magnitudes.
   *
   * @return their number
   */
  public int magnitudeCount() {
    return coordinates.size() - places.size();
  }

  /**
   * The effect at coordinates.
   *
   * @param at values that hold them
   * @param from index of the first
   * @return the effect, its numbers within their bounds
   */
  public Effect effect(double[] at, int from) {
    double[] values = parameters.stream().mapToDouble(Parameter::value).toArray();
    int k = from;
    for (Axis axis : axes) {
      if (axis.direction < 0) {
        values[axis.magnitude] = within(axis.magnitude, at[k++]);
      } else {
        double c = at[k++];
        double s = at[k++];
        values[axis.magnitude] = within(axis.magnitude, Math.hypot(c, s));
        values[axis.direction] = Math.atan2(s, c);
      }
    }
    for (int i : places) {
      values[i] = at[k++];
    }
    return template.withParameters(values);
  }

  /** Where a ball must have been for one of the coordinates to matter; empty = anywhere. */
  Optional<Area> reach(double[] at, int from, int coordinate) {
    if (perKick || coordinate >= magnitudeCount()) {
      return Optional.empty();
    }
    double[] alone = new double[size()];
    alone[coordinate] = coordinates.get(coordinate).scale();
    for (int i = magnitudeCount(); i < alone.length; i++) {
      alone[i] = at[from + i];
    }
    return effect(alone, 0).reach();
  }

  private double within(int index, double value) {
    return parameters.get(index).clamp(value);
  }

  /**
   * Standard errors of the effect's parameters.
   *
   * @param at values that hold the coordinates
   * @param covariance of those values
   * @param from index of the first
   * @return by name, in the parameters' order
   */
  public Map<String, Double> errors(double[] at, double[][] covariance, int from) {
    Map<String, Double> errors = new LinkedHashMap<>();
    int k = from;
    for (Axis axis : axes) {
      String name = parameters.get(axis.magnitude).name();
      if (axis.direction < 0) {
        errors.put(name, Math.sqrt(covariance[k][k]));
        k++;
        continue;
      }
      double size = Math.hypot(at[k], at[k + 1]);
      double c = size > 0 ? at[k] / size : 1;
      double s = size > 0 ? at[k + 1] / size : 0;
      double xx = covariance[k][k];
      double xy = covariance[k][k + 1];
      double yy = covariance[k + 1][k + 1];
      errors.put(name, Math.sqrt(Math.max(0, c * c * xx + 2 * c * s * xy + s * s * yy)));
      String turn = parameters.get(axis.direction).name();
      errors.put(turn, Math.sqrt(Math.max(0, s * s * xx - 2 * c * s * xy + c * c * yy)) / size);
      k += 2;
    }
    for (int i : places) {
      errors.put(parameters.get(i).name(), Math.sqrt(covariance[k][k]));
      k++;
    }
    return errors;
  }

  /**
   * Whether this is the same effect on the same thing (camera, robot), whatever its numbers and its place.
   *
   * @param other component
   * @return true when both cannot be in one model
   */
  public boolean isSameCause(Component other) {
    return template.id().equals(other.template.id())
        && template.subject().equals(other.template.subject());
  }

  /**
   * The camera it acts on.
   *
   * @return empty for effects that concern no single camera
   */
  public OptionalInt camera() {
    return parameters.stream()
        .filter(p -> p.name().equals("camera") && p.value() >= 0)
        .mapToInt(p -> (int) p.value())
        .findFirst();
  }

  /** Whether a number says where or on what it acts. */
  private boolean tellsWhere(Parameter p) {
    return template.places().contains(p.name()) || template.subject().contains(p.name() + '=');
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(template.label());
    if (!magnitudes.equals(template.magnitudes())) {
      text.append(magnitudes);
    }
    for (Parameter p : parameters) {
      if (!p.estimated() && tellsWhere(p)) {
        text.append(' ').append(p.name()).append('=').append(Math.round(p.value() * 100) / 100.0);
      }
    }
    return perKick ? text + " (per kick)" : text.toString();
  }
}
