package fieldcal.movement;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.Arrays;
import java.util.function.Consumer;

/** Cuts a stretch of a robot's path into manoeuvres and measures each, and learns the noise of the detections meanwhile. */
final class ManoeuvreFinder {
  /** Longest part of a neighbouring piece that is used, s. */
  private static final double FLANK = 0.3;

  /** Shortest part of the following piece that must have been seen, s. */
  private static final double SEEN_AFTER = 0.1;

  /** A fit much worse than the noise is no piece of constant acceleration. */
  private static final double WORST = 2.5;

  /** Fewest fits from which the noise is measured. */
  private static final int MIN_FITS_FOR_NOISE = 20;

  /** A robot that turns by more than this during a manoeuvre has no direction of its front, rad. */
  private static final double DIFFERENT_FRONT = 0.3;

  private final PathKind kind;
  private final Consumer<Manoeuvre> sink;
  private final Pieces pieces;
  private final RampFit ramp;
  private final Histogram noise = new Histogram(0.01, 1500);

  /** Of each team: corners at the beginning and the end of speeding up, and of slowing down. */
  private final Rounding[][][] roundings = new Rounding[Team.values().length][2][2];

  private double variance;

  /** Finds manoeuvres of paths of one kind; the path of an angle has the angle as x, and 0 as y. */
  ManoeuvreFinder(PathKind kind, Consumer<Manoeuvre> sink) {
    this.kind = kind;
    this.sink = sink;
    pieces = new Pieces(kind.dimensions());
    ramp = new RampFit(kind.dimensions());
    variance = kind.usualNoise() * kind.usualNoise();
    for (Rounding[][] team : roundings) {
      for (Rounding[] corners : team) {
        Arrays.setAll(corners, i -> new Rounding());
      }
    }
  }

  /** Standard deviation of one coordinate of a detection, m or rad. */
  double noise() {
    return Math.sqrt(variance);
  }

  boolean noiseKnown() {
    return noise.samples() >= MIN_FITS_FOR_NOISE;
  }

  /**
   * Measures all pieces that have neighbours.
   *
   * @return relative time at which the first piece begins that is not finished; the stretch's end when all of it is one piece, whose beginning was not seen
   */
  double find(RobotId robot, Stretch stretch) {
    if (stretch.extent() < kind.leastExtent()) {
      return stretch.span();
    }
    pieces.cut(stretch, variance);
    if (pieces.count() < 2) {
      return stretch.span();
    }
    int i = 1;
    while (i + 1 < pieces.count() && pieces.knot(i + 2) - pieces.knot(i + 1) >= SEEN_AFTER) {
      measure(robot, stretch, i);
      i++;
    }
    return pieces.knot(i);
  }

  private void measure(RobotId robot, Stretch stretch, int i) {
    double first = pieces.knot(i);
    double second = pieces.knot(i + 1);
    double from = Math.max(pieces.knot(i - 1), first - FLANK);
    double to = Math.min(pieces.knot(i + 2), second + FLANK);
    boolean speedsUp = speedsUp(stretch, first, second);
    Rounding[] corners = roundings[robot.team().ordinal()][speedsUp ? 0 : 1];
    if (!ramp.fit(stretch, from, to, first, second, corners[0], corners[1], variance)) {
      return;
    }
    learn();
    if (ramp.variance() > WORST * variance) {
      return;
    }
    if (Math.hypot(ramp.ax(), ramp.ay()) > kind.plain()) {
      ramp.learn(0, variance, corners[0]);
      ramp.learn(1, variance, corners[1]);
    }
    double used = Math.max(variance, 0.5 * (variance + ramp.variance()));
    double ax = ramp.ax();
    double ay = ramp.ay();
    double a = Math.hypot(ax, ay);
    double nx = a > 0 ? ax / a : 1;
    double ny = a > 0 ? ay / a : 0;
    int begin = stretch.indexAt(ramp.firstKnot());
    int end = stretch.indexAt(ramp.secondKnot());
    double duration = ramp.secondKnot() - ramp.firstKnot();
    double noiseOfSecond = Math.sqrt(used * duration / Math.max(1, end - begin));
    // By how much the piece beyond its fast end accelerates the other way.
    double beyond = speedsUp ? -ramp.change(1, nx, ny) : ramp.change(0, nx, ny);
    sink.accept(
        new Manoeuvre(
            robot,
            stretch.baseTime() + ramp.firstKnot(),
            duration,
            ramp.vx(),
            ramp.vy(),
            ax,
            ay,
            Math.sqrt(ramp.accelerationVariance(nx, ny, used)),
            Math.sqrt(ramp.velocityVariance(nx, ny, used)),
            0.5 * Math.max(corners[0].width(), corners[1].width()),
            overshoot(a, beyond - a, noiseOfSecond),
            front(stretch, begin, end),
            end - begin));
  }

  /**
   * By how much the peak at which two pieces meet may exceed the robot's highest speed. A robot that speeds up by a, stays at that speed for a time t, and brakes by b leaves out the tip of the peak, of height h = t·g with 1/g = 1/a + 1/b. Its area
   * ½·h·t is a distance. The stay gets a piece of its own only where this distance stands out of the noise over that time by the penalty of a piece: ½·h·t > √price·noise/√t, with the noise of a second of detections. So t is at most
   * (2·√price·noise/g)^0.4. In simulated matches with 3.9 mm of noise, peaks were up to 0.10 m/s too high, where this gives 0.12 m/s.
   */
  private double overshoot(double acceleration, double other, double noiseOfSecond) {
    if (!(acceleration > 0 && other > 0)) {
      return 0;
    }
    double g = acceleration * other / (acceleration + other);
    return g * Math.pow(2 * Math.sqrt(pieces.price()) * noiseOfSecond / g, 0.4);
  }

  /** Whether the second half of a piece is the longer one. */
  private static boolean speedsUp(Stretch s, double first, double second) {
    int begin = s.indexAt(first);
    int middle = s.indexAt(0.5 * (first + second));
    int end = Math.min(s.indexAt(second), s.size() - 1);
    return middle >= end
        || Math.hypot(s.x[end] - s.x[middle], s.y[end] - s.y[middle])
            > Math.hypot(s.x[middle] - s.x[begin], s.y[middle] - s.y[begin]);
  }

  private void learn() {
    if (ramp.freedom() < 30) {
      return;
    }
    // In logarithms, so that bins of one per cent hold every noise up to 1800 times the least.
    double least = kind.leastNoise() * kind.leastNoise();
    noise.add(Math.log(Math.max(least, ramp.variance()) / least));
    if (noiseKnown()) {
      variance = least * Math.exp(noise.percentile(0.5));
    }
  }

  private static double front(Stretch s, int begin, int end) {
    double cos = 0;
    double sin = 0;
    for (int i = begin; i < end; i++) {
      cos += Math.cos(s.orientation[i]);
      sin += Math.sin(s.orientation[i]);
    }
    double mean = Math.atan2(sin, cos);
    double turned = 0;
    for (int i = begin; i < end; i++) {
      turned = Math.max(turned, Math.abs(Math.IEEEremainder(s.orientation[i] - mean, 2 * Math.PI)));
    }
    return turned < DIFFERENT_FRONT ? mean : Double.NaN;
  }
}
