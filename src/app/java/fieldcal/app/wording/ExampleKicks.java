package fieldcal.app.wording;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffects;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What an effect makes of a kick: the same kick by the fitted model with the effect and without it, all other causes acting in both. */
final class ExampleKicks {
  /** Elevation of the example chips, rad. */
  private static final double STEEP = Math.PI / 4;

  private final ExtendedModel model;

  ExampleKicks(ExtendedModel model) {
    this.model = model;
  }

  /**
   * Where the effect puts the ball.
   *
   * @param along how much farther than without the effect, along the kick, mm
   * @param left how much to the left, mm
   */
  record Change(double along, double left) {}

  ExtendedModel model() {
    return model;
  }

  /**
   * A flat kick.
   *
   * @param effect on the motion
   * @param x where it begins, m
   * @param y where it begins, m
   * @param speed m/s
   * @param direction rad
   * @param after when to look, s after the kick
   * @return the change; empty when the model knows no flat kicks or the effect is none of the motion
   */
  Optional<Change> flat(
      Effect effect, double x, double y, double speed, double direction, double after) {
    if (model.flat().isEmpty() || !(effect instanceof MotionEffect motion)) {
      return Optional.empty();
    }
    double vx = speed * Math.cos(direction);
    double vy = speed * Math.sin(direction);
    double t = model.sessionStart();
    BallTrajectory with =
        ExtendedTrajectory.flat(model.flat().get(), with(motion), t, t, x, y, vx, vy);
    BallTrajectory without =
        ExtendedTrajectory.flat(model.flat().get(), others(motion), t, t, x, y, vx, vy);
    return Optional.of(change(with, without, t + after, direction));
  }

  /**
   * A chip towards the +x goal, 45° steep.
   *
   * @param effect on the motion
   * @param speed m/s
   * @param after when to look, s after the kick
   * @return the change; empty when the model knows no chips or the effect is none of the motion
   */
  Optional<Change> chip(Effect effect, double speed, double after) {
    if (model.chip().isEmpty() || !(effect instanceof MotionEffect motion)) {
      return Optional.empty();
    }
    double v = speed * Math.cos(STEEP);
    double t = model.sessionStart();
    ChipModel chip = model.chip().get();
    FlatModel flat = model.sliding();
    BallTrajectory with = ExtendedTrajectory.chip(chip, flat, with(motion), t, t, 0, 0, v, 0, v);
    BallTrajectory without =
        ExtendedTrajectory.chip(chip, flat, others(motion), t, t, 0, 0, v, 0, v);
    return Optional.of(change(with, without, t + after, 0));
  }

  private static Change change(
      BallTrajectory with, BallTrajectory without, double time, double direction) {
    BallState a = with.stateAt(time);
    BallState b = without.stateAt(time);
    double dx = 1000 * (a.x() - b.x());
    double dy = 1000 * (a.y() - b.y());
    double cos = Math.cos(direction);
    double sin = Math.sin(direction);
    return new Change(dx * cos + dy * sin, dy * cos - dx * sin);
  }

  private MotionEffects with(MotionEffect effect) {
    List<MotionEffect> all = new ArrayList<>(others(effect).effects());
    all.add(effect);
    return MotionEffects.of(all);
  }

  /** The model's other causes, and those without which the effect does nothing. */
  private MotionEffects others(MotionEffect effect) {
    List<MotionEffect> others = new ArrayList<>();
    for (Effect e : model.effects()) {
      if (e instanceof MotionEffect motion && !e.equals(effect)) {
        others.add(motion);
      }
    }
    for (Effect companion : effect.companions()) {
      boolean lacks = model.effects().stream().noneMatch(e -> e.id().equals(companion.id()));
      if (lacks && companion instanceof MotionEffect motion) {
        others.add(motion);
      }
    }
    return MotionEffects.of(others);
  }
}
