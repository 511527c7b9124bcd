package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Makes the kicks' normal equations at a point: own parameters beside any columns of shared ones. */
final class Linearizer<S> {
  /**
   * A step for a derivative, in scales of the parameter: the second order is then a ten-thousandth of the first for anything that bends within ten scales. Where two parameters do nearly the same (spin and kSwitch of flat kicks), a derivative
   * that is wrong by a quarter of a per cent would tell them apart and make their errors twenty times too small.
   */
  static final double DERIVATIVE_STEP = 0.001;

  /**
   * The same where a parameter is zero: an absent effect leaves the path to be integrated in longer steps, and their errors (0.02 mm) must stay small beside what the step of the parameter does. It is where solutions begin, not where they end.
   */
  private static final double STEP_FROM_ABSENCE = 0.05;

  private final SharedProblem<S> problem;
  private final List<KickTerm<S>> kicks;
  private final List<double[]> own;
  private final double[] values;
  private final double[] scatters;

  Linearizer(
      SharedProblem<S> problem,
      List<KickTerm<S>> kicks,
      List<double[]> own,
      double[] values,
      double[] scatters) {
    this.problem = problem;
    this.kicks = kicks;
    this.own = own;
    this.values = values;
    this.scatters = scatters;
  }

  KickBlock[] blocks(int[] free, int[] meanColumns) {
    return blocks(free, meanColumns, List.of(), new double[0]);
  }

  /** Columns of the free global parameters, then those towards further states. */
  KickBlock[] blocks(int[] free, int[] meanColumns, List<S> probes, double[] probeSteps) {
    KickBlock[] blocks = new KickBlock[kicks.size()];
    double[] means = problem.means(values);
    each(
        free,
        probes,
        probeSteps,
        (k, residuals, ownColumns, shared) -> {
          KickBlock block = new KickBlock(ownColumns.length, shared.length);
          block.add(ownColumns, shared, residuals, problem.weights()[k]);
          OwnPriors.tie(block, kicks.get(k), own.get(k), means, meanColumns, scatters);
          blocks[k] = block;
        });
    return blocks;
  }

  /** Columns of the free global parameters, kept for equations nearby; the residuals are filled in. */
  KickColumns[] columns(int[] free, double[][] residualsHere) {
    KickColumns[] columns = new KickColumns[kicks.size()];
    each(
        free,
        List.of(),
        new double[0],
        (k, residuals, ownColumns, shared) -> {
          residualsHere[k] = residuals;
          columns[k] = new KickColumns(ownColumns, shared, residuals.length, problem.weights()[k]);
        });
    return columns;
  }

  /** What is made of the derivatives of a kick. */
  @FunctionalInterface
  private interface Maker {
    void make(int kick, double[] residuals, double[][] ownColumns, double[][] shared);
  }

  private void each(int[] free, List<S> probes, double[] probeSteps, Maker maker) {
    S centre = problem.model().at(values);
    List<S> states = new ArrayList<>();
    double[] steps = new double[free.length + probeSteps.length];
    for (int i = 0; i < free.length; i++) {
      Parameter p = problem.globals().get(free[i]);
      double share = values[free[i]] == 0 ? STEP_FROM_ABSENCE : DERIVATIVE_STEP;
      double h = share * p.scale();
      steps[i] = values[free[i]] + h <= p.max() ? h : -h;
      states.add(problem.model().stepped(values, free[i], steps[i]));
    }
    states.addAll(probes);
    System.arraycopy(probeSteps, 0, steps, free.length, probeSteps.length);
    IntStream.range(0, kicks.size())
        .parallel()
        .forEach(
            k -> {
              KickTerm<S> term = kicks.get(k);
              double[] p = own.get(k);
              double[] residuals = new double[term.rows()];
              term.residuals(p, centre, residuals);
              double[][] ownColumns = new double[p.length][residuals.length];
              term.ownColumns(p, centre, residuals, ownColumns);
              double[][] shared = new double[steps.length][residuals.length];
              term.sharedColumns(p, centre, residuals, states, steps, shared);
              maker.make(k, residuals, ownColumns, shared);
            });
  }
}
