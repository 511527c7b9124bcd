package fieldcal.ball;

/** Argument checks. All are written so that NaN fails them, and all name the value. */
final class Checks {
  private Checks() {}

  static double finite(String name, double value) {
    return require(Double.isFinite(value), name, value, "finite");
  }

  static double negative(String name, double value) {
    return require(Double.isFinite(value) && value < 0, name, value, "negative and finite");
  }

  static double positive(String name, double value) {
    return require(Double.isFinite(value) && value > 0, name, value, "positive and finite");
  }

  static double notNegative(String name, double value) {
    return require(Double.isFinite(value) && value >= 0, name, value, "finite and not negative");
  }

  static double between(String name, double value, double min, double max) {
    if (!(value > min && value < max)) {
      return require(false, name, value, "above " + min + " and below " + max);
    }
    return value;
  }

  static int between(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          name + " must be from " + min + " to " + max + ", but is " + value);
    }
    return value;
  }

  static void length(String name, double[] values, int length) {
    if (values.length != length) {
      throw new IllegalArgumentException(
          name + " must have " + length + " elements, but has " + values.length);
    }
  }

  private static double require(boolean holds, String name, double value, String what) {
    if (!holds) {
      throw new IllegalArgumentException(name + " must be " + what + ", but is " + value);
    }
    return value;
  }
}
