package fieldcal.diagnosis.model;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.KickSpin;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.fit.joint.KickTermContract;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;

/** Kicks under models with effects, flat and chipped, with a random effect and without. */
class EffectKickTest extends KickTermContract<ModelState> {
  /** Columns look at the mean of a few neighbouring detections, residuals at each: where kick or landing lie between them, that is some per cent of a column (measured: 6.2 % for a chip's vz). */
  private static final double TOLERANCE = 0.1;

  private static final double NOISE = 0.001;
  private static final double KICK_TIME = 0.6;
  private static final FlatModel FLAT = new FlatModel(-3.1, -0.28, 0.65);
  private static final ChipModel CHIP = new ChipModel(0.72, 0.92, 0.5, -0.28);
  private static final List<CameraCalibration> CALIBRATIONS =
      List.of(calibration(0, -2.5), calibration(1, 2.5));
  private static final List<Camera> CAMERAS = CALIBRATIONS.stream().map(Camera::of).toList();

  private static CameraCalibration calibration(int id, double x) {
    // Looks straight down: half a turn about the x axis; t = −R·position.
    return new CameraCalibration(
        id, 1500, 1000, 1200, 0.1, 1, 0, 0, 0, -x, 0, 6, x, 0, 6, 2000, 2400);
  }

  private static CameraViews views() {
    List<CameraView> views = new ArrayList<>();
    for (Camera c : CAMERAS) {
      views.add(CameraView.of(c.id(), Optional.of(c)).withNoise(NOISE));
    }
    return CameraViews.of(views);
  }

  private static KickRecord record(KickKind kind, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    double direction = 0.2 * random.nextDouble() - 0.1;
    double speed = 3 + 2 * random.nextDouble();
    double vx = speed * Math.cos(direction);
    double vy = speed * Math.sin(direction);
    BallTrajectory path =
        kind == KickKind.FLAT
            ? FlatTrajectory.fromKick(FLAT, KICK_TIME, -4, 0, vx, vy)
            : ChipTrajectory.fromKick(CHIP, KICK_TIME, -4, 0, 0.7 * vx, 0.7 * vy, 0.7 * speed);
    Observations.Builder seen = new Observations.Builder();
    double[] at = new double[2];
    for (int i = 0; i < 300; i++) {
      for (Camera c : CAMERAS) {
        double t = i / 70.0 + 0.004 * c.id();
        BallState s = path.stateAt(Math.max(KICK_TIME, t));
        c.worldToPixel(s.x(), s.y(), s.z(), at);
        double u = at[0] + 0.25 * random.nextGaussian();
        double v = at[1] + 0.25 * random.nextGaussian();
        c.pixelToPlane(u, v, 0, at);
        seen.add(t, c.id(), at[0], at[1], u, v);
      }
    }
    Observations all = seen.build();
    Kick kick =
        new Kick(
            1,
            KICK_TIME,
            -4,
            0,
            vx,
            vy,
            Optional.empty(),
            true,
            KickEnd.STOPPED,
            all.time(all.size() - 1),
            all);
    KickFit fit =
        new KickFitter(FitSettings.defaults()).fit(FitProblem.of(kick, views(), FLAT, CHIP), kind);
    boolean[] kept = new boolean[all.size()];
    Arrays.fill(kept, true);
    return new KickRecord(fit, kept, new MovingNoise(views(), 0, 0, 0));
  }

  @Override
  protected List<Case<ModelState>> cases() {
    List<ObservedCamera> observers = new ArrayList<>();
    for (CameraCalibration c : CALIBRATIONS) {
      observers.add(ObservedCamera.of(c, Camera.of(c), CALIBRATIONS.size()));
    }
    EffectModel simple = EffectModel.simple(FLAT, CHIP, true, true, observers);
    Component drag = Component.of(new AirDrag(0.3), List.of("cd"));
    Component offset = Component.of(new CameraOffset(3, -2, 1), List.of("x_mm", "y_mm"));
    Component spin = Component.perKick(new KickSpin(0.1));
    Component apart = Component.perKick(new KickSpin(0.1, -0.3, true));
    List<EffectModel> models =
        List.of(
            simple,
            simple.with(List.of(drag, offset)),
            simple.with(List.of(drag, offset, spin)),
            simple.with(List.of(apart, drag)));
    List<Case<ModelState>> cases = new ArrayList<>();
    for (KickKind kind : KickKind.values()) {
      KickRecord record = record(kind, 5);
      for (EffectModel model : models) {
        EffectKick term = new EffectKick(record, model, 0, new Effort(Long.MAX_VALUE));
        double[] own = Arrays.copyOf(record.start(), term.ownSize());
        if (own.length > record.start().length) {
          own[own.length - 1] = 0.15;
        }
        double[] scales = new double[own.length];
        Arrays.fill(scales, 0, 2, 0.01);
        Arrays.fill(scales, 2, record.timeIndex(), 0.1);
        scales[record.timeIndex()] = 0.005;
        for (int r = 0; r < model.random().size(); r++) {
          scales[record.timeIndex() + 1 + r] = model.random().get(r).coordinates().get(0).scale();
        }
        cases.add(
            new Case<>(
                kind + " under " + model, term, own, scales, model, model.globals(), TOLERANCE));
      }
    }
    return cases;
  }
}
