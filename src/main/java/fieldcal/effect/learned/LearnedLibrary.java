package fieldcal.effect.learned;

import fieldcal.camera.Camera;
import fieldcal.effect.Arena;
import fieldcal.effect.ObservedCamera;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The families of smooth terms that a recording is searched for. Only the lateness over the speed, the maps, and what takes a camera's place have a constant part: elsewhere it is a parameter of the simple model or of a named effect (camera offset,
 * time offset).
 */
public final class LearnedLibrary {
  /** Knots of a curve, of a place along x and along y; chosen small: a term is a shape, no fit of noise. */
  private static final int KNOTS = 6;

  /** Knots of the shortest curve that has a slope, a curvature and a turn: with more it would cost more than what it shows of another law's form. */
  private static final int KNOTS_FORM = 4;

  /** Knots over the speed of what brakes the ball, 0.5 m/s apart: friction that rises before the ball stops (Stribeck) does so below 1 m/s. */
  private static final int KNOTS_SPEED = 14;

  private static final int KNOTS_X = 4;
  private static final int KNOTS_Y = 3;

  /** Knots over the session; a session of an hour is divided into pieces of a quarter. */
  private static final int KNOTS_TIME = 5;

  /** Harmonics of an angle: slope, nap, a preferred axis, and the square weave of a carpet or the friction box of a physics engine, which repeat every quarter turn. */
  private static final int HARMONICS = 4;

  /** What repeats every quarter turn: boxes and pyramids, of whose mean square three harmonics leave a sixth across the slip and less along it. */
  private static final Basis QUARTERS = new Harmonics(3, 0.5 * Math.PI);

  /** Degree of a lens' or pose's error over the place. */
  private static final int DEGREE = 3;

  /** How far a ball rolls during one turn, m: its circumference. */
  private static final double TURN = 2 * Math.PI * Camera.BALL_RADIUS;

  /** How far a ball rolls, m: the diagonal of a field of 9 m × 6 m. */
  private static final double FARTHEST = 11;

  /** Impacts from the second on that are distinguished; chosen, because later hops are millimetres high. */
  private static final int HOPS = 3;

  /** How far to each side a camera sees per height above the field; one at 4 m sees a quarter of a field of 12 m × 9 m, ±3 m, and with one camera ±6 m from 6 m; rounded up. */
  private static final double VIEW_PER_HEIGHT = 1.2;

  /** Knots of stripes, m apart: two for each roll of carpet, the narrowest of which are 2 m wide. */
  private static final double STRIPE = 1;

  /** Knots of stripes at most: the longest field has 12 m and a margin. */
  private static final int MOST_STRIPES = 16;

  /** Distance of a map's knots, m: what robots wear is some robots wide (0.18 m), and with closer knots hardly two of twenty kicks would cross the same. */
  private static final double MAP_SPACING = 0.75;

  /** Speed below which a ball is about to stop, m/s, and knots up to there, as far apart as those of what brakes the ball: half of what a ball rolls with after a pass. */
  private static final double SLOW = 2;

  private static final int KNOTS_SLOW = 5;

  /** Knots of a map at most: with more the knots of a large field are farther apart. */
  private static final int MOST_MAP_KNOTS = 120;

  /** Narrowest range of a place or time, so that a curve exists, m and s; chosen. */
  private static final double NARROWEST = 1;

  private LearnedLibrary() {}

  /**
   * How far the variables reach in a recording. A curve is constant beyond.
   *
   * @param speed fastest kick, m/s
   * @param slip largest slip, m/s
   * @param time longest time since a kick, s
   * @param verticalSpeed fastest impact, m/s
   * @param groundSpeed fastest chip over the ground, m/s
   */
  public record Ranges(
      double speed, double slip, double time, double verticalSpeed, double groundSpeed) {

    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is not positive and finite
     */
    public Ranges {
      for (double end : new double[] {speed, slip, time, verticalSpeed, groundSpeed}) {
        Basis.requireRange("range", 0, end);
      }
    }

    /**
     * What the league's rules allow: kicks of 6.5 m/s, and a faster slip for a ball with backspin. Few balls roll for longer than 8 s.
     *
     * @return the ranges
     */
    public static Ranges typical() {
      return new Ranges(6.5, 8, 8, 5, 5);
    }
  }

  /**
   * All families with what the rules allow.
   *
   * @param arena what was recorded
   * @return absent terms that can show in the recording
   */
  public static List<LearnedTerm> of(Arena arena) {
    return of(arena, Ranges.typical());
  }

  /**
   * All families.
   *
   * @param arena what was recorded
   * @param ranges how far the variables reach
   * @return absent terms that can show in the recording, one per family
   */
  public static List<LearnedTerm> of(Arena arena, Ranges ranges) {
    List<LearnedFamily> all = new ArrayList<>();
    ground(arena, ranges, all);
    impact(arena, ranges, all);
    all.add(LearnedFamily.of(Quantity.SPIN, Variable.SPEED, curve(0, ranges.speed(), KNOTS)));
    all.add(LearnedFamily.of(Quantity.SPIN, Variable.HEADING, Harmonics.ofAngle(HARMONICS)));
    for (ObservedCamera camera : arena.cameras()) {
      camera(arena, camera, ranges, all);
    }
    return all.stream().map(LearnedFamily::absent).filter(term -> term.canShowIn(arena)).toList();
  }

  /**
   * How the rolling deceleration changes while the ball comes to rest, for a search among named causes: the simple model has it constant down to the stop, which neither a carpet's pile (Stribeck) nor the contacts of a physics engine do. What changes it everywhere, as the speed, a worn region or
   * the pile's direction, changes this, too, and above this range only such causes act, so that the curve takes nothing from them.
   *
   * @return absent terms
   */
  public static List<LearnedTerm> stopping() {
    Basis slow = curve(0, SLOW, KNOTS_SLOW);
    return List.of(LearnedFamily.of(Quantity.ROLLING, Variable.SPEED, slow).absent());
  }

  /**
   * Families of the rolling deceleration alone, for the place of a rolling deceleration that differs from kick to kick. They are not among {@link #of(Arena)}: beside friction and braking a search could hardly distinguish them.
   *
   * @param arena what was recorded
   * @return absent terms that can show in the recording
   */
  public static List<LearnedTerm> ofRolling(Arena arena) {
    Basis speed = curve(0, Ranges.typical().speed(), KNOTS_SPEED);
    return Stream.of(
            LearnedFamily.of(Quantity.ROLLING, Variable.SESSION_TIME, session(arena)),
            LearnedFamily.of(Quantity.ROLLING, Variable.SPEED, speed),
            LearnedFamily.of(Quantity.ROLLING, Variable.HEADING, Harmonics.ofAngle(HARMONICS)),
            LearnedFamily.of(Quantity.ROLLING, Variable.PLACE, place(arena)))
        .map(LearnedFamily::absent)
        .filter(term -> term.canShowIn(arena))
        .toList();
  }

  /**
   * Short curves and coarse maps that differ from a named cause only in their form: a law of the ground of a few numbers, a floor that is not even, a camera whose error is any smooth function of the place or whose lateness depends on the speed. Longer curves would need more evidence than such a difference gives.
   *
   * @param arena what was recorded
   * @return absent terms that can show in the recording
   */
  public static List<LearnedTerm> forms(Arena arena) {
    Basis speed = curve(0, Ranges.typical().speed(), KNOTS_FORM);
    List<LearnedFamily> all = new ArrayList<>();
    all.add(LearnedFamily.of(Quantity.ROLLING, Variable.SPEED, speed));
    all.add(LearnedFamily.of(Quantity.FLOOR, Variable.PLACE, place(arena)));
    Basis lateness = new Spline(0, Ranges.typical().speed(), KNOTS_FORM, false);
    for (ObservedCamera camera : arena.cameras()) {
      ofImage(camera, arena, false).ifPresent(all::add);
      all.add(LearnedFamily.of(Quantity.TIME_ERROR, Variable.SPEED, lateness, camera.id()));
    }
    return all.stream().map(LearnedFamily::absent).filter(term -> term.canShowIn(arena)).toList();
  }

  /**
   * Maps of the carpet, for what curves leave: what is worn in lanes, rings or patches. They are not among {@link #of(Arena)}: they have many functions, each of which reaches only a few knots far, so a search of them alone is fast.
   *
   * @param arena what was recorded
   * @return absent terms
   */
  public static List<LearnedTerm> maps(Arena arena) {
    double[] x = wide(arena.x0(), arena.x1());
    double[] y = wide(arena.y0(), arena.y1());
    double field = (x[1] - x[0]) * (y[1] - y[0]);
    double spacing = Math.max(MAP_SPACING, Math.sqrt(field / MOST_MAP_KNOTS));
    Basis map = new Surface(mapped(x, spacing), mapped(y, spacing), false);
    return Stream.of(Quantity.FRICTION, Quantity.ACCELERATION_ALONG, Quantity.FLOOR)
        .map(q -> LearnedFamily.of(q, Variable.PLACE, map).absent())
        .toList();
  }

  private static Spline mapped(double[] range, double spacing) {
    int knots = (int) Math.round((range[1] - range[0]) / spacing) + 1;
    return new Spline(range[0], range[1], Math.max(KNOTS_Y, knots), false);
  }

  private static void ground(Arena arena, Ranges ranges, List<LearnedFamily> all) {
    Quantity along = Quantity.ACCELERATION_ALONG;
    Quantity across = Quantity.ACCELERATION_ACROSS;
    Basis speed = curve(0, ranges.speed(), KNOTS);
    Basis heading = Harmonics.ofAngle(HARMONICS);
    all.add(LearnedFamily.of(along, Variable.SPEED, curve(0, ranges.speed(), KNOTS_SPEED)));
    all.add(LearnedFamily.of(along, Variable.SLIP, curve(0, ranges.slip(), KNOTS)));
    all.add(LearnedFamily.of(along, Variable.TIME_SINCE_KICK, curve(0, ranges.time(), KNOTS)));
    all.add(LearnedFamily.of(along, Variable.SESSION_TIME, session(arena)));
    all.add(LearnedFamily.of(along, Variable.HEADING, heading));
    all.add(LearnedFamily.of(along, Variable.PLACE, place(arena)));
    all.add(LearnedFamily.of(along, Variable.DISTANCE_ROLLED, new Harmonics(1, TURN)));
    all.add(LearnedFamily.of(along, Variable.DISTANCE_ROLLED, curve(0, FARTHEST, KNOTS)));
    all.add(LearnedFamily.of(Quantity.FRICTION, Variable.SESSION_TIME, session(arena)));
    all.add(LearnedFamily.of(Quantity.FRICTION, Variable.HEADING, heading));
    all.add(LearnedFamily.of(Quantity.FRICTION, Variable.PLACE, place(arena)));
    all.add(LearnedFamily.of(Quantity.SLIDING, Variable.HEADING, QUARTERS));
    all.add(LearnedFamily.of(across, Variable.SPEED, speed));
    all.add(LearnedFamily.of(across, Variable.HEADING, heading));
    all.add(LearnedFamily.of(across, Variable.PLACE, place(arena)));
    all.add(LearnedFamily.of(Quantity.FLOOR, Variable.PLACE, place(arena)));
    all.add(LearnedFamily.of(Quantity.PUSH, Variable.PLACE, stripes(arena)));
    all.add(LearnedFamily.of(Quantity.PUSH, Variable.SESSION_TIME, session(arena)));
    all.add(LearnedFamily.of(Quantity.NAP, Variable.PLACE, stripes(arena)));
    all.add(LearnedFamily.of(Quantity.AIR, Variable.PLACE, stripes(arena)));
  }

  private static void impact(Arena arena, Ranges ranges, List<LearnedFamily> all) {
    Basis vertical = curve(0, ranges.verticalSpeed(), KNOTS);
    Basis speed = curve(0, ranges.groundSpeed(), KNOTS);
    for (Quantity q : List.of(Quantity.VERTICAL_RESTITUTION, Quantity.TANGENTIAL_RESTITUTION)) {
      // Of e_xy the model tells the first impact from all later ones, of e_z none.
      boolean firstIsApart = q == Quantity.TANGENTIAL_RESTITUTION;
      Basis hops = firstIsApart ? new Levels(3, HOPS - 1) : new Levels(2, HOPS);
      all.add(LearnedFamily.of(q, Variable.VERTICAL_SPEED, vertical));
      all.add(LearnedFamily.of(q, Variable.GROUND_SPEED, speed));
      all.add(LearnedFamily.of(q, Variable.HOP, hops));
      all.add(LearnedFamily.of(q, Variable.HEADING, Harmonics.ofAngle(HARMONICS)));
      all.add(LearnedFamily.of(q, Variable.PLACE, place(arena)));
      all.add(LearnedFamily.of(q, Variable.SESSION_TIME, session(arena)));
    }
    all.add(LearnedFamily.of(Quantity.TURN, Variable.HEADING, Harmonics.ofAngle(HARMONICS)));
    all.add(LearnedFamily.of(Quantity.TURN, Variable.PLACE, place(arena)));
  }

  private static void camera(
      Arena arena, ObservedCamera camera, Ranges ranges, List<LearnedFamily> all) {
    int id = camera.id();
    ofImage(camera, arena, true).ifPresent(all::add);
    all.add(LearnedFamily.of(Quantity.SHIFT, Variable.SESSION_TIME, session(arena), id));
    all.add(LearnedFamily.of(Quantity.TIME_ERROR, Variable.SESSION_TIME, session(arena), id));
    // With a constant, because the part of a lateness that does not depend on the speed cannot be
    // separated from the rest.
    Basis speed = new Spline(0, ranges.speed(), KNOTS, false);
    all.add(LearnedFamily.of(Quantity.TIME_ERROR, Variable.SPEED, speed, id));
  }

  /** An error of the reported place over the place in the image; empty where the camera's pose is unknown. */
  private static Optional<LearnedFamily> ofImage(
      ObservedCamera camera, Arena arena, boolean centred) {
    return camera
        .camera()
        .map(
            below -> {
              double view = VIEW_PER_HEIGHT * below.positionZ();
              double[] x =
                  seen(arena.x0() - below.positionX(), arena.x1() - below.positionX(), view);
              double[] y =
                  seen(arena.y0() - below.positionY(), arena.y1() - below.positionY(), view);
              Basis area = new Polynomial(DEGREE, x[0], x[1], y[0], y[1], centred);
              return LearnedFamily.of(Quantity.SHIFT, Variable.IMAGE_POSITION, area, camera.id());
            });
  }

  private static Spline curve(double from, double to, int knots) {
    return new Spline(from, to, knots, true);
  }

  private static Basis session(Arena arena) {
    double[] times = arena.kickTimes();
    double[] range =
        times.length == 0 ? new double[] {0, NARROWEST} : wide(times[0], times[times.length - 1]);
    return curve(range[0], range[1], KNOTS_TIME);
  }

  private static Basis place(Arena arena) {
    double[] x = wide(arena.x0(), arena.x1());
    double[] y = wide(arena.y0(), arena.y1());
    return new Surface(
        new Spline(x[0], x[1], KNOTS_X, false), new Spline(y[0], y[1], KNOTS_Y, false), true);
  }

  private static Basis stripes(Arena arena) {
    double[] x = wide(arena.x0(), arena.x1());
    double[] y = wide(arena.y0(), arena.y1());
    return new Stripes(stripes(x), stripes(y));
  }

  private static Spline stripes(double[] range) {
    int knots = (int) Math.round((range[1] - range[0]) / STRIPE) + 1;
    return curve(range[0], range[1], Math.max(KNOTS_Y, Math.min(knots, MOST_STRIPES)));
  }

  private static double[] seen(double from, double to, double view) {
    double begin = Math.max(from, -view);
    double end = Math.min(to, view);
    return begin < end ? wide(begin, end) : wide(from, to);
  }

  private static double[] wide(double from, double to) {
    double missing = Math.max(0, NARROWEST - (to - from)) / 2;
    return new double[] {from - missing, to + missing};
  }
}
