package fieldcal.diagnosis.search;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.KickTerm;
import fieldcal.fit.joint.Probe;
import fieldcal.fit.joint.ScoreSystem;
import fieldcal.fit.joint.SharedProblem;
import fieldcal.fit.joint.SharedProblem.Prior;
import fieldcal.fit.joint.SharedSolution;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;

/** A linear regression as the kernel's kicks: each has an intercept of its own, and the same columns; so that commons-math can say what is right. */
final class LinearKicks {
  private static final int KICKS = 4;
  private static final int ROWS = 9;

  /** Columns 0 and 1 are in the model, the others are probes; the last is the sum of two others. */
  static final int COLUMNS = 6;

  static final int BASE = 2;
  private static final double[] TRUTH = {1, -2, 0.5, 0, 0.3, 0};

  private final double[][][] x = new double[KICKS][ROWS][COLUMNS];
  private final double[][] y = new double[KICKS][ROWS];
  private final SharedSolution<double[]> solution;

  LinearKicks(long seed) {
    Random random = new Random(seed);
    for (int k = 0; k < KICKS; k++) {
      for (int r = 0; r < ROWS; r++) {
        y[k][r] = k + random.nextGaussian();
        for (int c = 0; c < COLUMNS; c++) {
          x[k][r][c] = c == COLUMNS - 1 ? x[k][r][2] + x[k][r][3] : random.nextGaussian() + 0.3 * c;
          y[k][r] += TRUTH[c] * x[k][r][c];
        }
      }
    }
    List<Parameter> globals =
        IntStream.range(0, BASE)
            .mapToObj(c -> new Parameter("c" + c, "", 0, 1, -1e6, 1e6, true, "a test's"))
            .toList();
    double[] weights = new double[KICKS];
    Arrays.fill(weights, 1);
    solution =
        SharedSolver.withDefaults()
            .solve(
                new SharedProblem<>(
                    g -> Arrays.copyOf(g, COLUMNS),
                    IntStream.range(0, KICKS).mapToObj(Line::new).toList(),
                    Collections.nCopies(KICKS, new double[1]),
                    globals,
                    Collections.nCopies(BASE, Prior.NONE),
                    List.of(),
                    weights));
  }

  SharedSolution<double[]> solution() {
    return solution;
  }

  /** The equations with all probes. */
  ScoreSystem system() {
    List<Probe<double[]>> probes = new ArrayList<>();
    for (int c = BASE; c < COLUMNS; c++) {
      double[] state = solution.state().clone();
      state[c] += 1;
      probes.add(new Probe<>(null, state, 1));
    }
    double[] weights = new double[KICKS];
    Arrays.fill(weights, 1);
    return solution.scores(probes, weights);
  }

  private OLSMultipleLinearRegression regression(int... columns) {
    double[] values = new double[KICKS * ROWS];
    double[][] design = new double[KICKS * ROWS][KICKS + columns.length];
    for (int k = 0; k < KICKS; k++) {
      for (int r = 0; r < ROWS; r++) {
        int row = k * ROWS + r;
        values[row] = y[k][r];
        design[row][k] = 1;
        for (int c = 0; c < columns.length; c++) {
          design[row][KICKS + c] = x[k][r][columns[c]];
        }
      }
    }
    OLSMultipleLinearRegression ols = new OLSMultipleLinearRegression();
    ols.setNoIntercept(true);
    ols.newSampleData(values, design);
    return ols;
  }

  /** Sum of squares that a regression on some columns leaves. */
  double left(int... columns) {
    return regression(columns).calculateResidualSumOfSquares();
  }

  /** Coefficients of a regression on some columns, in their order. */
  double[] coefficients(int... columns) {
    double[] all = regression(columns).estimateRegressionParameters();
    return Arrays.copyOfRange(all, KICKS, all.length);
  }

  private final class Line implements KickTerm<double[]> {
    private final int kick;

    Line(int kick) {
      this.kick = kick;
    }

    @Override
    public int ownSize() {
      return 1;
    }

    @Override
    public int rows() {
      return ROWS;
    }

    @Override
    public void residuals(double[] own, double[] state, double[] out) {
      for (int r = 0; r < ROWS; r++) {
        out[r] = y[kick][r] - own[0];
        for (int c = 0; c < COLUMNS; c++) {
          out[r] -= x[kick][r][c] * state[c];
        }
      }
    }

    @Override
    public void ownColumns(double[] own, double[] state, double[] residuals, double[][] columns) {
      Arrays.fill(columns[0], 1);
    }

    @Override
    public double ownPrior(int index) {
      return 0;
    }

    @Override
    public double ownPrecision(int index) {
      return 0;
    }
  }
}
