package fieldcal.effect;

import fieldcal.ball.Parameter;
import java.util.List;

/**
 * One cause that the simple model leaves out, with its numbers. Immutable; the same cause with other numbers is another value ({@link
 * #withParameters}).
 *
 * <p>Parameters come in the order of the design's table: the magnitude first; those that only say where or which (camera, robot, region) are marked
 * as not estimated. With all magnitudes zero the cause is absent, and every prediction is the same to the last bit as without it.
 */
public interface Effect {

  /**
   * The name in files and commands.
   *
   * @return lower case with underscores
   */
  String id();

  /**
   * What it is, for operators.
   *
   * @return one sentence
   */
  String sentence();

  /**
   * Its numbers.
   *
   * @return magnitude first, always in the same order
   */
  List<Parameter> parameters();

  /**
   * The same cause with other numbers.
   *
   * @param values in the order of {@link #parameters()}, finite
   * @return the changed effect
   * @throws IllegalArgumentException when the count is wrong or a value is not finite
   */
  Effect withParameters(double... values);

  /**
   * Whether it changes nothing because all its magnitudes are zero.
   *
   * @return true when absent
   */
  boolean isAbsent();

  /**
   * The parameters that make it absent when they are all zero.
   *
   * @return names; the first parameter's alone unless an effect says otherwise
   */
  default List<String> magnitudes() {
    return List.of(parameters().get(0).name());
  }

  /**
   * Whether it grows with the time since the session's begin, so that a clock is needed to predict with it.
   *
   * @return false unless an effect says otherwise
   */
  default boolean changesWithTime() {
    return false;
  }

  /**
   * Small versions of this effect, one for each independent way in which it can depart from absence, each with a magnitude of one scale. Near
   * zero every setting of the magnitudes and directions is a linear combination of these (a slope: one along x and one along y), so that a score test needs
   * these derivatives and no others. Place and camera stay as they are.
   *
   * @return at least one
   */
  default List<Effect> probes() {
    return magnitudes().stream().map(name -> withNone().with(name, scale(name))).toList();
  }

  /**
   * The same effect with all magnitudes zero.
   *
   * @return an absent effect
   */
  default Effect withNone() {
    Effect none = this;
    for (String name : magnitudes()) {
      none = none.with(name, 0);
    }
    return none;
  }

  /**
   * The same cause with one number changed.
   *
   * @param name of the parameter
   * @param value finite
   * @return the changed effect
   * @throws IllegalArgumentException when there is no such parameter
   */
  default Effect with(String name, double value) {
    double[] values = parameters().stream().mapToDouble(Parameter::value).toArray();
    values[index(name)] = value;
    return withParameters(values);
  }

  /**
   * One number.
   *
   * @param name of the parameter
   * @return its value
   * @throws IllegalArgumentException when there is no such parameter
   */
  default double value(String name) {
    return parameters().get(index(name)).value();
  }

  private double scale(String name) {
    return parameters().get(index(name)).scale();
  }

  private int index(String name) {
    List<Parameter> all = parameters();
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i).name().equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException(id() + " has no parameter '" + name + "'");
  }
}
