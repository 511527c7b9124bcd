package fieldcal.kick;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * How a ball that lay still came to move: where and when it was really kicked, which the crossing of the lines before and after may miss by a tenth of a second.
 *
 * <p>A kicker may fire late: the robot goes on and pushes the ball for some hundredths of a second, and the kick is then not made where the ball lay. A fit that believes so is a few millimetres off at its start, many times the error
 * of a position of rest. And a chip that flies towards a camera seems to lie still at first, since its rise is projected away from the camera as fast as it comes nearer: it was kicked long before it seems to move.
 *
 * <p>Along the direction of the kick the ball lies still until it is touched. Then it either moves at one speed until the kick and at another after it (a push), or on a line (a kick), or on a parabola (a chip, projected). Times are found on a grid, the
 * rest by least squares, and a push or a parabola is believed when it explains clearly more than a plain kick does. Each camera has its own place of rest and its own speeds, since cameras disagree and project a chip differently.
 *
 * @param time of the kick, s
 * @param timeError its standard error, s
 * @param length of the push, m
 * @param fromRest whether the ball was kicked where it lay
 */
record Departure(double time, double timeError, double length, boolean fromRest) {
  /** Least gain of chi-square for which a push or a parabola is believed; a push has three more parameters (touch, kick, speed). Noise alone reaches this in one of five hundred kicks, whose place is then merely known less precisely. */
  private static final double SURELY = 15;

  /** Good cameras see a resting ball to 0.7 mm (ten matches of 2026); few detections may agree better by chance, m. */
  private static final double LEAST_NOISE = 7e-4;

  /** Longest time from the first touch of a push to the kick, s; dead times and a robot's delays are shorter. */
  private static final double LONGEST = 0.12;

  /** Longest time from a kick to when its jump was found, s: a chip at 53 degrees towards a camera that is 4.3 m high and 3.4 m away is found 0.12 s late. */
  static final double LATEST = 0.15;

  private static final double SHORTEST = 0.01;

  /** Time after the kick during which a ball that slides or flies moves on a line to within a camera's noise, s. */
  private static final double STRAIGHT = 0.045;

  /** How far the time of a kick as found may be off, s: 20 mm of push at 2 m/s. */
  private static final double TIME_OFF = 0.012;

  /** The time of a kick after a push is known to a millisecond or two; what is seen sooner after it may still belong to the push, s. */
  private static final double UNSURE = 0.005;

  /** A ball that was not seen for longer before the kick may have been pushed meanwhile, s: a frame at 30 Hz. */
  private static final double UNSEEN = 0.04;

  /** Least standard error of the time, s: cameras' time stamps jitter by up to 1.3 ms (ten real matches of 2026), several detections by half of that. */
  private static final double LEAST_ERROR = 7e-4;

  /** Steps of the grids, s: a millimetre at 2 m/s, and at the speed of a push. */
  private static final double TIME_STEP = 5e-4;

  private static final double TOUCH_STEP = 5e-3;

  /** Fastest push, m/s; a faster one is the kick itself, by the finder's limit for kicks. */
  private static final double FASTEST = 0.7;

  /**
   * Half of the largest acceleration of a projected chip along its path, m/s²: 2·v·vz/h + g·r/h − 2·r·vz²/h² is 12 for a weak chip (v = vz = 1.5 m/s) towards a camera that is h = 4 m high and r = 5 m away. A push that ends in a kick looks several times as curved.
   */
  private static final double MOST_CURVED = 6;

  /** Detections before the kick that are farther from the resting ball show something else, m; a chip that seems to lie still is found by the time it has moved this far. */
  private static final double ELSEWHERE = 0.12;

  /** A resting ball is seen within so many standard deviations of its place. */
  private static final double AT_REST = 3;

  /** Fewer detections of rest do not show where the ball lay, nor how noisy the camera is. */
  private static final int FEWEST = 5;

  /** A detection: when, by which of the cameras, and how far along the direction of the kick from where the camera saw the ball rest. */
  private record Seen(double t, int camera, double along) {}

  /** Detections near the kick, and their noise, m. */
  private record Near(List<Seen> seen, int cameras, double noise) {}

  /** Time from which on the ball certainly moves as it was kicked, s. */
  double over() {
    return time + UNSURE;
  }

  /**
   * How the ball departed.
   *
   * @param all detections from the rest on
   * @param time of the kick as found, s
   * @param vx velocity after the kick, m/s
   * @param vy m/s
   * @param still whether the ball seemed to lie still until then; otherwise it is believed to have been kicked where it lay only if that explains all that was seen
   * @return the time as found where the ball was kicked where it lay or too little was seen; {@code fromRest} false and {@code length} 0 where a robot hid or moved the ball, so that the place of the kick is not known
   */
  static Departure of(Observations all, double time, double vx, double vy, boolean still) {
    Departure unknown = new Departure(time, Kick.CROSSING_ERROR, 0, false);
    if (all.count(time - UNSEEN) == all.count(time)) {
      return unknown;
    }
    Departure plain = still ? new Departure(time, Kick.CROSSING_ERROR, 0, true) : unknown;
    double speed = Math.hypot(vx, vy);
    Near near = near(all, time, vx / speed, vy / speed, LATEST);
    if (near.cameras == 0) {
      return plain;
    }
    double curved = Double.POSITIVE_INFINITY;
    double earlier = time;
    for (double kick = time - LATEST; kick < time + TIME_OFF; kick += TIME_STEP) {
      double squares = curved(near, kick);
      if (squares < curved) {
        curved = squares;
        earlier = kick;
      }
    }
    double variance = near.noise * near.noise;
    boolean bent = straight(near, time) - curved > SURELY * variance;
    Near nearer = bent ? near : near(all, time, vx / speed, vy / speed, LONGEST);
    double simpler = bent ? curved : straight(nearer, time);
    Optional<Departure> pushed =
        pushed(nearer, time, simpler - SURELY * nearer.noise * nearer.noise);
    if (pushed.isPresent()) {
      return pushed.get();
    }
    int n = near.seen.size();
    boolean explained = still || curved / variance < n + SURELY + 2 * Math.sqrt(2.0 * n);
    return bent && explained ? new Departure(earlier, Kick.CROSSING_ERROR, 0, true) : plain;
  }

  /** What a kick without a push leaves unexplained, m². */
  private static double straight(Near near, double time) {
    double least = Double.POSITIVE_INFINITY;
    for (double kick = time - TIME_OFF; kick < time + TIME_OFF; kick += TIME_STEP) {
      least = Math.min(least, squares(near, kick, kick, 0));
    }
    return least;
  }

  /** The push that leaves less than {@code most} unexplained, m². */
  private static Optional<Departure> pushed(Near near, double time, double most) {
    Departure best = null;
    List<double[]> profile = new ArrayList<>();
    double with = Double.POSITIVE_INFINITY;
    for (double kick = time - TIME_OFF; kick < time + TIME_OFF; kick += TIME_STEP) {
      double least = Double.POSITIVE_INFINITY;
      for (double lasts = SHORTEST; lasts <= LONGEST; lasts += TOUCH_STEP) {
        double pushed = speed(near, kick - lasts, kick);
        double squares =
            pushed > 0 && pushed < FASTEST
                ? squares(near, kick - lasts, kick, pushed)
                : Double.POSITIVE_INFINITY;
        if (squares < with) {
          with = squares;
          best = new Departure(kick, Kick.CROSSING_ERROR, pushed * lasts, false);
        }
        least = Math.min(least, squares);
      }
      profile.add(new double[] {kick, least});
    }
    return best != null && with < most
        ? Optional.of(best.timed(profile, with, near.noise * near.noise))
        : Optional.empty();
  }

  /** The same with the mean and the spread of the times that explain what was seen about as well as the best one. */
  private Departure timed(List<double[]> profile, double least, double variance) {
    double weights = 0;
    double mean = 0;
    double square = 0;
    for (double[] at : profile) {
      double weight = Math.exp((least - at[1]) / (2 * variance));
      double off = at[0] - time;
      weights += weight;
      mean += weight * off;
      square += weight * off * off;
    }
    mean /= weights;
    double spread = Math.sqrt(Math.max(0, square / weights - mean * mean));
    return new Departure(time + mean, Math.max(LEAST_ERROR, spread), length, false);
  }

  /** What was seen near the kick, from {@code since} seconds before it on; what was seen earlier is rest. */
  private static Near near(Observations all, double time, double ux, double uy, double since) {
    Map<Integer, List<Double>> rest = new HashMap<>();
    for (int i = 0; i < all.size() && all.time(i) < time - since; i++) {
      rest.computeIfAbsent(all.camera(i), c -> new ArrayList<>())
          .add(ux * all.x(i) + uy * all.y(i));
    }
    rest.values().removeIf(r -> r.size() < FEWEST);
    List<Integer> cameras = List.copyOf(rest.keySet());
    double squares = 0;
    int degrees = 0;
    Map<Integer, Double> places = new HashMap<>();
    for (Map.Entry<Integer, List<Double>> entry : rest.entrySet()) {
      double mean = entry.getValue().stream().mapToDouble(a -> a).average().orElseThrow();
      places.put(entry.getKey(), mean);
      squares += entry.getValue().stream().mapToDouble(a -> (a - mean) * (a - mean)).sum();
      degrees += entry.getValue().size() - 1;
    }
    List<Seen> seen = new ArrayList<>();
    for (int i = 0; i < all.size() && all.time(i) < time + STRAIGHT; i++) {
      int camera = cameras.indexOf(all.camera(i));
      if (camera >= 0 && all.time(i) > time - since) {
        double along = ux * all.x(i) + uy * all.y(i) - places.get(all.camera(i));
        if (all.time(i) > time || Math.abs(along) < ELSEWHERE) {
          seen.add(new Seen(all.time(i), camera, along));
        }
      }
    }
    double noise = Math.max(LEAST_NOISE, Math.sqrt(squares / Math.max(1, degrees)));
    List<Seen> before = seen.stream().filter(s -> s.t <= time).toList();
    seen.removeAll(before.stream().filter(s -> isFalse(s, before, noise)).toList());
    return new Near(seen, cameras.size(), noise);
  }

  /** A single detection away from the place of rest, with the ball there in the camera's frames before and after it, is something else. A chip that is projected away from the camera also comes back, but over several frames. */
  private static boolean isFalse(Seen away, List<Seen> before, double noise) {
    List<Seen> same = before.stream().filter(s -> s.camera == away.camera).toList();
    int at = same.indexOf(away);
    return Math.abs(away.along) > 2 * AT_REST * noise
        && at + 1 < same.size()
        && Math.abs(same.get(at + 1).along) < AT_REST * noise
        && (at == 0 || Math.abs(same.get(at - 1).along) < AT_REST * noise);
  }

  /** How far a push at 1 m/s has moved the ball. */
  private static double pushed(double t, double touch, double kick) {
    return Math.max(0, Math.min(t, kick) - touch);
  }

  /** The speed of the push that fits best, whatever the cameras' speeds after the kick are, m/s. */
  private static double speed(Near near, double touch, double kick) {
    double[][] after = after(near, touch, kick);
    double top = 0;
    double bottom = 0;
    for (Seen s : near.seen) {
      double t = Math.max(0, s.t - kick);
      double g = pushed(s.t, touch, kick) - t * after[1][s.camera];
      top += g * (s.along - t * after[0][s.camera]);
      bottom += g * g;
    }
    return bottom > 0 ? top / bottom : 0;
  }

  /** Slopes after the kick, of each camera: of what was seen, and of a push at 1 m/s. */
  private static double[][] after(Near near, double touch, double kick) {
    double[][] slopes = new double[2][near.cameras];
    double[] squares = new double[near.cameras];
    for (Seen s : near.seen) {
      double t = Math.max(0, s.t - kick);
      slopes[0][s.camera] += t * s.along;
      slopes[1][s.camera] += t * pushed(s.t, touch, kick);
      squares[s.camera] += t * t;
    }
    for (int c = 0; c < near.cameras; c++) {
      for (double[] slope : slopes) {
        slope[c] = squares[c] > 0 ? slope[c] / squares[c] : 0;
      }
    }
    return slopes;
  }

  /** What a push at that speed leaves unexplained, m². */
  private static double squares(Near near, double touch, double kick, double speed) {
    double[][] after = after(near, touch, kick);
    double sum = 0;
    for (Seen s : near.seen) {
      double t = Math.max(0, s.t - kick);
      double slope = after[0][s.camera] - speed * after[1][s.camera];
      double r = s.along - speed * pushed(s.t, touch, kick) - t * slope;
      sum += r * r;
    }
    return sum;
  }

  /** What a kick at that time leaves unexplained whose ball moves on a parabola, m². */
  private static double curved(Near near, double kick) {
    double[][] sums = new double[near.cameras][5];
    double squares = 0;
    for (Seen s : near.seen) {
      double t = Math.max(0, s.t - kick);
      double[] sum = sums[s.camera];
      sum[0] += t * t;
      sum[1] += t * t * t;
      sum[2] += t * t * t * t;
      sum[3] += t * s.along;
      sum[4] += t * t * s.along;
      squares += s.along * s.along;
    }
    for (double[] m : sums) {
      double determinant = m[0] * m[2] - m[1] * m[1];
      if (!(m[0] > 0)) {
        continue;
      }
      double bend = determinant > 0 ? (m[0] * m[4] - m[1] * m[3]) / determinant : 0;
      bend = Math.max(-MOST_CURVED, Math.min(MOST_CURVED, bend));
      double slope = (m[3] - bend * m[1]) / m[0];
      squares +=
          slope * slope * m[0]
              + 2 * slope * bend * m[1]
              + bend * bend * m[2]
              - 2 * slope * m[3]
              - 2 * bend * m[4];
    }
    return squares;
  }
}
