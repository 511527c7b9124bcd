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
   * The same where a parameter is zero: an absent effect leaves the path to be integrated in longer steps, and their errors (0.02 mm) must stay small beside what the step of the parameter does. So that a step that long gives a derivative that is as right, it leads to both sides.
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
    return blocks(free, meanColumns, List.of());
  }

  /** Columns of the free global parameters, then those of further probes. */
  KickBlock[] blocks(int[] free, int[] meanColumns, List<Probe<S>> further) {
    KickBlock[] blocks = new KickBlock[kicks.size()];
    double[] means = problem.means(values);
    each(
        free,
        further,
        new double[kicks.size()][],
        (k, residuals, ownColumns, shared) -> {
          KickBlock block = new KickBlock(ownColumns.length, shared.length);
          block.add(ownColumns, shared, residuals, problem.weights()[k]);
          OwnPriors.tie(block, kicks.get(k), own.get(k), means, meanColumns, scatters);
          blocks[k] = block;
        });
    return blocks;
  }

  /** Columns of the free global parameters, kept for equations nearby; of kicks whose residuals are null, these are filled in. */
  KickColumns[] columns(int[] free, double[][] residualsHere) {
    KickColumns[] columns = new KickColumns[kicks.size()];
    each(
        free,
        List.of(),
        residualsHere,
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

  private void each(int[] free, List<Probe<S>> further, double[][] known, Maker maker) {
    S centre = problem.model().at(values);
    List<Probe<S>> probes = new ArrayList<>();
    for (int f : free) {
      probes.add(probe(centre, f));
    }
    probes.addAll(further);
    IntStream.range(0, kicks.size())
        .parallel()
        .forEach(
            k -> {
              KickTerm<S> term = kicks.get(k);
              double[] p = own.get(k);
              double[] residuals = known[k];
              if (residuals == null) {
                residuals = new double[term.rows()];
                term.residuals(p, centre, residuals);
              }
              double[][] ownColumns = new double[p.length][residuals.length];
              double[][] shared = new double[probes.size()][residuals.length];
              term.columns(p, centre, residuals, probes, ownColumns, shared);
              maker.make(k, residuals, ownColumns, shared);
            });
  }

  private Probe<S> probe(S centre, int index) {
    Parameter p = problem.globals().get(index);
    double value = values[index];
    if (value != 0) {
      double h = DERIVATIVE_STEP * p.scale();
      return towards(centre, index, value + h <= p.max() ? h : -h);
    }
    double h = STEP_FROM_ABSENCE * p.scale();
    if (h > p.max()) {
      return towards(centre, index, -h);
    }
    return -h < p.min()
        ? towards(centre, index, h)
        : new Probe<>(stepped(centre, index, -h), stepped(centre, index, h), 2 * h);
  }

  private Probe<S> towards(S centre, int index, double step) {
    return new Probe<>(null, stepped(centre, index, step), step);
  }

  private S stepped(S centre, int index, double step) {
    return problem.model().stepped(centre, values, index, step);
  }
}
