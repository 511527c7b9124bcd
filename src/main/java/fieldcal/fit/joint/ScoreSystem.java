package fieldcal.fit.joint;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Normal equations of a solution with further columns beside its free global parameters: what each column, or any set of them, would gain to first order, and how evenly over the kicks. All kicks' own parameters are eliminated.
 * Columns {@code 0 … base()−1} are the free global parameters of the solution, the others the probes in the order in which they were asked for. Immutable.
 */
public final class ScoreSystem {
  private final int base;
  private final double[][][] perKick;
  private final double[][] gradients;
  private final double[] costs;
  private final double[][] total;
  private final double[] gradient;

  private ScoreSystem(int base, double[][][] perKick, double[][] gradients, double[] costs) {
    this.base = base;
    this.perKick = perKick;
    this.gradients = gradients;
    this.costs = costs;
    int n = gradients[0].length;
    total = new double[n][n];
    gradient = new double[n];
    IntStream.range(0, n)
        .parallel()
        .forEach(
            i -> {
              for (int k = 0; k < perKick.length; k++) {
                gradient[i] += gradients[k][i];
                double[] row = perKick[k][i];
                for (int j = 0; j < n; j++) {
                  total[i][j] += row[j];
                }
              }
            });
  }

  /** Of kicks' normal equations, the first columns being those of the solution; takes the blocks apart. */
  static ScoreSystem of(int base, KickBlock[] blocks) {
    double[][][] s = new double[blocks.length][][];
    double[][] t = new double[blocks.length][];
    double[] costs = new double[blocks.length];
    IntStream.range(0, blocks.length)
        .parallel()
        .forEach(
            k -> {
              blocks[k].factor(0);
              s[k] = blocks[k].reducedMatrix();
              t[k] = blocks[k].reducedGradient();
              costs[k] = blocks[k].reducedCost();
              blocks[k] = null;
            });
    return new ScoreSystem(base, s, t, costs);
  }

  /**
   * The normal equations of a problem where it starts, without solving it: what kicks would tell that nobody has made yet.
   *
   * @param problem with the kicks' own parameters and the global ones where the equations are wanted
   * @param <S> what the global parameters amount to
   * @return the system; its columns are the free global parameters
   */
  public static <S> ScoreSystem at(SharedProblem<S> problem) {
    int[] free = problem.free();
    double[] scatters = problem.randoms().stream().mapToDouble(RandomEffect::scatter).toArray();
    Linearizer<S> linearizer =
        new Linearizer<>(
            problem, List.copyOf(problem.kicks()), problem.starts(), problem.values(), scatters);
    return of(free.length, linearizer.blocks(free, problem.meanColumns(free)));
  }

  /**
   * How many columns belong to the solution itself.
   *
   * @return number of free global parameters
   */
  public int base() {
    return base;
  }

  /**
   * How many columns there are.
   *
   * @return the number of those of the solution and of the probes together, at least {@link #base}
   */
  public int size() {
    return gradient.length;
  }

  /**
   * How many kicks there are.
   *
   * @return their number; kicks are counted from 0
   */
  public int kicks() {
    return perKick.length;
  }

  /**
   * Curvature of half the cost: the second derivative by two columns, to first order in the residuals; symmetric.
   *
   * @param i column, from 0
   * @param j column, from 0
   * @return sum over the kicks, 1 over the product of the columns' units
   */
  public double curvature(int i, int j) {
    return total[i][j];
  }

  /**
   * Downhill slope of half the cost: minus its first derivative by a column.
   *
   * @param i column, from 0
   * @return sum over the kicks, 1 over the column's unit; positive where a larger value explains more
   */
  public double slope(int i) {
    return gradient[i];
  }

  /**
   * Curvature of one kick.
   *
   * @param kick which
   * @param i column
   * @param j column
   * @return its part of {@link #curvature(int, int)}
   */
  public double curvature(int kick, int i, int j) {
    return perKick[kick][i][j];
  }

  /**
   * Slope of one kick.
   *
   * @param kick which
   * @param i column
   * @return its part of {@link #slope(int)}
   */
  public double slope(int kick, int i) {
    return gradients[kick][i];
  }

  /**
   * Covariance of the solution's own parameters in units of the noise's variance: the inverse of their curvature.
   *
   * @param precisions of what is known of each before any data, 1 over its unit squared, {@link #base} numbers, 0 = nothing
   * @return symmetric; empty when the equations are singular
   */
  public Optional<double[][]> inverse(double[] precisions) {
    double[][] h = new double[base][base];
    double[] scale = new double[base];
    for (int i = 0; i < base; i++) {
      System.arraycopy(total[i], 0, h[i], 0, base);
      h[i][i] += precisions[i];
      scale[i] = 1 / Math.sqrt(h[i][i]);
    }
    return ScaledEquations.inverse(h, scale);
  }

  /**
   * What is left of a kick's chi-square, and of what is known of its own parameters, when those follow to first order and everything shared is held.
   *
   * @param kick which
   * @return in units of chi-square
   */
  public double cost(int kick) {
    return costs[kick];
  }
}
