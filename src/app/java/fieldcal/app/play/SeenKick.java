package fieldcal.app.play;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.camera.Camera;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraViews;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;

/**
 * A kick that was made, or may be, and the moments at which cameras see its ball.
 *
 * @param kind flat or chip
 * @param flights of a chip
 * @param start position, velocity and time of the kick; m, m/s, s
 * @param sightings a few of all that there are, each counting for its neighbours as well
 */
record SeenKick(KickKind kind, int flights, double[] start, List<Sighting> sightings) {
  /** Of a recorded kick so many detections are looked at: what tells two causes apart varies slowly along its path. */
  private static final int MOST = 120;

  /** Looks per second at a kick that is not made yet, and how often a camera really looks. */
  private static final double LOOKS = 20;

  private static final double RATE = 70;

  /** Cameras that are so much farther away than the nearest still see the ball, m. */
  private static final double OVERLAP = 0.6;

  /** Longer nobody lets a ball roll, s. */
  private static final double LONGEST = 12;

  /**
   * One look at the ball.
   *
   * @param camera its id
   * @param stamp when, s
   * @param row of the image, pixels; NaN when not known
   * @param weight of the detections that it stands for, 1/m
   */
  record Sighting(int camera, double stamp, double row, double weight) {}

  /**
   * What a kick is to be like.
   *
   * @param kind flat or chip
   * @param time of the kick, s
   * @param x of the ball, m
   * @param y of the ball, m
   * @param direction rad
   * @param speed along the ball's path in space, m/s
   * @param elevation rad
   * @param run how far the ball comes at most, m
   * @param settle how long it rests before, s
   */
  record Plan(
      KickKind kind,
      double time,
      double x,
      double y,
      double direction,
      double speed,
      double elevation,
      double run,
      double settle) {}

  int timeIndex() {
    return start.length - 1;
  }

  /** A kick that a diagnosis looked at. */
  static SeenKick of(KickResiduals kick, ExtendedModel model, CameraViews views) {
    BallTrajectory path = kick.after();
    double t0 = path.kickTime();
    BallState s = path.stateAt(t0);
    double[] start =
        kick.kind() == KickKind.FLAT
            ? new double[] {s.x(), s.y(), s.vx(), s.vy(), t0}
            : new double[] {s.x(), s.y(), s.vx(), s.vy(), Math.max(0, s.vz()), t0};
    Observations seen = kick.kick().observations();
    List<Integer> used = new ArrayList<>();
    for (int i = 0; i < seen.size(); i++) {
      if (kick.used()[i]) {
        used.add(i);
      }
    }
    int stride = 1 + used.size() / MOST;
    List<Sighting> sightings = new ArrayList<>();
    for (int k = 0; k < used.size(); k += stride) {
      int i = used.get(k);
      double weight = Math.sqrt(stride) / views.get(seen.camera(i)).noise();
      sightings.add(new Sighting(seen.camera(i), seen.time(i), seen.pixelY(i), weight));
    }
    int flights = kick.kind() == KickKind.FLAT ? 0 : path(model, start).flights();
    return new SeenKick(kick.kind(), flights, start, sightings);
  }

  /** A kick that is not made yet, as it goes if a model is right. */
  static SeenKick of(
      Plan plan, ExtendedModel model, List<ObservedCamera> observers, CameraViews views) {
    double along = plan.speed * Math.cos(plan.elevation);
    double vx = along * Math.cos(plan.direction);
    double vy = along * Math.sin(plan.direction);
    double vz = plan.speed * Math.sin(plan.elevation);
    double[] start =
        plan.kind == KickKind.FLAT
            ? new double[] {plan.x, plan.y, vx, vy, plan.time}
            : new double[] {plan.x, plan.y, vx, vy, vz, plan.time};
    ExtendedTrajectory path = path(model, start);
    double end = Math.min(plan.time + LONGEST, path.restTime());
    end = Math.min(end, path.timeAtDistance(plan.run).orElse(end));
    List<Sighting> sightings = new ArrayList<>();
    double atRest = Math.sqrt(plan.settle * RATE);
    look(sightings, plan.time - 0.5 * plan.settle, atRest, path, observers, views);
    for (double t = plan.time + 0.5 / LOOKS; t < end; t += 1 / LOOKS) {
      look(sightings, t, Math.sqrt(RATE / LOOKS), path, observers, views);
    }
    return new SeenKick(plan.kind, path.flights(), start, sightings);
  }

  private static ExtendedTrajectory path(ExtendedModel m, double[] s) {
    return s.length == 5
        ? m.flatPath(s[4], s[0], s[1], s[2], s[3])
        : m.chipPath(s[5], s[0], s[1], s[2], s[3], s[4]);
  }

  private static void look(
      List<Sighting> into,
      double t,
      double detections,
      BallTrajectory path,
      List<ObservedCamera> observers,
      CameraViews views) {
    double[] ball = new double[3];
    double[] pixel = new double[2];
    path.positionAt(t, ball);
    double nearest = Double.POSITIVE_INFINITY;
    for (ObservedCamera o : observers) {
      nearest = Math.min(nearest, distance(o, ball));
    }
    for (ObservedCamera o : observers) {
      if (distance(o, ball) <= nearest + OVERLAP) {
        boolean pixels = o.camera().isPresent() && o.camera().get().hasPixels();
        if (pixels) {
          o.camera().get().worldToPixel(ball[0], ball[1], ball[2], pixel);
        }
        double weight = detections / views.get(o.id()).noise();
        into.add(new Sighting(o.id(), t, pixels ? pixel[1] : Double.NaN, weight));
      }
    }
  }

  /** Of a camera without geometry nobody knows what it sees. */
  private static double distance(ObservedCamera observer, double[] ball) {
    return observer
        .camera()
        .map((Camera c) -> Math.hypot(c.positionX() - ball[0], c.positionY() - ball[1]))
        .orElse(Double.POSITIVE_INFINITY);
  }
}
