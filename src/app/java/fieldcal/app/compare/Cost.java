package fieldcal.app.compare;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.effect.ExtendedModel;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiFunction;
import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.exception.TooManyEvaluationsException;

/**
 * What an AI that was tuned on the simulator gets wrong of the field's kicks. It knows where the ball is, how fast and in which direction it moves 0.3 s after the kick, and predicts on with its own
 * model; the truth is the path that the field's model was fitted to the kick with.
 */
final class Cost {
  /** What the prediction may see of a kick, s; as the diagnosis holds out. */
  private static final double SEEN = 0.3;

  private static final double[] HORIZONS = {0.5, 1, 2};

  /** The horizon that shares are of, s. */
  static final double SHARE_HORIZON = 1;

  /** Speed of the pass of the verdict, m/s. */
  static final double PASS = 5;

  /** To that a kick's speed is found, m/s. */
  private static final double ACCURACY = 1e-6;

  private static final int EVALUATIONS = 100;

  /** The ball may have been kicked so much slower or faster than the field's model says. */
  private static final double FACTOR = 2;

  private final List<KickResiduals> kicks;
  private final ExtendedModel real;

  Cost(List<KickResiduals> kicks, ExtendedModel real) {
    this.kicks = kicks;
    this.real = real;
  }

  /** A pass along x from the centre at the beginning of the session: how far it rolls, m; NaN when the model knows no flat kicks. */
  static double pass(ExtendedModel model) {
    return model.flat().isEmpty()
        ? Double.NaN
        : model.flatPath(model.sessionStart(), 0, 0, PASS, 0).restDistance();
  }

  /** Distance between predicted and true position, root mean square over the kicks that were observed so long, m, by horizon in s. */
  Map<Double, Double> errors(ExtendedModel model) {
    ExtendedModel here = model.withSessionStart(real.sessionStart());
    Map<Double, Double> errors = new TreeMap<>();
    for (double horizon : HORIZONS) {
      List<Double> squares = new ArrayList<>();
      for (KickResiduals kick : kicks) {
        double from = kick.after().kickTime() + SEEN;
        if (kick.kick().endTime() >= from + horizon && knows(here, kick.kind())) {
          squares.add(squared(here, kick, from, from + horizon));
        }
      }
      if (!squares.isEmpty()) {
        errors.put(
            horizon, Math.sqrt(squares.stream().mapToDouble(s -> s).average().orElse(Double.NaN)));
      }
    }
    return errors;
  }

  private static boolean knows(ExtendedModel model, KickKind kind) {
    return kind == KickKind.CHIP ? model.chip().isPresent() : model.flat().isPresent();
  }

  private double squared(ExtendedModel model, KickResiduals kick, double from, double to) {
    double begin = kick.after().kickTime();
    BallState start = kick.after().stateAt(begin);
    BiFunction<ExtendedModel, Double, BallTrajectory> paths =
        (m, factor) -> path(m, kick.kind(), begin, start, factor);
    // The field's own model from the same start: what else its kick's fit knows, such as the
    // spin of this kick, is not the simulator's fault.
    BallTrajectory truth = paths.apply(real, 1.0);
    BallState seen = truth.stateAt(from);
    BallTrajectory guess = paths.apply(model, factor(model, paths, from, seen));
    BallState known = guess.stateAt(from);
    double turn = Math.atan2(seen.vy(), seen.vx()) - Math.atan2(known.vy(), known.vx());
    BallState then = guess.stateAt(to);
    double dx = then.x() - known.x();
    double dy = then.y() - known.y();
    double x = seen.x() + Math.cos(turn) * dx - Math.sin(turn) * dy;
    double y = seen.y() + Math.sin(turn) * dx + Math.cos(turn) * dy;
    BallState right = truth.stateAt(to);
    double ex = x - right.x();
    double ey = y - right.y();
    return ex * ex + ey * ey;
  }

  private static BallTrajectory path(
      ExtendedModel m, KickKind kind, double time, BallState s, double factor) {
    return kind == KickKind.CHIP
        ? m.chipPath(time, s.x(), s.y(), factor * s.vx(), factor * s.vy(), Math.max(0, s.vz()))
        : m.flatPath(time, s.x(), s.y(), factor * s.vx(), factor * s.vy());
  }

  /** By what the kick's speed must be multiplied so that the model has the seen speed when it was seen. */
  private static double factor(
      ExtendedModel model,
      BiFunction<ExtendedModel, Double, BallTrajectory> paths,
      double from,
      BallState seen) {
    double speed = Math.hypot(seen.vx(), seen.vy());
    try {
      return new BrentSolver(ACCURACY)
          .solve(
              EVALUATIONS,
              f -> {
                BallState s = paths.apply(model, f).stateAt(from);
                return Math.hypot(s.vx(), s.vy()) - speed;
              },
              1 / FACTOR,
              FACTOR,
              1);
    } catch (MathIllegalArgumentException | TooManyEvaluationsException none) {
      // No kick of this model is so fast then: it is taken as it started.
      return 1;
    }
  }
}
