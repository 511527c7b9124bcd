package fieldcal.kick;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a kicker does that fires late: the robot goes on and pushes the ball for some hundredths of a second. The kick is then not made where the ball lay, and a fit that believes so is a few millimetres off at its start, many times the error
 * of a position of rest.
 *
 * <p>Along the direction of the kick the ball lies still until the touch, moves at one speed until the kick, and at another after it. Touch and kick are found on a grid, the speeds by least squares, and the push is believed when it explains clearly
 * more than a kick without it. Each camera has a place of rest and a speed after the kick of its own: cameras disagree, and project a chip differently.
 *
 * @param time of the kick, s
 * @param timeError its standard error, s
 * @param length of the push, m
 */
record Push(double time, double timeError, double length) {
  /** Chi-square that a push explains at least; it has two more parameters, and noise reaches that in about one of a hundred kicks, which then only lose the precision of their place. */
  private static final double SURELY = 12;

  /** Good cameras see a resting ball to 0.7 mm (ten matches of 2026); few detections may agree better by chance, m. */
  private static final double LEAST_NOISE = 7e-4;

  /** So long before the kick nothing touches the ball, s; dead times and a robot's delays are shorter. */
  private static final double LONGEST = 0.12;

  private static final double SHORTEST = 0.01;

  /** For so long after the kick a ball that slides or flies moves on a line to within a camera's noise, s. */
  private static final double STRAIGHT = 0.045;

  /** How well the time of a kick is known before, s: 20 mm of push at 2 m/s. */
  private static final double TIME_OFF = 0.012;

  /** The time of a kick after a push is known to a millisecond or two; what is seen sooner after it may still be of the push, s. */
  private static final double UNSURE = 0.005;

  /** A ball that was not seen for longer before the kick may have been pushed meanwhile, s: a frame at 30 Hz. */
  private static final double UNSEEN = 0.04;

  /** The time is not known better, s: cameras' time stamps jitter by up to 1.3 ms (ten real matches of 2026), several detections by half of that. */
  private static final double LEAST_ERROR = 7e-4;

  /** Steps of the grids, s: a millimetre at 2 m/s, and at the speed of a push. */
  private static final double TIME_STEP = 5e-4;

  private static final double TOUCH_STEP = 5e-3;

  /** What is faster is the kick itself, m/s: the finder's limit for kicks. */
  private static final double FASTEST = 0.7;

  /** Detections that are farther from the resting ball before the kick are of something else, m. */
  private static final double ELSEWHERE = 0.05;

  /** Fewer detections of rest do not tell where the ball lay, nor how noisy the camera is. */
  private static final int FEWEST = 5;

  /** A detection: when, by which of the cameras, and how far along the direction of the kick from where the camera saw the ball rest. */
  private record Seen(double t, int camera, double along) {}

  /** Detections near the kick, and their noise, m. */
  private record Near(List<Seen> seen, int cameras, double noise) {}

  /** From when on the ball surely moves as it was kicked, s. */
  double over() {
    return time + UNSURE;
  }

  /**
   * The push before a kick from rest.
   *
   * @param all detections from the rest on
   * @param time of the kick as found, s
   * @param vx velocity after the kick, m/s
   * @param vy m/s
   * @return empty where the ball was kicked where it lay; of no length where a robot hid it until the kick, so that nobody knows
   */
  static Optional<Push> before(Observations all, double time, double vx, double vy) {
    if (all.count(time - UNSEEN) == all.count(time)) {
      return Optional.of(new Push(time, Kick.CROSSING_ERROR, 0));
    }
    double speed = Math.hypot(vx, vy);
    Near near = near(all, time, vx / speed, vy / speed);
    if (near.cameras == 0) {
      return Optional.empty();
    }
    double without = Double.POSITIVE_INFINITY;
    Push best = null;
    List<double[]> profile = new ArrayList<>();
    double with = Double.POSITIVE_INFINITY;
    for (double kick = time - TIME_OFF; kick < time + TIME_OFF; kick += TIME_STEP) {
      without = Math.min(without, squares(near, kick, kick, 0));
      double least = Double.POSITIVE_INFINITY;
      for (double lasts = SHORTEST; lasts <= LONGEST; lasts += TOUCH_STEP) {
        double pushed = speed(near, kick - lasts, kick);
        double squares =
            pushed > 0 && pushed < FASTEST
                ? squares(near, kick - lasts, kick, pushed)
                : Double.POSITIVE_INFINITY;
        if (squares < with) {
          with = squares;
          best = new Push(kick, Kick.CROSSING_ERROR, pushed * lasts);
        }
        least = Math.min(least, squares);
      }
      profile.add(new double[] {kick, least});
    }
    double variance = near.noise * near.noise;
    boolean surely = best != null && (without - with) / variance > SURELY;
    return surely ? Optional.of(best.timed(profile, with, variance)) : Optional.empty();
  }

  /** With mean and spread of the times that explain what was seen about as well as the best. */
  private Push timed(List<double[]> profile, double least, double variance) {
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
    return new Push(time + mean, Math.max(LEAST_ERROR, spread), length);
  }

  private static Near near(Observations all, double time, double ux, double uy) {
    Map<Integer, List<Double>> rest = new HashMap<>();
    for (int i = 0; i < all.size() && all.time(i) < time - LONGEST; i++) {
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
      if (camera >= 0 && all.time(i) > time - LONGEST) {
        double along = ux * all.x(i) + uy * all.y(i) - places.get(all.camera(i));
        if (all.time(i) > time || Math.abs(along) < ELSEWHERE) {
          seen.add(new Seen(all.time(i), camera, along));
        }
      }
    }
    return new Near(
        seen, cameras.size(), Math.max(LEAST_NOISE, Math.sqrt(squares / Math.max(1, degrees))));
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
}
