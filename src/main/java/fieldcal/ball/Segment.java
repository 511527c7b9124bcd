package fieldcal.ball;

/**
 * A piece of a path with constant acceleration: one flight, the sliding or the rolling phase, or a rest. Evaluated at the time {@code tau}
 * since its start.
 *
 * <p>Length of the path over the ground: with {@code q} the component of the horizontal velocity along the horizontal
 * acceleration (grows by |a| per second) and {@code h} the one across (constant), it is the integral of {@code sqrt(q² + h²)}
 * over time, {@code [q·sqrt(q² + h²) + h²·asinh(q/h)]/(2|a|)}.
 */
final class Segment {
  /** Below this ratio of the velocity across the acceleration to the speed the path is straight: the neglected length is below 1e-15 m. */
  private static final double STRAIGHT = 1e-9;

  /** Newton's method doubles the digits in each step; bisections are needed only near a turning point. */
  private static final int MAX_ITERATIONS = 100;

  final Phase phase;
  final double start;
  final double duration;
  final double x;
  final double y;
  final double z;
  final double vx;
  final double vy;
  final double vz;
  final double ax;
  final double ay;
  final double az;
  private final double along;
  private final double across;
  private final double acceleration;

  private Segment(
      Phase phase, double start, double duration, BallState at, double ax, double ay, double az) {
    this.phase = phase;
    this.start = start;
    this.duration = duration;
    this.x = at.x();
    this.y = at.y();
    this.z = at.z();
    this.vx = at.vx();
    this.vy = at.vy();
    this.vz = at.vz();
    this.ax = ax;
    this.ay = ay;
    this.az = az;
    this.acceleration = Math.sqrt(ax * ax + ay * ay);
    double inverse = acceleration > 0 ? 1 / acceleration : 0;
    this.along = (vx * ax + vy * ay) * inverse;
    this.across = Math.abs(vx * ay - vy * ax) * inverse;
  }

  /** A flight that ends on the carpet. */
  static Segment flight(double start, BallState at) {
    double g = Gravity.ACCELERATION;
    double duration = (at.vz() + Math.sqrt(at.vz() * at.vz() + 2 * g * at.z())) / g;
    return new Segment(Phase.FLYING, start, duration, at, 0, 0, -g);
  }

  /** Sliding with a given acceleration for a given time. */
  static Segment slide(double start, double duration, BallState at, double ax, double ay) {
    return new Segment(Phase.SLIDING, start, duration, at, ax, ay, 0);
  }

  /** Rolling to rest. */
  static Segment roll(double start, BallState at, double accRoll) {
    double speed = Math.sqrt(at.vx() * at.vx() + at.vy() * at.vy());
    double perSpeed = speed > 0 ? accRoll / speed : 0;
    return new Segment(
        Phase.ROLLING, start, -speed / accRoll, at, at.vx() * perSpeed, at.vy() * perSpeed, 0);
  }

  /** Lying still. */
  static Segment rest(Phase phase, double start, double x, double y, double z) {
    return new Segment(phase, start, 0, new BallState(x, y, z, 0, 0, 0), 0, 0, 0);
  }

  /**
   * Time since the start, for a time at which this piece holds; always 0 for a rest, also at infinite times.
   */
  double tauAt(double t) {
    return duration > 0 ? t - start : 0;
  }

  double end() {
    return start + duration;
  }

  double xAt(double tau) {
    return x + tau * (vx + 0.5 * ax * tau);
  }

  double yAt(double tau) {
    return y + tau * (vy + 0.5 * ay * tau);
  }

  /** Never below the carpet, not even by a rounding error at the end of a flight. */
  double zAt(double tau) {
    double height = z + tau * (vz + 0.5 * az * tau);
    return height > 0 ? height : 0;
  }

  BallState stateAt(double tau) {
    return new BallState(xAt(tau), yAt(tau), zAt(tau), vx + ax * tau, vy + ay * tau, vz + az * tau);
  }

  /** Length of the path over the ground during the first {@code tau} seconds, m. */
  double length(double tau) {
    if (acceleration == 0) {
      return Math.sqrt(vx * vx + vy * vy) * tau;
    }
    double doubled = doubledArea(along + acceleration * tau) - doubledArea(along);
    return 0.5 * doubled / acceleration;
  }

  /** Time since the start after which the path has the given length; at most the duration. */
  double timeAtLength(double length) {
    double speed = Math.sqrt(vx * vx + vy * vy);
    if (acceleration == 0) {
      return speed > 0 ? Math.min(length / speed, duration) : 0;
    }
    if (across <= STRAIGHT * speed) {
      double squared = along * Math.abs(along) + 2 * acceleration * length;
      double end = Math.copySign(Math.sqrt(Math.abs(squared)), squared);
      return Math.max(0, Math.min((end - along) / acceleration, duration));
    }
    return curvedTimeAtLength(length);
  }

  private double curvedTimeAtLength(double length) {
    double low = 0;
    double high = duration;
    double tau = 0.5 * duration;
    for (int i = 0; i < MAX_ITERATIONS; i++) {
      double miss = length(tau) - length;
      if (miss > 0) {
        high = tau;
      } else {
        low = tau;
      }
      double speed = Math.hypot(along + acceleration * tau, across);
      double next = tau - miss / speed;
      if (!(next >= low && next <= high)) {
        next = 0.5 * (low + high);
      }
      if (Math.abs(next - tau) <= 1e-15 * duration) {
        return next;
      }
      tau = next;
    }
    return tau;
  }

  /** Twice the integral of sqrt(q² + across²) from 0 to q. */
  private double doubledArea(double q) {
    if (across == 0) {
      return q * Math.abs(q);
    }
    double ratio = Math.abs(q) / across;
    double asinh = Math.log(ratio + Math.sqrt(ratio * ratio + 1));
    double size = Math.abs(q) * Math.sqrt(q * q + across * across) + across * across * asinh;
    return Math.copySign(size, q);
  }
}
