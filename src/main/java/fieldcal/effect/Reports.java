package fieldcal.effect;

/**
 * What cameras report of a ball on a path, and from there of the same ball under other effects on the cameras, and of balls on paths close by. Fits ask for derivatives of a path in a hundred directions: what each camera reports of the path is computed once for all of them. Not thread-safe: derivatives are worked out when first asked for.
 */
public final class Reports {
  /** How far a ball is moved to see by how much its report moves, m: a rounding error of 1e-15 m is 1e-10 of it, and a camera at 4 m bends less. */
  private static final double NUDGE = 1e-5;

  private final MeasurementEffects effects;
  private final Sightings seen;
  private final ExtendedTrajectory path;
  private final double sessionStart;

  /** By which camera each was seen; null where that is not listed. */
  private final View[] views;

  /** Reported x and y of each sighting, m. */
  private final double[] ground;

  /** Where the ball was, x, y and z of each sighting, m. */
  private final double[] balls;

  /** When it was there, s. */
  private final double[] times;

  /** By how much reported x, and y, move with the ball's x, y and z (–); null as long as nobody asks. */
  private double[] slopes;

  /**
   * Works them out.
   *
   * @param effects on the cameras
   * @param seen cameras and times
   * @param path of the ball
   * @param sessionStart when the session began, on the clock of the path, s
   */
  public Reports(
      MeasurementEffects effects, Sightings seen, ExtendedTrajectory path, double sessionStart) {
    this.effects = effects;
    this.seen = seen;
    this.path = path;
    this.sessionStart = sessionStart;
    int n = seen.size();
    views = new View[n];
    ground = new double[2 * n];
    balls = new double[3 * n];
    times = new double[n];
    PathFollower ball = path.follower();
    for (int i = 0; i < n; i++) {
      views[i] = effects.goTo(seen, i, ball, sessionStart);
      times[i] = ball.time();
      balls[3 * i] = ball.x();
      balls[3 * i + 1] = ball.y();
      balls[3 * i + 2] = ball.z();
      place(views[i], i, 0, 0, ground, 2 * i);
    }
  }

  /** Where a camera reports the ball of a sighting, moved over the ground. */
  private void place(View view, int i, double dx, double dy, double[] out, int at) {
    MeasurementEffects.place(
        view,
        balls[3 * i] + dx,
        balls[3 * i + 1] + dy,
        balls[3 * i + 2],
        seen.stamp[i] - sessionStart,
        out,
        at);
  }

  /**
   * What is reported.
   *
   * @param out receives x and y of each sighting in turn, m; NaN where the ball is not below the camera or the stamp is NaN
   */
  public void copyTo(double[] out) {
    System.arraycopy(ground, 0, out, 0, ground.length);
  }

  /**
   * What is reported of the same path under other effects: copied for cameras of which both say the same.
   *
   * @param others made {@linkplain MeasurementEffects#under from these effects}
   * @param out receives x and y of each sighting, m
   */
  public void under(MeasurementEffects others, double[] out) {
    PathFollower ball = path.follower();
    for (int i = 0; i < seen.size(); i++) {
      View other = others.find(seen.camera[i]);
      if (other == views[i]) {
        out[2 * i] = ground[2 * i];
        out[2 * i + 1] = ground[2 * i + 1];
      } else if (other != null && views[i] != null && other.isAsLateAs(views[i])) {
        place(other, i, 0, 0, out, 2 * i);
      } else {
        others.report(seen, i, ball, sessionStart, out);
      }
    }
  }

  /**
   * What is reported of a ball on a path close by, to the first order in how far it is from this one.
   *
   * @param near path that differs by little, as the paths of a difference quotient
   * @param out receives x and y of each sighting, m
   */
  public void near(ExtendedTrajectory near, double[] out) {
    double[] by = slopes();
    PathFollower ball = near.follower();
    for (int i = 0; i < seen.size(); i++) {
      if (views[i] != null && views[i].dependsOnSpeed()) {
        effects.goTo(seen, i, ball, sessionStart);
      } else {
        ball.goTo(times[i]);
      }
      double dx = ball.x() - balls[3 * i];
      double dy = ball.y() - balls[3 * i + 1];
      double dz = ball.z() - balls[3 * i + 2];
      int s = 6 * i;
      out[2 * i] = ground[2 * i] + by[s] * dx + by[s + 1] * dy + by[s + 2] * dz;
      out[2 * i + 1] = ground[2 * i + 1] + by[s + 3] * dx + by[s + 4] * dy + by[s + 5] * dz;
    }
  }

  private double[] slopes() {
    if (slopes == null) {
      slopes = new double[6 * seen.size()];
      double[] moved = new double[2];
      for (int i = 0; i < seen.size(); i++) {
        int s = 6 * i;
        place(views[i], i, NUDGE, 0, moved, 0);
        slopes[s] = (moved[0] - ground[2 * i]) / NUDGE;
        slopes[s + 3] = (moved[1] - ground[2 * i + 1]) / NUDGE;
        place(views[i], i, 0, NUDGE, moved, 0);
        slopes[s + 1] = (moved[0] - ground[2 * i]) / NUDGE;
        slopes[s + 4] = (moved[1] - ground[2 * i + 1]) / NUDGE;
        if (views[i] != null) {
          views[i].addSlopesByHeight(balls, 3 * i, slopes, s);
        }
      }
    }
    return slopes;
  }
}
