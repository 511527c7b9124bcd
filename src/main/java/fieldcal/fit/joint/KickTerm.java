package fieldcal.fit.joint;

import java.util.List;

/**
 * One kick as the kernel sees it: residuals as a function of the kick's own parameters and of what all kicks share.
 *
 * <p>The last own parameters are the kick's values of the problem's {@link RandomEffect}s, in their order. Implementations are immutable and thread-safe.
 *
 * @param <S> what the global parameters amount to, made once for all kicks by the {@link SharedModel}
 */
public interface KickTerm<S> {

  /**
   * How many own parameters there are, random effects included.
   *
   * @return their number
   */
  int ownSize();

  /**
   * How many residuals there are.
   *
   * @return their number
   */
  int rows();

  /**
   * Whitened residuals, observed minus predicted; variance 1 where the model is right.
   *
   * @param own the kick's own parameters
   * @param state of the shared model
   * @param out one number per row
   */
  void residuals(double[] own, S state, double[] out);

  /**
   * Derivatives of the whitened prediction by the own parameters.
   *
   * @param own the kick's own parameters
   * @param state of the shared model
   * @param residuals at that point
   * @param columns one array of rows per own parameter, to be filled in
   */
  void ownColumns(double[] own, S state, double[] residuals, double[][] columns);

  /**
   * Derivatives of the whitened prediction by what is shared.
   *
   * @param own the kick's own parameters
   * @param state of the shared model
   * @param residuals at that state
   * @param probes pairs of states a small step from each other
   * @param columns one array of rows per probe, to be filled in
   */
  default void sharedColumns(
      double[] own, S state, double[] residuals, List<Probe<S>> probes, double[][] columns) {
    double[] from = new double[residuals.length];
    for (int c = 0; c < columns.length; c++) {
      Probe<S> probe = probes.get(c);
      if (probe.from() == null) {
        System.arraycopy(residuals, 0, from, 0, from.length);
      } else {
        residuals(own, probe.from(), from);
      }
      residuals(own, probe.to(), columns[c]);
      for (int i = 0; i < residuals.length; i++) {
        columns[c][i] = (from[i] - columns[c][i]) / probe.width();
      }
    }
  }

  /**
   * Both kinds of derivatives at once, which takes less time where they have something in common.
   *
   * @param own the kick's own parameters
   * @param state of the shared model
   * @param residuals at that point
   * @param probes pairs of states a small step from each other
   * @param ownColumns as of {@link #ownColumns}, to be filled in
   * @param sharedColumns as of {@link #sharedColumns}, to be filled in
   */
  default void columns(
      double[] own,
      S state,
      double[] residuals,
      List<Probe<S>> probes,
      double[][] ownColumns,
      double[][] sharedColumns) {
    ownColumns(own, state, residuals, ownColumns);
    sharedColumns(own, state, residuals, probes, sharedColumns);
  }

  /**
   * What is known of an own parameter before any data.
   *
   * @param index of the parameter
   * @return expected value; only looked at where the precision is positive
   */
  double ownPrior(int index);

  /**
   * How well that is known.
   *
   * @param index of the parameter
   * @return 1/variance, 0 when nothing is known
   */
  double ownPrecision(int index);

  /**
   * Brings own parameters back to where the kick makes sense.
   *
   * @param own changed in place
   */
  default void clamp(double[] own) {}

  /**
   * The same kick with a neighbouring value of a discrete unknown: one bounce more or less.
   *
   * @return empty when nothing is discrete
   */
  default List<KickTerm<S>> neighbours() {
    return List.of();
  }

  /**
   * The same kick with the value of the discrete unknown that a rule gives for it: the number of bounces that a hop of a certain height ends.
   *
   * @param own where it is now
   * @param state of the shared model
   * @return this where the rule gives the same, or nothing is discrete
   */
  default KickTerm<S> byRule(double[] own, S state) {
    return this;
  }

  /**
   * Where else the own parameters may start, and with which value of the discrete unknown, when a kick is explained much worse than its fellows: it may be in a local minimum.
   *
   * @param own where it is now
   * @param state of the shared model
   * @return other starts; empty when there are none
   */
  default List<Restart<S>> restarts(double[] own, S state) {
    return List.of();
  }

  /**
   * Another start.
   *
   * @param term with its value of the discrete unknown
   * @param own parameters
   * @param <S> what the global parameters amount to
   */
  record Restart<S>(KickTerm<S> term, double[] own) {}

  /**
   * What this value of the discrete unknown costs, in units of chi-square, at a point.
   *
   * @param own the kick's own parameters
   * @param state of the shared model
   * @return 0 unless a rule speaks against it; infinite when it is impossible
   */
  default double penalty(double[] own, S state) {
    return 0;
  }
}
