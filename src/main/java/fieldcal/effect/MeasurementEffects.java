package fieldcal.effect;

import java.util.Collection;
import java.util.List;

/**
 * What the cameras of a recording report of a ball under given effects. Immutable; safe for many threads. A camera that is not listed
 * reports balls where they are, at the time of its stamp.
 */
public final class MeasurementEffects {
  /** Cameras with larger ids are searched for; the league counts from 0. */
  private static final int TABLE = 64;

  private final View[] views;

  /** The views by camera id as far as those are small: every residual of every fit asks for one. */
  private final View[] byId;

  private final List<MeasurementEffect> effects;

  /** Largest speed for which time stamps are corrected when the latest time is computed, m/s: a kick of 6.5 m/s, with the errors of cameras. */
  private static final double FASTEST = 8;

  /** Less than half the distance of the knots of a learned curve over the speed (1.3 m/s), m/s. */
  private static final double SPEED_STEP = 0.5;

  /** Whether the time stamps of any camera have an error. */
  private final boolean late;

  private MeasurementEffects(View[] views, List<? extends MeasurementEffect> effects) {
    this.effects = List.copyOf(effects);
    this.views = views;
    byId = new View[TABLE];
    boolean anyLate = false;
    for (View view : views) {
      anyLate |= view.isLate();
      if (view.id >= 0 && view.id < TABLE) {
        byId[view.id] = view;
      }
    }
    late = anyLate;
  }

  /**
   * Effects on cameras. An effect that needs more than is known of a camera (see {@link MeasurementEffect#isApplicable}) is left out for it.
   *
   * @param cameras one each, as published; of two with one id the later one counts
   * @param effects in any order; several of one id add up
   * @return the bundle
   */
  public static MeasurementEffects of(
      Collection<ObservedCamera> cameras, List<? extends MeasurementEffect> effects) {
    View[] views = cameras.stream().map(camera -> new View(camera, effects)).toArray(View[]::new);
    return new MeasurementEffects(views, effects);
  }

  /**
   * The same cameras under other effects. Views that stay the same are kept, so that {@link Reports#under} recognises them.
   *
   * @param others in any order; several of one id add up
   * @return the changed copy, or this where nothing differs
   */
  public MeasurementEffects under(List<? extends MeasurementEffect> others) {
    if (others.equals(effects)) {
      return this;
    }
    View[] changed = new View[views.length];
    for (int i = 0; i < changed.length; i++) {
      changed[i] = views[i].under(others);
    }
    return new MeasurementEffects(changed, others);
  }

  /**
   * What is wrong.
   *
   * @return as given, absent ones included
   */
  public List<MeasurementEffect> effects() {
    return effects;
  }

  /**
   * When the ball was where a camera saw it.
   *
   * @param camera camera id
   * @param stamp the detection's time stamp, s since the beginning of the session
   * @param pixelRow the detection's row in the image, pixels; not above 0 or NaN = unknown, then nothing that depends on the row is corrected
   * @param speed the ball's speed over the ground at the time stamp, m/s; NaN = unknown, then nothing that depends on it is corrected
   * @return session time, s
   */
  public double ballTime(int camera, double stamp, double pixelRow, double speed) {
    View view = find(camera);
    return view == null ? stamp : stamp - view.timeError(stamp, pixelRow, speed);
  }

  /**
   * Where the cameras report a ball, for all sightings of it: what {@link #ballTime} and {@link #report(int, double, double[], double[])} say of each, in less than half the time.
   *
   * @param seen cameras and times
   * @param path of the ball
   * @param sessionStart when the session began, on the clock of the path, s
   * @param ground receives x and y of each sighting in turn, m, so twice {@link Sightings#size} elements; NaN where the ball is not below the camera or the stamp is no number
   */
  public void report(
      Sightings seen, ExtendedTrajectory path, double sessionStart, double[] ground) {
    PathFollower ball = path.follower();
    for (int i = 0; i < seen.size(); i++) {
      report(seen, i, ball, sessionStart, ground);
    }
  }

  /** Where a ball is reported by one sighting; leaves the ball where it was then. */
  void report(Sightings seen, int i, PathFollower ball, double sessionStart, double[] ground) {
    View view = goTo(seen, i, ball, sessionStart);
    place(view, ball.x(), ball.y(), ball.z(), seen.stamp[i] - sessionStart, ground, 2 * i);
  }

  /** Moves a ball to where it was when a sighting saw it; returns the view of that camera, null when it is not listed. */
  View goTo(Sightings seen, int i, PathFollower ball, double sessionStart) {
    View view = find(seen.camera[i]);
    boolean asksForSpeed = view != null && view.dependsOnSpeed();
    double speed = asksForSpeed ? ball.speedAt(seen.stamp[i]) : Double.NaN;
    ball.goTo(ballTime(view, seen, i, sessionStart, speed));
    return view;
  }

  /** Where a camera reports a ball; where it is when the camera is not listed. */
  static void place(
      View view, double x, double y, double z, double stamp, double[] ground, int at) {
    if (view == null) {
      ground[at] = x;
      ground[at + 1] = y;
    } else {
      view.report(x, y, z, stamp, ground, at);
    }
  }

  /**
   * The time up to which {@link #report(Sightings, ExtendedTrajectory, double, double[])} asks for the path.
   *
   * @param seen cameras and times
   * @param sessionStart when the session began, on the clock of the sightings, s
   * @return the latest time at which the ball was where a camera saw it, however fast it was, on the same clock, s; −∞ without sightings
   */
  public double lastBallTime(Sightings seen, double sessionStart) {
    if (!late) {
      return seen.latest;
    }
    double last = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < seen.size(); i++) {
      View view = find(seen.camera[i]);
      if (view == null || !view.dependsOnSpeed()) {
        last = Math.max(last, ballTime(view, seen, i, sessionStart, Double.NaN));
        continue;
      }
      // Its speed is asked for at the stamp.
      last = Math.max(last, seen.stamp[i]);
      for (double speed = 0; speed < FASTEST; speed += SPEED_STEP) {
        last = Math.max(last, ballTime(view, seen, i, sessionStart, speed));
      }
    }
    return last;
  }

  /**
   * Whether all cameras' time stamps have the same errors, so that {@link #lastBallTime} is the same.
   *
   * @param other for the same cameras
   * @return true when they have; false also where the cameras differ
   */
  public boolean isAsLateAs(MeasurementEffects other) {
    if (!late && !other.late) {
      return true;
    }
    boolean same = views.length == other.views.length;
    for (int i = 0; i < views.length && same; i++) {
      same = views[i].id == other.views[i].id && views[i].isAsLateAs(other.views[i]);
    }
    return same;
  }

  private static double ballTime(
      View view, Sightings seen, int i, double sessionStart, double speed) {
    double t = seen.stamp[i];
    boolean late = view != null && view.isLate();
    return late ? t - view.timeError(t - sessionStart, seen.pixelRow[i], speed) : t;
  }

  /**
   * Where a camera reports a ball at an unknown time; what changed at some time during the session has happened, what varies with the session time is left out.
   *
   * @param camera camera id
   * @param ball x, y and height (0 = on the carpet) at {@link #ballTime}, m
   * @param ground receives x and y, m; NaN when the ball is not below the camera
   */
  public void report(int camera, double[] ball, double[] ground) {
    report(camera, Double.NaN, ball, ground);
  }

  /**
   * Where a camera reports a ball.
   *
   * @param camera camera id
   * @param stamp the detection's time stamp, s since the beginning of the session
   * @param ball x, y and height (0 = on the carpet) at {@link #ballTime}, m
   * @param ground receives x and y, m; NaN when the ball is not below the camera
   */
  public void report(int camera, double stamp, double[] ball, double[] ground) {
    place(find(camera), ball[0], ball[1], ball[2], stamp, ground, 0);
  }

  /** Of two with one id the later one counts. */
  View find(int camera) {
    if (camera >= 0 && camera < TABLE) {
      return byId[camera];
    }
    for (int i = views.length - 1; i >= 0; i--) {
      if (views[i].id == camera) {
        return views[i];
      }
    }
    return null;
  }
}
