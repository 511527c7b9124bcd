package fieldcal.fit.joint;

/**
 * Turns global parameters into what the kicks predict with.
 *
 * @param <S> that something, immutable and thread-safe
 */
@FunctionalInterface
public interface SharedModel<S> {
  /**
   * The state at a point.
   *
   * @param globals values of the global parameters, in the problem's order
   * @return what the kicks predict with
   */
  S at(double[] globals);

  /**
   * The state a small step away along one parameter.
   *
   * @param here the state without the step
   * @param globals values of the global parameters
   * @param index of the parameter
   * @param step what is added to it
   * @return the state there, which may know what is the same as without the step
   */
  default S stepped(S here, double[] globals, int index, double step) {
    double[] moved = globals.clone();
    moved[index] += step;
    return at(moved);
  }
}
