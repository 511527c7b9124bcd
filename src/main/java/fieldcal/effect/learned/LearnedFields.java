package fieldcal.effect.learned;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/**
 * A learned term as files hold it: {@code acts_on}, {@code quantity}, {@code depends_on} (a list of names), {@code camera} (of measurements), {@code basis} and {@code
 * coefficients}. A basis has its {@code type} and what that needs: {@code range} [from, to] and {@code knots} of a spline, also {@code range_y} and two {@code knots} of a
 * surface or of stripes, {@code order} and {@code period} of harmonics, {@code degree} and both ranges of a polynomial, {@code first} and {@code count} of levels; {@code centred}
 * of splines, surfaces and polynomials.
 */
public final class LearnedFields {
  private static final String ACTS_ON = "acts_on";
  private static final String QUANTITY = "quantity";
  private static final String DEPENDS_ON = "depends_on";
  private static final String CAMERA = "camera";
  private static final String BASIS = "basis";
  private static final String COEFFICIENTS = "coefficients";

  private static final String TYPE = "type";
  private static final String RANGE = "range";
  private static final String RANGE_Y = "range_y";
  private static final String KNOTS = "knots";
  private static final String CENTRED = "centred";
  private static final String ORDER = "order";
  private static final String PERIOD = "period";
  private static final String DEGREE = "degree";
  private static final String FIRST = "first";
  private static final String COUNT = "count";

  private LearnedFields() {}

  /**
   * Writes.
   *
   * @param term any
   * @return values are strings, numbers, booleans, lists and maps
   */
  public static Map<String, Object> of(LearnedTerm term) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put(ACTS_ON, term.actsOn());
    fields.put(QUANTITY, term.family().quantity().label());
    fields.put(DEPENDS_ON, term.dependsOn());
    term.camera().ifPresent(camera -> fields.put(CAMERA, camera));
    fields.put(BASIS, of(term.family().basis()));
    List<Double> coefficients = new ArrayList<>();
    for (double c : term.coefficients()) {
      coefficients.add(c);
    }
    fields.put(COEFFICIENTS, coefficients);
    return fields;
  }

  private static Map<String, Object> of(Basis basis) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put(TYPE, basis.type());
    if (basis instanceof Spline s) {
      fields.put(RANGE, List.of(s.from(), s.to()));
      fields.put(KNOTS, s.knots());
      fields.put(CENTRED, s.centred());
    } else if (basis instanceof Surface s) {
      fields.put(RANGE, List.of(s.x().from(), s.x().to()));
      fields.put(RANGE_Y, List.of(s.y().from(), s.y().to()));
      fields.put(KNOTS, List.of(s.x().knots(), s.y().knots()));
      fields.put(CENTRED, s.centred());
    } else if (basis instanceof Stripes s) {
      fields.put(RANGE, List.of(s.x().from(), s.x().to()));
      fields.put(RANGE_Y, List.of(s.y().from(), s.y().to()));
      fields.put(KNOTS, List.of(s.x().knots(), s.y().knots()));
    } else if (basis instanceof Harmonics h) {
      fields.put(ORDER, h.order());
      fields.put(PERIOD, h.period());
    } else if (basis instanceof Polynomial p) {
      fields.put(DEGREE, p.degree());
      fields.put(RANGE, List.of(p.fromX(), p.toX()));
      fields.put(RANGE_Y, List.of(p.fromY(), p.toY()));
      fields.put(CENTRED, p.centred());
    } else if (basis instanceof Levels l) {
      fields.put(FIRST, l.first());
      fields.put(COUNT, l.count());
    }
    return fields;
  }

  /**
   * Reads.
   *
   * @param fields as {@link #of} makes them; any {@code Number} for numbers
   * @return the term
   * @throws IllegalArgumentException when a field is missing, unknown, of the wrong type or out of its range; the message begins with the field
   */
  public static LearnedTerm read(Map<?, ?> fields) {
    Set<Object> unknown = new HashSet<>(fields.keySet());
    unknown.removeAll(List.of(ACTS_ON, QUANTITY, DEPENDS_ON, CAMERA, BASIS, COEFFICIENTS));
    requireKnown("", unknown);
    Quantity quantity =
        Quantity.of(String.valueOf(fields.get(QUANTITY)))
            .orElseThrow(() -> wrong(QUANTITY, "a known quantity", fields.get(QUANTITY)));
    if (!quantity.actsOn().equals(fields.get(ACTS_ON))) {
      throw wrong(ACTS_ON, '"' + quantity.actsOn() + '"', fields.get(ACTS_ON));
    }
    List<Variable> variables = new ArrayList<>();
    for (Object name : list(DEPENDS_ON, fields.get(DEPENDS_ON))) {
      variables.add(
          Variable.of(String.valueOf(name))
              .orElseThrow(() -> wrong(DEPENDS_ON, "a list of known variables", name)));
    }
    Object camera = fields.get(CAMERA);
    OptionalInt who = camera == null ? OptionalInt.empty() : OptionalInt.of(camera(camera));
    if (!(fields.get(BASIS) instanceof Map<?, ?> basis)) {
      throw wrong(BASIS, "an object", fields.get(BASIS));
    }
    LearnedFamily family = new LearnedFamily(quantity, variables, basis(basis), who);
    return family.term(coefficients(family, fields.get(COEFFICIENTS)));
  }

  private static Basis basis(Map<?, ?> fields) {
    Set<Object> unknown = new HashSet<>(fields.keySet());
    unknown.remove(TYPE);
    Object type = fields.get(TYPE);
    unknown.removeAll(fieldsOf(type));
    requireKnown(BASIS + ".", unknown);
    try {
      return switch ((String) type) {
        case Spline.TYPE ->
            spline(RANGE, fields, whole(KNOTS, fields.get(KNOTS)), flag(fields.get(CENTRED)));
        case Surface.TYPE -> {
          List<?> knots = knots(fields);
          yield new Surface(
              spline(RANGE, fields, whole(KNOTS, knots.get(0)), false),
              spline(RANGE_Y, fields, whole(KNOTS, knots.get(1)), false),
              flag(fields.get(CENTRED)));
        }
        case Stripes.TYPE -> {
          List<?> knots = knots(fields);
          yield new Stripes(
              spline(RANGE, fields, whole(KNOTS, knots.get(0)), true),
              spline(RANGE_Y, fields, whole(KNOTS, knots.get(1)), true));
        }
        case Harmonics.TYPE ->
            new Harmonics(whole(ORDER, fields.get(ORDER)), number(PERIOD, fields.get(PERIOD)));
        case Polynomial.TYPE -> {
          double[] x = range(RANGE, fields.get(RANGE));
          double[] y = range(RANGE_Y, fields.get(RANGE_Y));
          int degree = whole(DEGREE, fields.get(DEGREE));
          // Documents of earlier versions have no other.
          boolean centred = !fields.containsKey(CENTRED) || flag(fields.get(CENTRED));
          yield new Polynomial(degree, x[0], x[1], y[0], y[1], centred);
        }
        default -> new Levels(whole(FIRST, fields.get(FIRST)), whole(COUNT, fields.get(COUNT)));
      };
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(BASIS + "." + e.getMessage(), e);
    }
  }

  private static List<String> fieldsOf(Object type) {
    return switch (type instanceof String text ? text : "") {
      case Spline.TYPE -> List.of(RANGE, KNOTS, CENTRED);
      case Surface.TYPE -> List.of(RANGE, RANGE_Y, KNOTS, CENTRED);
      case Stripes.TYPE -> List.of(RANGE, RANGE_Y, KNOTS);
      case Harmonics.TYPE -> List.of(ORDER, PERIOD);
      case Polynomial.TYPE -> List.of(DEGREE, RANGE, RANGE_Y, CENTRED);
      case Levels.TYPE -> List.of(FIRST, COUNT);
      default -> throw wrong(BASIS + "." + TYPE, "a known basis", type);
    };
  }

  private static List<?> knots(Map<?, ?> fields) {
    List<?> knots = list(KNOTS, fields.get(KNOTS));
    if (knots.size() != 2) {
      throw wrong(KNOTS, "two integers", knots);
    }
    return knots;
  }

  private static Spline spline(String name, Map<?, ?> fields, int knots, boolean centred) {
    double[] range = range(name, fields.get(name));
    return new Spline(range[0], range[1], knots, centred);
  }

  private static double[] range(String name, Object value) {
    List<?> ends = list(name, value);
    if (ends.size() != 2) {
      throw wrong(name, "[from, to]", value);
    }
    double[] range = {number(name, ends.get(0)), number(name, ends.get(1))};
    Basis.requireRange(name, range[0], range[1]);
    return range;
  }

  /** A number out of the range of estimates comes from a damaged file or a wrong unit. */
  private static double[] coefficients(LearnedFamily family, Object value) {
    List<?> list = list(COEFFICIENTS, value);
    if (list.size() != family.size()) {
      throw new IllegalArgumentException(
          COEFFICIENTS + ": must be " + family.size() + ", but are " + list.size());
    }
    double limit = family.quantity().limit();
    double[] numbers = new double[list.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = number(COEFFICIENTS, list.get(i));
      if (Math.abs(numbers[i]) > limit) {
        throw new IllegalArgumentException(
            COEFFICIENTS + ": must be within ±" + limit + ", but one is " + numbers[i]);
      }
    }
    return numbers;
  }

  private static int camera(Object value) {
    return whole(CAMERA, value);
  }

  private static List<?> list(String name, Object value) {
    if (value instanceof List<?> list) {
      return list;
    }
    throw wrong(name, "a list", value);
  }

  private static boolean flag(Object value) {
    if (value instanceof Boolean flag) {
      return flag;
    }
    throw wrong(CENTRED, "true or false", value);
  }

  private static int whole(String name, Object value) {
    double number = number(name, value);
    if (number < 0 || number != Math.rint(number) || number > Integer.MAX_VALUE) {
      throw wrong(name, "0 or a positive integer", value);
    }
    return (int) number;
  }

  private static double number(String name, Object value) {
    if (value instanceof Number n && Double.isFinite(n.doubleValue())) {
      return n.doubleValue();
    }
    throw wrong(name, "a number", value);
  }

  private static void requireKnown(String prefix, Set<Object> unknown) {
    if (!unknown.isEmpty()) {
      throw new IllegalArgumentException(
          prefix + unknown.iterator().next() + ": unknown to " + LearnedTerm.ID);
    }
  }

  private static IllegalArgumentException wrong(String name, String wanted, Object value) {
    String found = value instanceof String text ? '"' + text + '"' : String.valueOf(value);
    return new IllegalArgumentException(
        name + ": must be " + wanted + ", but is " + (value == null ? "missing" : found));
  }
}
