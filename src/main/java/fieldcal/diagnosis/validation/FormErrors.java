package fieldcal.diagnosis.validation;

import fieldcal.ball.Parameter;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.fit.joint.ScoreSystem;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * What the form of a law adds to the errors of its numbers. A law that is right has the same numbers for fast and for slow kicks, for one half of the field and the other, at the beginning and at the end of the session. One whose form is a little wrong has not, and which number a recording gives then depends on its kicks. So the kicks are
 * divided into halves in several ways. Each time and for each number, the score test (Rao 1948) of its difference between the halves estimates by how much each half would move it away from the mean of both, all else being fitted again.
 */
public final class FormErrors {
  /** Chance that any of the divisions makes a difference although the law is right, for each number. */
  private static final double CHANCE = 0.05;

  /** Fewest kicks of a half; chosen: fewer show no scatter. */
  private static final int FEWEST = 4;

  /** A column of which less than that share is left by the others is a combination of them. */
  private static final double COLLINEAR = 1e-9;

  private final ScoreSystem equations;
  private final RealMatrix inverse;
  private final double noise;
  private final int kicks;

  private FormErrors(ScoreSystem equations, RealMatrix inverse, double noise) {
    this.equations = equations;
    this.inverse = inverse;
    this.noise = noise;
    kicks = equations.kicks();
  }

  /**
   * Measures.
   *
   * @param fitted the model, with equal weights
   * @return variance that the form adds to each global parameter, in its unit squared; 0 where the halves do not differ beyond chance, and for parameters that are held
   */
  public static double[] variances(FittedModel fitted) {
    EffectModel model = fitted.model();
    List<Parameter> globals = model.globals();
    double[] variances = new double[globals.size()];
    List<double[]> divisions = divisions(fitted);
    ScoreSystem equations = fitted.solution().scores(List.of(), Weighing.ALIKE.of(fitted));
    double[] precisions = new double[equations.base()];
    for (int g = 0; g < globals.size(); g++) {
      if (globals.get(g).estimated()) {
        precisions[model.freeIndex(g)] = model.priors().get(g).precision();
      }
    }
    Optional<double[][]> inverse = equations.inverse(precisions);
    if (divisions.isEmpty() || inverse.isEmpty()) {
      return variances;
    }
    double noise = Math.max(1, fitted.solution().reducedChiSquare());
    FormErrors errors =
        new FormErrors(equations, new Array2DRowRealMatrix(inverse.get(), false), noise);
    double least =
        new TDistribution(equations.kicks() - 2)
            .inverseCumulativeProbability(1 - 0.5 * CHANCE / divisions.size());
    for (int g = 0; g < variances.length; g++) {
      if (globals.get(g).estimated()) {
        int column = model.freeIndex(g);
        for (double[] half : divisions) {
          variances[g] = Math.max(variances[g], errors.variance(column, half, least));
        }
      }
    }
    return variances;
  }

  /** Divisions of the kicks into halves; each has the sign of every kick's half. */
  private static List<double[]> divisions(FittedModel fitted) {
    List<IntToDoubleFunction> quantities =
        List.of(
            k -> Math.hypot(own(fitted, k)[2], own(fitted, k)[3]),
            k -> own(fitted, k)[2] / Math.hypot(own(fitted, k)[2], own(fitted, k)[3]),
            k -> own(fitted, k)[3] / Math.hypot(own(fitted, k)[2], own(fitted, k)[3]),
            k -> own(fitted, k)[0],
            k -> own(fitted, k)[1],
            k -> fitted.kick(k).sessionTime(own(fitted, k)));
    List<double[]> all = new ArrayList<>();
    for (IntToDoubleFunction quantity : quantities) {
      double[] values = IntStream.range(0, fitted.kickCount()).mapToDouble(quantity).toArray();
      double[] sorted = values.clone();
      Arrays.sort(sorted);
      double median = sorted[sorted.length / 2];
      all.add(DoubleStream.of(values).map(v -> v < median ? -1 : 1).toArray());
    }
    all.add(
        IntStream.range(0, fitted.kickCount())
            .mapToDouble(k -> fitted.kick(k).record().kind() == KickKind.CHIP ? -1 : 1)
            .toArray());
    all.removeIf(
        half -> {
          long upper = DoubleStream.of(half).filter(s -> s > 0).count();
          return Math.min(upper, half.length - upper) < FEWEST;
        });
    return all;
  }

  private static double[] own(FittedModel fitted, int kick) {
    return fitted.solution().own(kick);
  }

  /** The square of what each half would move a number, 0 unless this is beyond chance. */
  private double variance(int column, double[] half, double least) {
    double[] shared = new double[equations.base()];
    for (int k = 0; k < kicks; k++) {
      for (int j = 0; j < shared.length; j++) {
        shared[j] += half[k] * equations.curvature(k, column, j);
      }
    }
    double[] follow = inverse.operate(shared);
    double curvature = equations.curvature(column, column);
    for (int j = 0; j < follow.length; j++) {
      curvature -= shared[j] * follow[j];
    }
    if (!(curvature > COLLINEAR * equations.curvature(column, column))) {
      return 0;
    }
    double[] slopes = new double[kicks];
    for (int k = 0; k < kicks; k++) {
      slopes[k] = half[k] * equations.slope(k, column);
      for (int j = 0; j < follow.length; j++) {
        slopes[k] -= follow[j] * equations.slope(k, j);
      }
    }
    double move = DoubleStream.of(slopes).sum() / curvature;
    double error = Math.sqrt(Math.max(noise * curvature, scatter(slopes, half))) / curvature;
    return Math.abs(move) > least * error ? move * move : 0;
  }

  /** Variance of the sum of what the kicks contribute, from their scatter within each half: the kicks are clusters (Liang and Zeger 1986). */
  private double scatter(double[] slopes, double[] half) {
    double[] sum = new double[2];
    int[] count = new int[2];
    for (int k = 0; k < kicks; k++) {
      int of = half[k] > 0 ? 1 : 0;
      sum[of] += slopes[k];
      count[of]++;
    }
    double squares = 0;
    for (int k = 0; k < kicks; k++) {
      int of = half[k] > 0 ? 1 : 0;
      double deviation = slopes[k] - sum[of] / count[of];
      squares += deviation * deviation;
    }
    return squares * kicks / (kicks - 2);
  }
}
