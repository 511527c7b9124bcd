package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Makes the kicks' normal equations at a point: own parameters beside any columns of shared ones. */
final class Linearizer<S> {
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
    S centre = problem.model().at(values);
    List<S> states = new ArrayList<>();
    double[] steps = new double[free.length + probeSteps.length];
    for (int i = 0; i < free.length; i++) {
      Parameter p = problem.globals().get(free[i]);
      double h = SharedSolver.DERIVATIVE_STEP * p.scale();
      steps[i] = values[free[i]] + h <= p.max() ? h : -h;
      double[] moved = values.clone();
      moved[free[i]] += steps[i];
      states.add(problem.model().at(moved));
    }
    states.addAll(probes);
    System.arraycopy(probeSteps, 0, steps, free.length, probeSteps.length);
    double[] means = problem.randoms().stream().mapToDouble(r -> values[r.mean()]).toArray();
    KickBlock[] blocks = new KickBlock[kicks.size()];
    IntStream.range(0, blocks.length)
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
              KickBlock block = new KickBlock(p.length, shared.length);
              block.add(ownColumns, shared, residuals, problem.weights()[k]);
              SharedSolver.tie(block, term, p, means, meanColumns, scatters);
              blocks[k] = block;
            });
    return blocks;
  }
}
