package fieldcal.diagnosis.decision;

import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.ball.Phase;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.effect.BallKnowledge;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.kick.KickKind;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;

/**
 * Whether a value that each kick has may be the ball itself and not what it is named after, where only what is known of the ball's own law distinguishes the two: if its mean is within two errors of what a ball without the cause seems to have, and it scatters no more than it would without the cause. What is not known of the ball's law is the
 * same in all flat kicks, so there it excuses a mean and no scatter beyond that of a few kicks, except that a resistance in the slide is as large as the rolling of each kick. Chips scatter also where the law of their bounces is not quite right, by as much as is not known of the ball. Immutable and thread-safe.
 */
final class BallItself {
  /** Distance that is not due to chance, in standard errors. */
  private static final double BEYOND = 2;

  /** The share of chance within that distance. */
  private static final double WITHIN = 0.9545;

  /**
   * Scatter of what only mechanics distinguishes from the ball's own law that kicks may have for other reasons, in the magnitude's unit: in an engine with a soft contact the ball bobs before it slides, and kicks without spin differed by half a per cent of rolling spin. Twice that.
   */
  private static final double BOBBING = 0.01;

  /** For that long after it began to roll a ball shows the resistance at this place, s: the speed changes by hundredths meanwhile, and a cell of a worn carpet is longer. */
  private static final double ROLLING_SHOWN = 0.1;

  /** Halvings of the time between kick and rest that find where the ball begins to roll: to a microsecond. */
  private static final int HALVINGS = 25;

  private final FittedModel model;
  private final int component;
  private final Effect effect;

  BallItself(FittedModel model, int component) {
    this.model = model;
    this.component = component;
    effect = model.effects().get(component);
  }

  boolean isPossible() {
    Optional<double[][]> covariance = model.solution().covariance();
    Optional<Map<String, Double>> errors = model.errors(component);
    if (effect.ballKnowledge().isEmpty() || covariance.isEmpty() || errors.isEmpty()) {
      return false;
    }
    double modelled = model.scatter(component);
    double sampling = modelled * modelled / model.kickCount();
    double scatter = Math.min(modelled, scatterOfMost());
    for (double error : errors.get().values()) {
      double known = Math.sqrt(Math.max(0, error * error - sampling));
      if (scatter > BEYOND * known) {
        return false;
      }
    }
    return meanIsImitated(covariance.get()) && !flatsScatter();
  }

  /** Whether the magnitudes together are within their errors of a part of what the ball imitates. Kicks of one kind may determine their sum much better than each. */
  private boolean meanIsImitated(double[][] covariance) {
    double[] imitated = effect.imitatedBy(model.solution().state().flat());
    int n = imitated.length;
    int from = model.model().offset(component);
    double[][] errors = new double[n][];
    double[] values = new double[n];
    for (int i = 0; i < n; i++) {
      errors[i] = Arrays.copyOfRange(covariance[from + i], from, from + n);
      values[i] = asBallIsExpected(i, covariance);
    }
    double none = distance(values, imitated, 0, errors);
    double half = distance(values, imitated, 0.5, errors);
    double whole = distance(values, imitated, 1, errors);
    // A parabola over the part that is imitated: none + slope·part + bend·part².
    double bend = 2 * (none - 2 * half + whole);
    double slope = whole - none - bend;
    double part = bend > 0 ? Math.max(0, Math.min(1, -slope / (2 * bend))) : 0;
    double nearest = none + part * (slope + part * bend);
    return nearest <= new ChiSquaredDistribution(n).inverseCumulativeProbability(WITHIN);
  }

  /** Squared distance of the values from a part of what the ball imitates, in units of their covariance. */
  private static double distance(
      double[] values, double[] imitated, double part, double[][] covariance) {
    double[] off = new double[values.length];
    for (int i = 0; i < off.length; i++) {
      off[i] = values[i] - part * imitated[i];
    }
    return Proof.quadratic(covariance, off);
  }

  /** A magnitude if the ball's own parameters were what is known of them: errors of other causes draw both along the line on which they explain the same. */
  private double asBallIsExpected(int magnitude, double[][] covariance) {
    EffectModel described = model.model();
    double[] values = model.solution().values();
    int at = described.offset(component) + magnitude;
    double value = values[at];
    for (BallKnowledge known : effect.ballKnowledge()) {
      for (int g = 0; g < described.globals().size(); g++) {
        Parameter p = described.globals().get(g);
        if (p.name().equals(known.parameter()) && covariance[g][g] > 0) {
          value -= covariance[at][g] / covariance[g][g] * (values[g] - known.mean());
        }
      }
    }
    return value;
  }

  /** By how much the values differ in more than a few kicks. */
  private double scatterOfMost() {
    return KickValues.of(model, component).withoutFarthest(Decision.TOO_FEW_KICKS).scatter();
  }

  /** Whether the values of the flat kicks differ by more than those of kicks without the cause, whether or not the carpet resists the turning of a ball that slides. */
  private boolean flatsScatter() {
    KickValues flats =
        KickValues.of(model, component).of(KickKind.FLAT).withoutFarthest(Decision.TOO_FEW_KICKS);
    int n = flats.kicks().size();
    if (n == 0) {
      return false;
    }
    KickValues resisted = flats.beside(k -> imitated(k.index()));
    double scatter = Math.min(flats.scatter(), resisted.scatter());
    // The standard error of a scatter of n values is its √(2n)th part.
    return scatter * (1 - BEYOND / Math.sqrt(2.0 * n)) > BOBBING;
  }

  /** What a kick's value seems to be if the carpet resists the turning of the sliding ball as it resists its rolling right afterwards. */
  private double imitated(int kick) {
    FlatModel ball = model.solution().state().flat();
    EffectKick seen = model.kick(kick);
    ExtendedTrajectory path = seen.path(model.solution().own(kick), model.solution().state());
    double slides = path.kickTime();
    double rolls = path.restTime();
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (slides + rolls) / 2;
      if (path.phaseAt(middle) == Phase.SLIDING) {
        slides = middle;
      } else {
        rolls = middle;
      }
    }
    double time = Math.min(ROLLING_SHOWN, path.restTime() - rolls);
    if (!(time > 0)) {
      return effect.imitatedBy(ball)[0];
    }
    double lost = path.stateAt(rolls).groundSpeed() - path.stateAt(rolls + time).groundSpeed();
    double accRoll = Math.min(-Double.MIN_NORMAL, -lost / time);
    return effect.imitatedBy(new FlatModel(ball.accSlide(), accRoll, ball.kSwitch()))[0];
  }
}
