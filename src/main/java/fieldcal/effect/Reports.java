package fieldcal.effect;

/**
 * What cameras report of a ball on a path, and from there of the same ball under other effects on the cameras, and of balls on paths close by. Fits ask for derivatives of a path in a hundred directions: what each camera reports of the path is computed once for all of them. Not thread-safe: derivatives are computed when first asked for.
 */
public final class Reports {
  /** How far a ball is moved to see by how much its report moves, m: a rounding error of 1e-15 m is 1e-10 of it, and a camera at 4 m bends less. */
  private static final double NUDGE = 1e-5;

  private final MeasurementEffects effects;
  private final Sightings seen;
  private final ExtendedTrajectory path;
  private final double sessionStart;

  /** Reported x and y of each sighting, m. */
  private final double[] ground;

  /** Where the ball was, x, y and z of each sighting, m; null as long as nobody asks. */
  private double[] balls;

  /** When it was there, s; NaN where that depends on how fast it was. */
  private double[] times;

  /** By how much reported x, and y, move with the ball's x, y and z (–). */
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
    ground = new double[2 * seen.size()];
    effects.report(seen, path, sessionStart, ground);
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
      if (others.find(seen.camera[i]) == effects.find(seen.camera[i])) {
        out[2 * i] = ground[2 * i];
        out[2 * i + 1] = ground[2 * i + 1];
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
    if (balls == null) {
      prepare();
    }
    PathFollower ball = near.follower();
    for (int i = 0; i < seen.size(); i++) {
      if (Double.isNaN(times[i])) {
        effects.goTo(seen, i, ball, sessionStart);
      } else {
        ball.goTo(times[i]);
      }
      double dx = ball.x() - balls[3 * i];
      double dy = ball.y() - balls[3 * i + 1];
      double dz = ball.z() - balls[3 * i + 2];
      int s = 6 * i;
      out[2 * i] = ground[2 * i] + slopes[s] * dx + slopes[s + 1] * dy + slopes[s + 2] * dz;
      out[2 * i + 1] =
          ground[2 * i + 1] + slopes[s + 3] * dx + slopes[s + 4] * dy + slopes[s + 5] * dz;
    }
  }

  private void prepare() {
    balls = new double[3 * seen.size()];
    times = new double[seen.size()];
    slopes = new double[6 * seen.size()];
    double[] at = new double[3];
    double[] moved = new double[2];
    PathFollower ball = path.follower();
    for (int i = 0; i < seen.size(); i++) {
      View view = effects.goTo(seen, i, ball, sessionStart);
      boolean fixed = view == null || !view.dependsOnSpeed();
      times[i] = fixed ? ball.time() : Double.NaN;
      at[0] = ball.x();
      at[1] = ball.y();
      at[2] = ball.z();
      System.arraycopy(at, 0, balls, 3 * i, 3);
      for (int axis = 0; axis < 3; axis++) {
        at[axis] += NUDGE;
        MeasurementEffects.place(view, at[0], at[1], at[2], seen.stamp[i] - sessionStart, moved, 0);
        at[axis] -= NUDGE;
        slopes[6 * i + axis] = (moved[0] - ground[2 * i]) / NUDGE;
        slopes[6 * i + 3 + axis] = (moved[1] - ground[2 * i + 1]) / NUDGE;
      }
    }
  }
}
