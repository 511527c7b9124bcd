package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.fit.joint.ScoreSystem;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.SingularMatrixException;

/** What the kicks prove of one component of a model: whether they agree about it, and how many of them show it. Immutable and thread-safe. */
final class Proof {
  /** Hotelling's test needs more kicks than that times the numbers; with fewer it has little power. */
  private static final int KICKS_PER_NUMBER = 2;

  /** A curve that takes back that share of what a cause does leaves less of it than it takes. */
  private static final double TAKEN_BACK = 0.5;

  /** Standard errors that are no chance, as in every verdict. */
  private static final double BEYOND = 2;

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

  /** Whether learned curves undo most of what a cause does: together they are one curve, and its size is a matter of taste. */
  boolean isTakenBack(Information information) {
    List<Effect> effects = model.effects();
    int[] curves =
        IntStream.range(0, effects.size())
            .filter(j -> effects.get(j) instanceof LearnedTerm)
            .toArray();
    return !(effects.get(component) instanceof LearnedTerm)
        && information.shared(component, curves) < -TAKEN_BACK;
  }

  /** Whether all kicks share its strength. A curve may have too many numbers for a test of them; kicks that were held out must then follow it. */
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
    double limit =
        new FDistribution(null, size, model.kickCount() - size)
            .inverseCumulativeProbability(1 - settings.uneven());
    return !(wald() / size > limit);
  }

  /** Whether the kicks have more in common than they differ by. What the mean is certain to be may hang on what is known of the ball, however much it explains. */
  boolean isMostlyMean() {
    double[] values = model.solution().values();
    int from = model.model().offset(component);
    double squares = 0;
    for (int a = from; a < from + size; a++) {
      squares += values[a] * values[a];
    }
    return isTestable() && Math.sqrt(squares / size) > model.scatter(component);
  }

  /** Squared distance of its numbers from zero, in their errors; 0 where these are not known. */
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

  /**
   * Whether it may be the ball and not what it is named after: only what is known of the ball's own law tells the two apart. Neither its mean is two errors from what a sound ball seems to have, nor its scatter two errors of that knowledge: balls may differ from kick to kick by as
   * much as from their textbook.
   */
  boolean isBallItself() {
    Effect effect = model.effects().get(component);
    Optional<Map<String, Double>> errors = model.errors(component);
    if (effect.ballKnowledge().isEmpty() || errors.isEmpty()) {
      return false;
    }
    double imitated = effect.imitatedBy(model.solution().state().flat());
    double scatter = model.scatter(component);
    double sampling = scatter * scatter / model.kickCount();
    return errors.get().entrySet().stream()
        .noneMatch(
            e -> {
              double value = effect.value(e.getKey());
              double nearest =
                  Math.max(Math.min(0, imitated), Math.min(value, Math.max(0, imitated)));
              double error = e.getValue();
              double known = Math.sqrt(Math.max(0, error * error - sampling));
              return Math.abs(value - nearest) > BEYOND * error || scatter > BEYOND * known;
            });
  }

  private static double quadratic(double[][] v, double[] x) {
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
   * Whether the kicks other than the two most informative ones would not show a cause of that size. What counts is what the equations let each kick tell, not by how much it was wrong: a kick that is metres wrong bends what all kicks share, and then
   * others gain, too.
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

  /** The same of values that each kick has of its own, whose mean may be nothing. */
  boolean isGainOfFewKicks(FittedModel without) {
    return model.shareOfMost(without, Decision.TOO_FEW_KICKS) < settings.fewKicks();
  }
}
