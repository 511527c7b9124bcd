package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.SharedProblem.Prior;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;

/** Linear problems with a known answer: kicks of two own parameters each that share some global ones. */
final class ToyProblem {
  static final int OWN = 2;

  private ToyProblem() {}

  static Parameter parameter(String name, double value, double scale) {
    return new Parameter(name, "", value, scale, -100, 100, true, "test");
  }

  /** Kicks of 12 rows with noise 1; {@code scatter} is that of the first global parameter's value from kick to kick. */
  static List<ToyKick> kicks(int n, double[] truth, double scatter, SplittableRandom random) {
    List<ToyKick> kicks = new ArrayList<>();
    for (int k = 0; k < n; k++) {
      double[][] a = random(OWN, 12, random);
      double[][] b = random(truth.length, 12, random);
      double[] y = new double[12];
      double offset = scatter * random.nextGaussian();
      double[] own = {random.nextGaussian(), random.nextGaussian()};
      for (int i = 0; i < y.length; i++) {
        y[i] = random.nextGaussian() + own[0] * a[0][i] + own[1] * a[1][i] + offset * b[0][i];
        for (int g = 0; g < truth.length; g++) {
          y[i] += truth[g] * b[g][i];
        }
      }
      kicks.add(new ToyKick(y, a, b));
    }
    return kicks;
  }

  private static double[][] random(int columns, int rows, SplittableRandom random) {
    double[][] all = new double[columns][rows];
    for (double[] column : all) {
      for (int i = 0; i < rows; i++) {
        column[i] = random.nextGaussian();
      }
    }
    return all;
  }

  static SharedProblem<double[]> problem(
      List<ToyKick> kicks, List<Parameter> globals, List<Prior> priors) {
    List<double[]> starts = new ArrayList<>();
    kicks.forEach(k -> starts.add(new double[k.ownSize()]));
    double[] weights = new double[kicks.size()];
    Arrays.fill(weights, 1);
    return new SharedProblem<>(double[]::clone, kicks, starts, globals, priors, List.of(), weights);
  }

  static List<Prior> noPriors(int n) {
    return java.util.Collections.nCopies(n, Prior.NONE);
  }

  /** The same with the first global parameter a random effect: its column becomes the kick's own. */
  static SharedProblem<double[]> withRandom(List<ToyKick> kicks, List<Parameter> globals) {
    List<ToyKick> moved = new ArrayList<>();
    List<double[]> starts = new ArrayList<>();
    for (ToyKick kick : kicks) {
      double[][] a = Arrays.copyOf(kick.a, OWN + 1);
      double[][] b = kick.b.clone();
      a[OWN] = b[0];
      b[0] = new double[kick.rows()];
      moved.add(new ToyKick(kick.y, a, b));
      starts.add(new double[OWN + 1]);
    }
    double[] weights = new double[kicks.size()];
    Arrays.fill(weights, 1);
    return new SharedProblem<>(
        double[]::clone,
        moved,
        starts,
        globals,
        noPriors(globals.size()),
        List.of(new RandomEffect(0, 0.5, 1e-3, 10)),
        weights);
  }

  /** All parameters, own ones of each kick first, and their covariance, by the normal equations as a whole. */
  record Dense(double[] values, double[][] covariance, double chiSquare) {
    double[] globals(int n) {
      return Arrays.copyOfRange(values, values.length - n, values.length);
    }
  }

  static Dense dense(List<ToyKick> kicks, int globals, double[] precisions) {
    int size = OWN * kicks.size() + globals;
    double[][] h = new double[size][size];
    double[] g = new double[size];
    for (int k = 0; k < kicks.size(); k++) {
      ToyKick kick = kicks.get(k);
      for (int i = 0; i < kick.rows(); i++) {
        double[] row = row(kick, k, i, size, globals);
        for (int p = 0; p < size; p++) {
          g[p] += row[p] * kick.y[i];
          for (int q = 0; q < size; q++) {
            h[p][q] += row[p] * row[q];
          }
        }
      }
    }
    for (int p = 0; p < globals; p++) {
      h[size - globals + p][size - globals + p] += precisions[p];
    }
    double[][] v =
        new LUDecomposition(new Array2DRowRealMatrix(h)).getSolver().getInverse().getData();
    double[] x = new Array2DRowRealMatrix(v).operate(g);
    double chiSquare = 0;
    for (int k = 0; k < kicks.size(); k++) {
      for (int i = 0; i < kicks.get(k).rows(); i++) {
        double[] row = row(kicks.get(k), k, i, size, globals);
        double r = kicks.get(k).y[i];
        for (int p = 0; p < size; p++) {
          r -= row[p] * x[p];
        }
        chiSquare += r * r;
      }
    }
    return new Dense(x, v, chiSquare);
  }

  private static double[] row(ToyKick kick, int k, int i, int size, int globals) {
    double[] row = new double[size];
    for (int p = 0; p < OWN; p++) {
      row[OWN * k + p] = kick.a[p][i];
    }
    for (int p = 0; p < globals; p++) {
      row[size - globals + p] = kick.b[p][i];
    }
    return row;
  }
}
