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
}
