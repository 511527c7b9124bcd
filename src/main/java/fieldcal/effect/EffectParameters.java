package fieldcal.effect;

import fieldcal.ball.Parameter;

/** What the parameters of several effects have in common, and the checks of their values. */
public final class EffectParameters {
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
    return new Parameter("camera", "", value, 1, 0, 255, false, "which camera, by its id");
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
