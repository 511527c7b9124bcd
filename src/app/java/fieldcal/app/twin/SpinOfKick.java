package fieldcal.app.twin;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.motion.KickSpin;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.exception.TooManyEvaluationsException;

/** The whole spin that one kick gave the ball, of flat kicks and chips alike: that with which the extended model's path is as long as the path that was fitted to the kick. */
final class SpinOfKick {
  /** Largest spin that is looked for, in units of rolling spin: what the effect allows. */
  private static final double MOST = 2;

  /** To that the spin is found, in the same unit. */
  private static final double ACCURACY = 1e-4;

  private static final int EVALUATIONS = 60;

  private final ExtendedModel model;
  private final List<Effect> others;

  SpinOfKick(ExtendedModel model) {
    this.model = model;
    others = model.effects().stream().filter(e -> !givesSpin(e)).toList();
  }

  private static boolean givesSpin(Effect effect) {
    return effect instanceof KickSpin
        || effect instanceof LearnedTerm term && term.actsOn().equals("kick");
  }

  /** Empty when kicks give no spin, or none explains the path: of a chip with another number of hops. */
  OptionalDouble of(FittedPath kick) {
    if (others.size() == model.effects().size()) {
      return OptionalDouble.empty();
    }
    BallTrajectory path = kick.path();
    double begin = path.kickTime();
    double at = Math.max(begin, Math.min(path.restTime(), kick.kick().endTime()));
    BallState start = path.stateAt(begin);
    try {
      double spin =
          new BrentSolver(ACCURACY)
              .solve(
                  EVALUATIONS,
                  fraction ->
                      with(kick.kind(), fraction, begin, start).distanceAt(at)
                          - path.distanceAt(at),
                  -MOST,
                  MOST);
      return OptionalDouble.of(spin);
    } catch (MathIllegalArgumentException | TooManyEvaluationsException none) {
      return OptionalDouble.empty();
    }
  }

  private BallTrajectory with(KickKind kind, double fraction, double time, BallState s) {
    List<Effect> effects = new ArrayList<>(others);
    effects.add(new KickSpin(fraction));
    ExtendedModel spun =
        new ExtendedModel(model.flat(), model.chip(), effects, model.sessionStart());
    return kind == KickKind.CHIP
        ? spun.chipPath(time, s.x(), s.y(), s.vx(), s.vy(), s.vz())
        : spun.flatPath(time, s.x(), s.y(), s.vx(), s.vy());
  }
}
