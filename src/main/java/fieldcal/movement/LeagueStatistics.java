package fieldcal.movement;

/**
 * The league's estimator: velocities from frames of one camera that lie five apart, accelerations from two such velocities in a row, three histograms, fixed percentiles. Its percentiles were chosen so
 * that the effects of noise and of idling robots roughly cancel; they are reported beside our estimate because teams know them.
 *
 * <p>The method as in TIGERs Mannheim's team movement observer: acceleration is the length of the difference of the velocity vectors over the time of the later one; the robot brakes when the later one is shorter.
 */
public final class LeagueStatistics {
  /** A histogram of fewer values determines no percentile. */
  public static final long MIN_SAMPLES = 2000;

  /** Which share of the speeds lies below the limit. */
  public static final double VELOCITY_PERCENTILE = 0.995;

  /** Which share of the accelerations lies below the limit. */
  public static final double ACCELERATION_PERCENTILE = 0.75;

  /** Which share of the decelerations lies below the limit. */
  public static final double BRAKING_PERCENTILE = 0.95;

  /** A slower robot's acceleration is noise, m/s. */
  private static final double MIN_SPEED = 0.1;

  private static final double BIN = 0.1;

  private final Histogram velocity = new Histogram(BIN, 50);
  private final Histogram acceleration = new Histogram(BIN, 100);
  private final Histogram braking = new Histogram(BIN, 100);

  /** Nothing counted yet. */
  LeagueStatistics() {}

  /** Counts a robot that had velocity 1, and velocity 2 for the time after that, m/s and s. */
  void add(double vx1, double vy1, double vx2, double vy2, double time) {
    double before = Math.hypot(vx1, vy1);
    double now = Math.hypot(vx2, vy2);
    velocity.add(now);
    if (now >= MIN_SPEED) {
      Histogram kind = now > before ? acceleration : braking;
      kind.add(Math.hypot(vx2 - vx1, vy2 - vy1) / time);
    }
  }

  void merge(LeagueStatistics other) {
    velocity.merge(other.velocity);
    acceleration.merge(other.acceleration);
    braking.merge(other.braking);
  }

  void clear() {
    velocity.clear();
    acceleration.clear();
    braking.clear();
  }

  /**
   * Speeds.
   *
   * @return in m/s
   */
  public Histogram velocity() {
    return velocity;
  }

  /**
   * Accelerations of robots that became faster.
   *
   * @return in m/s²
   */
  public Histogram acceleration() {
    return acceleration;
  }

  /**
   * Accelerations of robots that became slower.
   *
   * @return in m/s²
   */
  public Histogram braking() {
    return braking;
  }

  /**
   * The limit of velocity.
   *
   * @return m/s; undetermined below {@link #MIN_SAMPLES}
   */
  public LimitEstimate velocityLimit() {
    return limit(velocity, VELOCITY_PERCENTILE);
  }

  /**
   * The limit of acceleration.
   *
   * @return m/s²; undetermined below {@link #MIN_SAMPLES}
   */
  public LimitEstimate accelerationLimit() {
    return limit(acceleration, ACCELERATION_PERCENTILE);
  }

  /**
   * The limit of braking.
   *
   * @return m/s², positive; undetermined below {@link #MIN_SAMPLES}
   */
  public LimitEstimate brakingLimit() {
    return limit(braking, BRAKING_PERCENTILE);
  }

  private static LimitEstimate limit(Histogram histogram, double share) {
    long samples = histogram.samples();
    if (samples < MIN_SAMPLES) {
      return LimitEstimate.undetermined(samples, "needs " + MIN_SAMPLES + " samples");
    }
    // Samples of overlapping frames are not independent, so no standard error can be given.
    return new LimitEstimate(histogram.percentile(share), Double.NaN, samples, true, "");
  }
}
