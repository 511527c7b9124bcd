package fieldcal.effect;

import fieldcal.ball.Parameter;
import fieldcal.effect.learned.LearnedFields;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The numbers of an effect as files hold them: by name, {@code camera} (left out where an effect is the same in all) and {@code robot} as integers, {@code team} as "yellow" or "blue", and the four
 * bounds of a region as one list, {@code region}: [x0, x1, y0, y1]; of a learned term the fields of {@link LearnedFields}. Maps and lists as every JSON library makes them.
 */
public final class EffectFields {
  private static final String REGION = "region";
  private static final String TEAM = "team";
  private static final Set<String> WHOLE = Set.of("camera", "robot");

  private EffectFields() {}

  /**
   * The numbers of an effect.
   *
   * @param effect any of the catalogue, or a learned term
   * @return values are {@code Double}, {@code Integer}, {@code String} or a list of {@code Double}, of a learned term also {@code Boolean} and maps; in the order of the
   *     parameters
   */
  public static Map<String, Object> of(Effect effect) {
    if (effect instanceof LearnedTerm term) {
      return LearnedFields.of(term);
    }
    Map<String, Object> fields = new LinkedHashMap<>();
    List<Double> region = new ArrayList<>();
    for (Parameter p : effect.parameters()) {
      if (isBound(p)) {
        region.add(p.value());
        fields.put(REGION, region);
      } else if (p.name().equals(TEAM)) {
        fields.put(TEAM, Team.values()[(int) p.value()].label());
      } else if (isAll(p, p.value())) {
        continue;
      } else if (WHOLE.contains(p.name())) {
        fields.put(p.name(), (int) p.value());
      } else if (!isOptional(effect, p)) {
        fields.put(p.name(), p.value());
      }
    }
    return fields;
  }

  /**
   * The effect with given numbers. A number that is not named, or a name that the effect does not have, is an error: a misspelt one must not count as zero.
   *
   * @param id of the effect
   * @param fields as {@link #of} makes them; any {@code Number} for numbers
   * @return the effect
   * @throws IllegalArgumentException when there is no such effect, a field is missing, unknown, of the wrong type or out of its range; the message begins with the
   *     field
   */
  public static Effect read(String id, Map<?, ?> fields) {
    if (id.equals(LearnedTerm.ID)) {
      return LearnedFields.read(fields);
    }
    Effect effect =
        EffectCatalogue.find(id)
            .orElseThrow(() -> new IllegalArgumentException("there is no effect '" + id + "'"));
    Set<Object> unknown = new HashSet<>(fields.keySet());
    List<Parameter> parameters = effect.parameters();
    double[] values = new double[parameters.size()];
    int bounds = 0;
    for (int i = 0; i < values.length; i++) {
      Parameter p = parameters.get(i);
      String name = isBound(p) ? REGION : p.name();
      Object value = fields.get(name);
      unknown.remove(name);
      values[i] =
          switch (name) {
            case REGION -> bound(value, bounds++);
            case TEAM -> team(value);
            default -> WHOLE.contains(name) ? whole(p, value) : plain(effect, p, value);
          };
    }
    if (!unknown.isEmpty()) {
      throw new IllegalArgumentException(unknown.iterator().next() + ": unknown to " + id);
    }
    return effect.withParameters(values);
  }

  /** Whether there is an effect of an id. */
  static boolean isKnown(String id) {
    return id.equals(LearnedTerm.ID) || EffectCatalogue.find(id).isPresent();
  }

  private static boolean isBound(Parameter p) {
    return p.name().startsWith(REGION + "_");
  }

  /**
   * A finite number.
   *
   * @param name of the field, for the message
   * @param value what is there; null when nothing is
   * @return the number
   * @throws IllegalArgumentException when it is none
   */
  static double number(String name, Object value) {
    if (value instanceof Number n && Double.isFinite(n.doubleValue())) {
      return n.doubleValue();
    }
    throw wrong(name, "a number", value);
  }

  private static IllegalArgumentException wrong(String name, String wanted, Object value) {
    String found = value instanceof String text ? '"' + text + '"' : String.valueOf(value);
    return new IllegalArgumentException(
        name + ": must be " + wanted + ", but is " + (value == null ? "missing" : found));
  }

  /** A number out of the range of estimates comes from a damaged file or a wrong unit. */
  private static double within(Parameter p, double value) {
    if (value >= p.min() && value <= p.max()) {
      return value;
    }
    throw new IllegalArgumentException(
        p.name() + ": must be within " + p.min() + " and " + p.max() + ", but is " + value);
  }

  private static double plain(Effect effect, Parameter p, Object value) {
    return value == null && isOptional(effect, p) ? 0 : within(p, number(p.name(), value));
  }

  /** Whether a number is held at zero: files may leave it out, as files of before it was known do. */
  private static boolean isOptional(Effect effect, Parameter p) {
    return !p.estimated() && p.value() == 0 && !effect.places().contains(p.name());
  }

  /** Whether a number stands for all cameras: files leave it out then. */
  private static boolean isAll(Parameter p, double value) {
    return p.min() == EffectParameters.ALL_CAMERAS && value == p.min() && WHOLE.contains(p.name());
  }

  private static double whole(Parameter p, Object value) {
    if (value == null && isAll(p, p.min())) {
      return EffectParameters.ALL_CAMERAS;
    }
    double number = number(p.name(), value);
    if (number < 0 || number != Math.rint(number) || number > Integer.MAX_VALUE) {
      throw wrong(p.name(), "0 or a positive integer", value);
    }
    return number;
  }

  private static double team(Object value) {
    for (Team team : Team.values()) {
      if (team.label().equals(value)) {
        return team.ordinal();
      }
    }
    throw wrong(TEAM, "\"yellow\" or \"blue\"", value);
  }

  private static double bound(Object value, int index) {
    if (value instanceof List<?> bounds && bounds.size() == 4) {
      double found = number(REGION, bounds.get(index));
      if (index % 2 == 1 && found < number(REGION, bounds.get(index - 1))) {
        throw wrong(REGION, "[x0, x1, y0, y1] with x0 <= x1 and y0 <= y1", value);
      }
      return found;
    }
    throw wrong(REGION, "[x0, x1, y0, y1]", value);
  }
}
