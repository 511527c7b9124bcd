package fieldcal.simulation;

import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.physics.BallIntegrator;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.BallTrace;
import fieldcal.simulation.truth.KickTruth;
import java.util.List;
import org.apache.commons.math3.analysis.UnivariateFunction;
import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.exception.TooManyEvaluationsException;

/**
 * What the ball of one simulated field gets wrong of the kicks of another, by the simulator's own physics, of which no model of fieldcal knows. The predictor sees a kick for {@link #SEEN}, with the place,
 * the speed and the direction that the ball then has, as {@code compare} has it (docs/compare.md).
 */
public final class TruePrediction {
  private static final double SEEN = 0.3;
  private static final double AHEAD = 1;
  private static final double ACCURACY = 1e-6;
  private static final int EVALUATIONS = 100;

  /** The predictor's kick may have been so much slower or faster. */
  private static final double FACTOR = 2;

  private final SimulationSettings field;
  private final List<KickTruth> kicks;

  /**
   * The kicks of a field.
   *
   * @param field where they were made
   * @param kicks what happened
   */
  public TruePrediction(SimulationSettings field, List<KickTruth> kicks) {
    this.field = field;
    this.kicks = List.copyOf(kicks);
  }

  /**
   * Distance between the predicted and the true position 1 s after the prediction.
   *
   * @param other the field whose ball the predictor knows
   * @return root mean square over the kicks that last so long, m; NaN without any
   */
  public double error(SimulationSettings other) {
    double sum = 0;
    int n = 0;
    for (KickTruth kick : kicks) {
      if (kick.duration() >= SEEN + AHEAD) {
        sum += squared(other, kick);
        n++;
      }
    }
    return Math.sqrt(sum / n);
  }

  private double squared(SimulationSettings other, KickTruth kick) {
    BallBody seen = flown(field, kick, 1, SEEN);
    BallBody right = flown(field, kick, 1, SEEN + AHEAD);
    double factor = factor(f -> flown(other, kick, f, SEEN).groundSpeed() - seen.groundSpeed());
    BallBody known = flown(other, kick, factor, SEEN);
    BallBody then = flown(other, kick, factor, SEEN + AHEAD);
    double turn = Math.atan2(seen.vy(), seen.vx()) - Math.atan2(known.vy(), known.vx());
    double dx = then.x() - known.x();
    double dy = then.y() - known.y();
    double ex = seen.x() + Math.cos(turn) * dx - Math.sin(turn) * dy - right.x();
    double ey = seen.y() + Math.sin(turn) * dx + Math.cos(turn) * dy - right.y();
    return ex * ex + ey * ey;
  }

  private static double factor(UnivariateFunction faster) {
    try {
      return new BrentSolver(ACCURACY).solve(EVALUATIONS, faster, 1 / FACTOR, FACTOR, 1);
    } catch (MathIllegalArgumentException | TooManyEvaluationsException none) {
      return 1;
    }
  }

  /** The ball some time after the kick, with a field's mean spin. */
  private static BallBody flown(SimulationSettings at, KickTruth kick, double factor, double time) {
    BallPhysics physics = Effects.physics(at.physics(), at.effects());
    KickBehaviour kicker = Effects.kicks(at.kickBehaviour(), at.effects());
    double vx = factor * kick.velocity().x();
    double vy = factor * kick.velocity().y();
    BallBody ball = new BallBody();
    ball.place(kick.position().x(), kick.position().y());
    ball.kick(
        vx,
        vy,
        kick.velocity().z(),
        kicker.rollSpinOf(Math.hypot(vx, vy), Math.atan2(vy, vx), kick.velocity().z() > 0),
        kicker.sideSpin(),
        physics.ball().radius());
    new BallIntegrator(physics).advance(ball, kick.time(), kick.time() + time, BallTrace.NONE);
    return ball;
  }
}
