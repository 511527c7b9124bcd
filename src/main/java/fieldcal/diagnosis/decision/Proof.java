package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.fit.joint.ScoreSystem;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.SingularMatrixException;

/** What the kicks prove about one component of a model: whether they agree on it, and how many of them show it. Immutable and thread-safe. */
final class Proof {
  /** Hotelling's test needs more kicks than this times the number of magnitudes; with fewer it has little power. */
  private static final int KICKS_PER_NUMBER = 2;

  /** Curves that take back this share of what a cause does leave no more of it than they take. */
  private static final double TAKEN_BACK = 0.5;

  private final FittedModel model;
  private final int component;
  private final int size;
  private final DecisionSettings settings;

  /**
   * @param model fitted to all kicks
   * @param component index of the component
   * @param settings every number that decides
   */
  Proof(FittedModel model, int component, DecisionSettings settings) {
    this.model = model;
    this.component = component;
    this.settings = settings;
    size = model.model().components().get(component).magnitudeCount();
  }

  /** Whether learned curves undo most of what a cause does: together they are one curve, and the size of either is arbitrary. */
  boolean isTakenBack(Information information) {
    List<Effect> effects = model.effects();
    int[] curves =
        IntStream.range(0, effects.size())
            .filter(j -> effects.get(j) instanceof LearnedTerm)
            .toArray();
    return !(effects.get(component) instanceof LearnedTerm)
        && information.shared(component, curves) < -TAKEN_BACK;
  }

  /** Whether all kicks share its strength. A curve may have too many numbers for the test; held-out kicks must then gain by it. */
  boolean isSteady(double[] gain) {
    return isTestable() ? !isUneven() : gain[HoldOut.LOWER] > 0;
  }

  private boolean isTestable() {
    return model.kickCount() > KICKS_PER_NUMBER * size;
  }

  /** Whether its strength differs so much from kick to kick that its mean over the kicks may be chance: Hotelling's test with the kicks as the sample. */
  boolean isUneven() {
    if (model.solution().covariance().isEmpty() || !isTestable()) {
      return true;
    }
    int left = model.kickCount() - size;
    double f = wald() * left / (size * (model.kickCount() - 1.0));
    return !(f
        > new FDistribution(null, size, left).inverseCumulativeProbability(1 - settings.uneven()));
  }

  /** Whether the kicks have more in common than they differ by. The mean is compared with the scatter and not with its standard error, which may depend on what is known of the ball beforehand. */
  boolean isMostlyMean() {
    double[] values = model.solution().values();
    int from = model.model().offset(component);
    double squares = 0;
    for (int a = from; a < from + size; a++) {
      squares += values[a] * values[a];
    }
    return isTestable() && Math.sqrt(squares / size) > model.scatter(component);
  }

  /** Wald statistic: squared distance of its numbers from zero, in units of their covariance; 0 where this is not known. */
  double wald() {
    Optional<double[][]> covariance = model.solution().covariance();
    if (covariance.isEmpty()) {
      return 0;
    }
    int from = model.model().offset(component);
    double[] values = model.solution().values();
    double[][] v = new double[size][size];
    double[] theta = new double[size];
    for (int a = 0; a < size; a++) {
      theta[a] = values[from + a];
      for (int b = 0; b < size; b++) {
        v[a][b] = covariance.get()[from + a][from + b];
      }
    }
    return quadratic(v, theta);
  }

  /** A squared length in units of a covariance. */
  static double quadratic(double[][] v, double[] x) {
    double[] scale = new double[x.length];
    for (int a = 0; a < x.length; a++) {
      scale[a] = Math.sqrt(v[a][a]);
    }
    double sum = 0;
    try {
      double[][] r = new double[x.length][x.length];
      double[] z = new double[x.length];
      for (int a = 0; a < x.length; a++) {
        z[a] = x[a] / scale[a];
        for (int b = 0; b < x.length; b++) {
          r[a][b] = v[a][b] / (scale[a] * scale[b]);
        }
      }
      double[] solved =
          new LUDecomposition(new Array2DRowRealMatrix(r, false))
              .getSolver()
              .solve(new ArrayRealVector(z, false))
              .toArray();
      for (int a = 0; a < x.length; a++) {
        sum += z[a] * solved[a];
      }
    } catch (SingularMatrixException e) {
      return 0;
    }
    return sum;
  }

  /**
   * Whether the kicks other than the two most informative ones would not show a cause of this size. What counts is the information of each kick and not its gain: a kick that is metres off bends what all kicks share, and then
   * other kicks gain, too.
   */
  boolean isToldByFewKicks(double limit) {
    double[] ones = Weighing.ALIKE.of(model);
    ScoreSystem equations = model.solution().scores(List.of(), ones);
    int from = model.model().offset(component);
    double[] values = model.solution().values();
    double[] told = new double[model.kickCount()];
    for (int a = from; a < from + size; a++) {
      for (int b = from; b < from + size; b++) {
        int row = model.model().freeIndex(a);
        int column = model.model().freeIndex(b);
        for (int k = 0; k < told.length; k++) {
          told[k] += values[a] * equations.curvature(k, row, column) * values[b];
        }
      }
    }
    Arrays.sort(told);
    double others =
        Arrays.stream(told).limit(Math.max(0, told.length - Decision.TOO_FEW_KICKS)).sum();
    return !(others > limit * Math.max(1, model.solution().reducedChiSquare()));
  }

  /** The same for values that each kick has of its own, whose mean may be zero. */
  boolean isGainOfFewKicks(FittedModel without) {
    return model.shareOfMost(without, Decision.TOO_FEW_KICKS) < settings.fewKicks();
  }
}
