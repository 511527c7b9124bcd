package fieldcal.fit.joint;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.NonPositiveDefiniteMatrixException;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.univariate.BrentOptimizer;
import org.apache.commons.math3.optim.univariate.SearchInterval;
import org.apache.commons.math3.optim.univariate.UnivariateObjectiveFunction;

/**
 * The restricted likelihood of the scatters of random effects (Patterson and Thompson 1971) on the linearised equations: for every scatter that is asked about, the kicks' own parameters and all shared ones follow to first
 * order and are then integrated over. Alternating between the two instead (EM) all but stands still where a mean and the scatter move together, as those of a spin do along the valley that flat kicks leave between spin and kSwitch.
 */
final class RestrictedLikelihood {
  /** Relative precision of a scatter; its own error is 1/√(2n), a tenth for fifty kicks. */
  private static final double PRECISION = 0.002;

  private static final int MOST_TRIED = 60;

  private final KickBlock[] blocks;
  private final int[] meanColumns;

  /** Distances of each kick's random values from their means, and the scatters that the blocks are tied with. */
  private final double[][] distances;

  private final double[] scatters;

  /** Curvature and downhill slope that the priors of the shared parameters add, and their scales. */
  private final double[] precisions;

  private final double[] slopes;
  private final double[] scales;

  RestrictedLikelihood(
      KickBlock[] blocks,
      int[] meanColumns,
      double[][] distances,
      double[] scatters,
      double[] precisions,
      double[] slopes,
      double[] scales) {
    this.blocks = blocks;
    this.meanColumns = meanColumns;
    this.distances = distances;
    this.scatters = scatters;
    this.precisions = precisions;
    this.slopes = slopes;
    this.scales = scales;
  }

  /**
   * The most likely scatter of one random effect while those of the others are held.
   *
   * @param random which
   * @param at scatters of all
   * @param smallest that may be answered
   * @param largest that may be answered
   * @return its scatter
   */
  double best(int random, double[] at, double smallest, double largest) {
    double[] tried = at.clone();
    double logarithm =
        new BrentOptimizer(PRECISION, PRECISION)
            .optimize(
                GoalType.MINIMIZE,
                new MaxEval(MOST_TRIED),
                new UnivariateObjectiveFunction(
                    l -> {
                      tried[random] = Math.exp(l);
                      return cost(tried);
                    }),
                new SearchInterval(Math.log(smallest), Math.log(largest), Math.log(at[random])))
            .getPoint();
    return Math.exp(logarithm);
  }

  /** Minus twice the logarithm of the restricted likelihood, up to a constant. */
  double cost(double[] tried) {
    int n = scales.length;
    double[][] h = new double[n][n];
    double[] g = slopes.clone();
    double cost = 0;
    for (int k = 0; k < blocks.length; k++) {
      KickBlock block = retied(k, tried);
      double[][] reduced = block.reducedMatrix();
      double[] gradient = block.reducedGradient();
      for (int i = 0; i < n; i++) {
        g[i] += gradient[i];
        for (int j = 0; j < n; j++) {
          h[i][j] += reduced[i][j];
        }
      }
      cost += block.reducedCost() + block.logDeterminant();
    }
    for (double s : tried) {
      cost += 2 * blocks.length * Math.log(s);
    }
    for (int i = 0; i < n; i++) {
      h[i][i] += precisions[i];
    }
    return cost + ofShared(h, g);
  }

  private KickBlock retied(int kick, double[] tried) {
    KickBlock block = blocks[kick].copy();
    int first = block.own - tried.length;
    for (int r = 0; r < tried.length; r++) {
      double change = 1 / (tried[r] * tried[r]) - 1 / (scatters[r] * scatters[r]);
      block.tieToShared(first + r, meanColumns[r], distances[kick][r], change);
    }
    block.factor(0);
    return block;
  }

  /** What the shared parameters add when they follow and are integrated over. */
  private double ofShared(double[][] h, double[] g) {
    int n = g.length;
    if (n == 0) {
      return 0;
    }
    double[][] scaled = SharedSolver.scaled(h, scales);
    RealVector slope = new ArrayRealVector(n);
    for (int i = 0; i < n; i++) {
      scaled[i][i] += SharedSolver.UNDETERMINED;
      slope.setEntry(i, g[i] * scales[i]);
    }
    try {
      CholeskyDecomposition cholesky =
          new CholeskyDecomposition(new Array2DRowRealMatrix(scaled, false), 1e-9, 1e-14);
      double sum = -slope.dotProduct(cholesky.getSolver().solve(slope));
      for (int i = 0; i < n; i++) {
        sum += 2 * Math.log(cholesky.getL().getEntry(i, i));
      }
      return sum;
    } catch (NonPositiveDefiniteMatrixException e) {
      return Double.POSITIVE_INFINITY;
    }
  }
}
