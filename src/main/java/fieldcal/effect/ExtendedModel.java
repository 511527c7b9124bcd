package fieldcal.effect;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import java.util.List;
import java.util.Optional;

/**
 * A ball model with what the simple one leaves out: what a team's AI predicts with. Immutable.
 *
 * @param flat how the ball slides and rolls; absent when no flat kick was seen
 * @param chip how it bounces; absent when no chip was seen
 * @param effects all causes with their numbers, of the motion and of the cameras
 * @param sessionStart beginning of the session on the AI's clock, s: the time stamp of the first frame of the first recording that was diagnosed; it matters only for effects that change with time
 */
public record ExtendedModel(
    Optional<FlatModel> flat, Optional<ChipModel> chip, List<Effect> effects, double sessionStart) {

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws IllegalArgumentException when {@code sessionStart} is not finite
   */
  public ExtendedModel {
    effects = List.copyOf(effects);
    EffectParameters.requireFinite("session", sessionStart);
  }

  /**
   * The same model on another clock.
   *
   * @param newSessionStart beginning of the session on that clock, s
   * @return the changed copy
   */
  public ExtendedModel withSessionStart(double newSessionStart) {
    return new ExtendedModel(flat, chip, effects, newSessionStart);
  }

  /**
   * What acts on the ball.
   *
   * @return the effects on the motion, bundled
   */
  public MotionEffects motion() {
    return MotionEffects.of(
        effects.stream()
            .filter(MotionEffect.class::isInstance)
            .map(MotionEffect.class::cast)
            .toList());
  }

  /**
   * How a chip slides after its last impact, where its impacts follow a law of their own.
   *
   * @return the model of flat kicks, or the typical one when no flat kick was seen
   */
  public FlatModel sliding() {
    return flat.orElseGet(FlatModel::typical);
  }

  /**
   * What the cameras do.
   *
   * @return the effects on what cameras report, for {@link MeasurementEffects#of}
   */
  public List<MeasurementEffect> measurement() {
    return effects.stream()
        .filter(MeasurementEffect.class::isInstance)
        .map(MeasurementEffect.class::cast)
        .toList();
  }

  /**
   * The path of a flat kick in the field frame. Kicks spin with the mean of {@code kick_spin} and {@code side_spin}, if there are such effects. What cameras do is not in it, see {@link #measurement}.
   *
   * @param t0 time of the kick on the clock of {@link #sessionStart}, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @return the path
   * @throws IllegalStateException when the model knows no flat kicks
   */
  public ExtendedTrajectory flatPath(double t0, double x, double y, double vx, double vy) {
    FlatModel model = flat.orElseThrow(() -> new IllegalStateException("no model of flat kicks"));
    return ExtendedTrajectory.flat(model, motion(), sessionStart, t0, x, y, vx, vy);
  }

  /**
   * The path of a chip in the field frame, as {@link #flatPath}.
   *
   * @param t0 time of the kick on the clock of {@link #sessionStart}, s
   * @param x place of the kick, m
   * @param y place of the kick, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz velocity right after the kick, m/s, not negative
   * @return the path
   * @throws IllegalStateException when the model knows no chips
   */
  public ExtendedTrajectory chipPath(
      double t0, double x, double y, double vx, double vy, double vz) {
    ChipModel model = chip.orElseThrow(() -> new IllegalStateException("no model of chips"));
    return ExtendedTrajectory.chip(model, sliding(), motion(), sessionStart, t0, x, y, vx, vy, vz);
  }
}
