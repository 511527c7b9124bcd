package fieldcal.app.calibrate;

import fieldcal.app.report.CalibrationReport;
import fieldcal.app.report.FittedPath;
import fieldcal.app.report.Observations;
import fieldcal.app.report.PathEvent;
import fieldcal.app.wording.ParameterWords;
import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatTrajectory;
import fieldcal.ball.Landing;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Sample;
import fieldcal.camera.Camera;
import fieldcal.fit.CameraView;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;

/** Turns one kick of a calibration into what the report shows of it. */
final class KickReportBuilder {
  /** Points of a fitted path; enough for a smooth line. */
  private static final int PATH_POINTS = 90;

  /** Points of a path that is drawn among others; flat kicks and chips run straight over the ground. */
  private static final int OUTLINE_POINTS = 8;

  /** Resting detections shown before the kick, s; more would only press the flight together. */
  private static final double REST_SHOWN = 0.15;

  private final CalibrationOutcome outcome;

  KickReportBuilder(CalibrationOutcome outcome) {
    this.outcome = outcome;
  }

  /** All of a kick. */
  CalibrationReport.Kick kick(CalibratedKick calibrated) {
    KickFit fit = calibrated.fit();
    boolean fitted = fit.failure().isEmpty();
    double t0 = start(fit);
    return kick(
        calibrated,
        seen(fit, t0),
        fitted ? path(fit, t0, PATH_POINTS) : FittedPath.NONE,
        fitted ? events(fit.trajectory(), t0, fit.kick().endTime()) : List.of());
  }

  /** A kick without its observations. */
  CalibrationReport.Kick outline(CalibratedKick calibrated) {
    KickFit fit = calibrated.fit();
    FittedPath path =
        fit.failure().isEmpty() ? path(fit, start(fit), OUTLINE_POINTS) : FittedPath.NONE;
    return kick(calibrated, List.of(), path, List.of());
  }

  private static double start(KickFit fit) {
    return fit.failure().isEmpty() ? fit.estimate("t0").value() : fit.kick().time();
  }

  private CalibrationReport.Kick kick(
      CalibratedKick calibrated, List<Observations> seen, FittedPath path, List<PathEvent> events) {
    KickFit fit = calibrated.fit();
    Kick kick = fit.kick();
    boolean fitted = fit.failure().isEmpty();
    return new CalibrationReport.Kick(
        kick.id(),
        fit.kind() == KickKind.FLAT ? CalibrationReport.Kind.FLAT : CalibrationReport.Kind.CHIP,
        outcome.data().sources().get(kick.id()),
        outcome.kickTime(fit),
        kick.robot().map(r -> r.team().name().toLowerCase(Locale.ROOT)).orElse(""),
        kick.robot().map(r -> r.number()).orElse(-1),
        kick.end().id(),
        kick.observations().size(),
        fitted ? fit.statistics().observations() - fit.statistics().used() : 0,
        fit.rmsMm(),
        fitted ? fit.estimate("x").value() : kick.x(),
        fitted ? fit.estimate("y").value() : kick.y(),
        fitted ? fit.estimate("vx").value() : kick.vx(),
        fitted ? fit.estimate("vy").value() : kick.vy(),
        fitted && fit.kind() == KickKind.CHIP ? fit.estimate("vz").value() : 0,
        fit.modelEstimates().stream()
            .filter(e -> e.parameter().estimated())
            .map(e -> parameter(e, calibrated.samples()))
            .toList(),
        calibrated.selected(),
        calibrated.rejected().map(ParameterWords::spelledOut).orElse(""),
        seen,
        path,
        events);
  }

  private static CalibrationReport.KickParameter parameter(Estimate e, List<Sample> samples) {
    if (e.usable()) {
      String dropped =
          samples.stream()
              .filter(s -> s.parameter().equals(e.name()))
              .findFirst()
              .flatMap(Sample::dropped)
              .map(ParameterWords::spelledOut)
              .orElse("");
      return new CalibrationReport.KickParameter(
          e.name(), e.value(), e.standardError(), "", dropped);
    }
    String reason = e.undetermined().orElse("the estimate reached its bound");
    return new CalibrationReport.KickParameter(e.name(), Double.NaN, Double.NaN, reason, "");
  }

  private List<Observations> seen(KickFit fit, double t0) {
    List<Observations> all = new ArrayList<>();
    for (int camera : fit.kick().observations().cameras()) {
      all.add(seenBy(camera, fit, t0));
    }
    return all;
  }

  private Observations seenBy(int camera, KickFit fit, double t0) {
    fieldcal.kick.Observations o = fit.kick().observations();
    int[] index =
        java.util.stream.IntStream.range(0, o.size())
            .filter(i -> o.camera(i) == camera && o.time(i) >= t0 - REST_SHOWN)
            .toArray();
    boolean fitted = fit.failure().isEmpty();
    double[] t = new double[index.length];
    double[] x = new double[index.length];
    double[] y = new double[index.length];
    double[] rx = new double[index.length];
    double[] ry = new double[index.length];
    boolean[] used = new boolean[index.length];
    CameraView view = outcome.calibration().cameras().get(camera);
    for (int k = 0; k < index.length; k++) {
      int i = index[k];
      t[k] = o.time(i) - t0;
      x[k] = o.x(i) - view.offsetX();
      y[k] = o.y(i) - view.offsetY();
      rx[k] = fitted ? 1000 * fit.residualX(i) : Double.NaN;
      ry[k] = fitted ? 1000 * fit.residualY(i) : Double.NaN;
      used[k] = !fitted || fit.used(i);
    }
    return new Observations(
        camera, t, x, y, rx, ry, heights(fit, view.camera(), o, index, x, y), used);
  }

  /** Height at which the camera's ray passes the fitted path over the ground; only chips have one. */
  private static double[] heights(
      KickFit fit,
      Optional<Camera> camera,
      fieldcal.kick.Observations o,
      int[] index,
      double[] x,
      double[] y) {
    if (fit.failure().isPresent() || fit.kind() == KickKind.FLAT || camera.isEmpty()) {
      return new double[0];
    }
    double[] height = new double[index.length];
    double[] at = new double[3];
    Camera c = camera.get();
    for (int k = 0; k < height.length; k++) {
      fit.trajectory().positionAt(o.time(index[k]), at);
      double gx = x[k] - c.positionX();
      double gy = y[k] - c.positionY();
      double px = at[0] - c.positionX();
      double py = at[1] - c.positionY();
      // The ray is at p = g·(1 − z/H); z where it comes nearest to the point above which the ball
      // is.
      height[k] = c.heightAboveBallPlane() * (1 - (px * gx + py * gy) / (gx * gx + gy * gy));
    }
    return height;
  }

  private static FittedPath path(KickFit fit, double t0, int points) {
    BallTrajectory path = fit.trajectory();
    double end = Math.min(fit.kick().endTime(), path.restTime() + 0.3);
    TreeSet<Double> times = new TreeSet<>();
    for (int k = 0; k <= points; k++) {
      times.add(t0 + (end - t0) * k / points);
    }
    for (PathEvent event : events(path, t0, end)) {
      times.add(t0 + event.t());
    }
    times.add(t0 - REST_SHOWN);
    int n = times.size();
    double[][] columns = new double[5][n];
    int k = 0;
    for (double t : times) {
      BallState s = path.stateAt(t);
      columns[0][k] = t - t0;
      columns[1][k] = s.x();
      columns[2][k] = s.y();
      columns[3][k] = s.z();
      columns[4][k++] = s.groundSpeed();
    }
    return new FittedPath(columns[0], columns[1], columns[2], columns[3], columns[4]);
  }

  private static List<PathEvent> events(BallTrajectory path, double t0, double end) {
    List<PathEvent> events = new ArrayList<>();
    if (path instanceof ChipTrajectory chip) {
      for (Landing landing : chip.landings()) {
        add(events, PathEvent.Type.LANDING, landing.time(), t0, end, path);
      }
    } else if (path instanceof FlatTrajectory flat) {
      add(events, PathEvent.Type.ROLLING, flat.tSwitch(), t0, end, path);
    }
    add(events, PathEvent.Type.STOP, path.restTime(), t0, end, path);
    return events;
  }

  private static void add(
      List<PathEvent> events,
      PathEvent.Type type,
      double time,
      double t0,
      double end,
      BallTrajectory path) {
    if (time <= end) {
      BallState at = path.stateAt(time);
      events.add(new PathEvent(type, time - t0, at.x(), at.y()));
    }
  }
}
