package fieldcal.effect;

import fieldcal.ball.Parameter;

/** What the parameters of several effects have in common, and the checks of their values. */
public final class EffectParameters {
  /** In place of a camera's id, where an effect may be the same in all cameras. */
  public static final int ALL_CAMERAS = -1;

  private static final int LARGEST_ID = 255;

  /** Longest session, s; chosen: a week. */
  private static final double LONGEST_SESSION = 604_800;

  private EffectParameters() {}

  /**
   * A direction in the field.
   *
   * @param name of the parameter
   * @param value rad, 0 = along x, counter-clockwise
   * @return the parameter
   */
  public static Parameter direction(String name, double value) {
    return new Parameter(name, "rad", value, 0.1, -2 * Math.PI, 2 * Math.PI, true, "any direction");
  }

  /**
   * The camera that is concerned; not estimated.
   *
   * @param value its id
   * @return the parameter
   */
  public static Parameter camera(int value) {
    return new Parameter("camera", "", value, 1, 0, LARGEST_ID, false, "which camera, by its id");
  }

  /**
   * The camera that is concerned, or all of them; not estimated.
   *
   * @param value its id, or {@link #ALL_CAMERAS}
   * @return the parameter
   */
  public static Parameter cameraOrAll(int value) {
    return new Parameter(
        "camera",
        "",
        value,
        1,
        ALL_CAMERAS,
        LARGEST_ID,
        false,
        "which camera, by its id; -1 = all");
  }

  /**
   * An instant; not estimated.
   *
   * @param value s since the beginning of the session
   * @return the parameter
   */
  public static Parameter instant(double value) {
    return place("at", "s", value, 0, LONGEST_SESSION, "time since the beginning of the session");
  }

  /**
   * A number that only says where or which; not estimated.
   *
   * @param name of the parameter
   * @param unit its unit
   * @param value its value
   * @param min smallest
   * @param max largest
   * @param source what it means
   * @return the parameter
   */
  public static Parameter place(
      String name, String unit, double value, double min, double max, String source) {
    return new Parameter(name, unit, value, 1, min, max, false, source);
  }

  /**
   * Checks the numbers of an effect.
   *
   * @param id of the effect
   * @param values the numbers
   * @throws IllegalArgumentException when one is not finite
   */
  public static void requireFinite(String id, double... values) {
    for (double value : values) {
      if (!Double.isFinite(value)) {
        throw new IllegalArgumentException(id + ": parameters must be finite, but one is " + value);
      }
    }
  }

  /**
   * Checks how many numbers there are, and that they are finite.
   *
   * @param id of the effect
   * @param values the numbers
   * @param count how many are needed
   * @return the numbers
   * @throws IllegalArgumentException when the count is wrong or one is not finite
   */
  public static double[] require(String id, double[] values, int count) {
    if (values.length != count) {
      throw new IllegalArgumentException(
          id + " has " + count + " parameters, but got " + values.length);
    }
    requireFinite(id, values);
    return values;
  }
}
