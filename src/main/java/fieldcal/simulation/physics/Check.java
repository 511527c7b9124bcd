package fieldcal.simulation.physics;

/** Argument checks that NaN fails. */
final class Check {

  private Check() {}

  static void range(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(
          name + " must lie in [" + min + ", " + max + "], but is " + value);
    }
  }

  static void finite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + " must be finite, but is " + value);
    }
  }
}
