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

/** What cameras would have reported of a kick without the effects of a model. Immutable and thread-safe. */
final class EffectCorrection {
  private final MotionEffects motion;
  private final MeasurementEffects cameras;
  private final MeasurementEffects perfectCameras;
  private final double sessionStart;

  EffectCorrection(ExtendedModel model, Collection<ObservedCamera> observers) {
    motion = model.motion();
    cameras = MeasurementEffects.of(observers, model.measurement());
    perfectCameras = MeasurementEffects.of(observers, List.of());
    sessionStart = model.sessionStart();
  }

  /** The detections moved by the simple minus the extended prediction at the fitted unknowns; unchanged when there is no fit. */
  Kick of(Kick kick, KickFit fit) {
    if (fit.failure().isPresent()) {
      return kick;
    }
    BallTrajectory simple = fit.trajectory();
    BallTrajectory extended = extended(fit);
    Observations seen = kick.observations();
    Observations.Builder corrected = new Observations.Builder();
    double[] ball = new double[3];
    double[] without = new double[2];
    double[] with = new double[2];
    for (int i = 0; i < seen.size(); i++) {
      double t = seen.time(i);
      int camera = seen.camera(i);
      simple.positionAt(t, ball);
      perfectCameras.report(camera, ball, without);
      double time = cameras.ballTime(camera, t - sessionStart, seen.pixelY(i)) + sessionStart;
      extended.positionAt(time, ball);
      cameras.report(camera, ball, with);
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

  private ExtendedTrajectory extended(KickFit fit) {
    double t0 = value(fit, "t0");
    double x = value(fit, "x");
    double y = value(fit, "y");
    double vx = value(fit, "vx");
    double vy = value(fit, "vy");
    if (fit.kind() == KickKind.FLAT) {
      FlatModel flat =
          new FlatModel(value(fit, "accSlide"), value(fit, "accRoll"), value(fit, "kSwitch"));
      return ExtendedTrajectory.flat(flat, motion, sessionStart, t0, x, y, vx, vy);
    }
    ChipModel chip =
        new ChipModel(
            value(fit, "dampingXyFirstHop"),
            value(fit, "dampingXyOtherHops"),
            value(fit, "dampingZ"),
            value(fit, "accRoll"));
    double vz = Math.max(0, value(fit, "vz"));
    int flights = fit.statistics().flights();
    return ExtendedTrajectory.chipWithHops(
        chip, motion, sessionStart, t0, x, y, vx, vy, vz, flights);
  }

  private static double value(KickFit fit, String name) {
    return fit.estimate(name).value();
  }
}
