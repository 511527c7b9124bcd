package fieldcal.calibration;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.MotionEffects;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/** What cameras would have reported of a kick without the effects of a model. Immutable and thread-safe. */
final class EffectCorrection {
  private final Optional<FlatModel> flat;
  private final Optional<ChipModel> chip;

  /** How a chip slides after its last impact. */
  private final FlatModel sliding;

  private final MotionEffects motion;
  private final MeasurementEffects cameras;
  private final MeasurementEffects perfectCameras;
  private final double sessionStart;

  EffectCorrection(ExtendedModel model, Collection<ObservedCamera> observers) {
    flat = model.flat();
    chip = model.chip();
    sliding = model.sliding();
    motion = model.motion();
    cameras = MeasurementEffects.of(observers, model.measurement());
    perfectCameras = MeasurementEffects.of(observers, List.of());
    sessionStart = model.sessionStart();
  }

  /**
   * The detections moved by the simple minus the extended prediction with the unknowns of a fit.
   *
   * @param kick as seen
   * @param fit of the kick as corrected so far, not a failed one
   * @return the corrected kick
   */
  Kick of(Kick kick, KickFit fit) {
    return fit.kind() == KickKind.FLAT
        ? of(
            kick,
            fit,
            new FlatModel(value(fit, "accSlide"), value(fit, "accRoll"), value(fit, "kSwitch")))
        : of(
            kick,
            fit,
            new ChipModel(
                value(fit, "dampingXyFirstHop"),
                value(fit, "dampingXyOtherHops"),
                value(fit, "dampingZ"),
                value(fit, "accRoll")));
  }

  /**
   * The same with the simple parameters of the extended model, to begin with: those of a fit that knows nothing of the effects may be far off.
   *
   * @param kick as seen
   * @param fit of it, not a failed one
   * @return the corrected kick
   */
  Kick first(Kick kick, KickFit fit) {
    return fit.kind() == KickKind.FLAT
        ? flat.map(m -> of(kick, fit, m)).orElseGet(() -> of(kick, fit))
        : chip.map(m -> of(kick, fit, m)).orElseGet(() -> of(kick, fit));
  }

  private Kick of(Kick kick, KickFit fit, FlatModel m) {
    return moved(kick, flatPath(m, MotionEffects.NONE, fit), flatPath(m, motion, fit));
  }

  private Kick of(Kick kick, KickFit fit, ChipModel m) {
    return moved(kick, chipPath(m, MotionEffects.NONE, fit), chipPath(m, motion, fit));
  }

  private Kick moved(Kick kick, BallTrajectory simple, BallTrajectory extended) {
    Observations seen = kick.observations();
    Observations.Builder corrected = new Observations.Builder();
    double[] ball = new double[3];
    double[] without = new double[2];
    double[] with = new double[2];
    for (int i = 0; i < seen.size(); i++) {
      double t = seen.time(i);
      int camera = seen.camera(i);
      double stamp = t - sessionStart;
      simple.positionAt(t, ball);
      perfectCameras.report(camera, stamp, ball, without);
      double time =
          cameras.ballTime(camera, stamp, seen.pixelY(i), extended.stateAt(t).groundSpeed())
              + sessionStart;
      extended.positionAt(time, ball);
      cameras.report(camera, stamp, ball, with);
      double dx = without[0] - with[0];
      double dy = without[1] - with[1];
      // A ball above the camera has no report; what was seen then was no ball of this path.
      boolean known = Double.isFinite(dx) && Double.isFinite(dy);
      corrected.add(
          t,
          camera,
          seen.x(i) + (known ? dx : 0),
          seen.y(i) + (known ? dy : 0),
          seen.pixelX(i),
          seen.pixelY(i));
    }
    return kick.withObservations(corrected.build());
  }

  private BallTrajectory flatPath(FlatModel m, MotionEffects effects, KickFit fit) {
    return ExtendedTrajectory.flat(
        m,
        effects,
        sessionStart,
        value(fit, "t0"),
        value(fit, "x"),
        value(fit, "y"),
        value(fit, "vx"),
        value(fit, "vy"));
  }

  private BallTrajectory chipPath(ChipModel m, MotionEffects effects, KickFit fit) {
    return ExtendedTrajectory.chipWithHops(
        m,
        sliding,
        effects,
        sessionStart,
        value(fit, "t0"),
        value(fit, "x"),
        value(fit, "y"),
        value(fit, "vx"),
        value(fit, "vy"),
        Math.max(0, value(fit, "vz")),
        fit.statistics().flights());
  }

  private static double value(KickFit fit, String name) {
    return fit.estimate(name).value();
  }
}
