package fieldcal.simulation.imaging;

import java.util.List;

/**
 * What goes wrong in every real recording.
 *
 * @param falseBallRate single false balls per frame
 * @param falseClusterRate starts of a series of false balls at one place near a robot, per frame
 * @param ballMiss share of balls that vision misses
 * @param robotMiss share of robots that vision misses
 * @param frameDrop share of frames that are lost
 * @param burstRate interruptions of a camera of 0.05 to 0.4 s, per second
 * @param jitter standard deviation of the exposure from the regular beat, s
 * @param stampNoise standard deviation of the time stamp from the exposure, s
 * @param duplicates share of frames that arrive twice
 * @param shadows whether robots hide the ball
 * @param outages cameras that are gone for a while
 * @param robotMisread share of robots whose pattern is misread: as that of another number, or as turned by 90°
 */
public record Nuisance(
    double falseBallRate,
    double falseClusterRate,
    double ballMiss,
    double robotMiss,
    double frameDrop,
    double burstRate,
    double jitter,
    double stampNoise,
    double duplicates,
    boolean shadows,
    List<Outage> outages,
    double robotMisread) {

  /** Nothing goes wrong. */
  public static final Nuisance NONE = new Nuisance(0, 0, 0, 0, 0, 0, 0, 0, 0, false, List.of());

  /** A normal field. */
  public static final Nuisance TYPICAL =
      new Nuisance(
          0.002, 0.0004, 0.004, 0.002, 0.003, 0.01, 0.25e-3, 0.02e-3, 0.0005, true, List.of());

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a share is not in [0, 1] or a time is negative (or NaN)
   */
  public Nuisance {
    outages = List.copyOf(outages);
    double[] shares = {
      falseBallRate, falseClusterRate, ballMiss, robotMiss, frameDrop, duplicates, robotMisread
    };
    for (double share : shares) {
      if (!(share >= 0 && share <= 1)) {
        throw new IllegalArgumentException("share must lie in [0, 1], but is " + share);
      }
    }
    if (!(burstRate >= 0 && jitter >= 0 && stampNoise >= 0 && burstRate < 100 && jitter < 1)) {
      throw new IllegalArgumentException(
          "burst rate, jitter and stamp noise must not be negative: "
              + burstRate
              + ", "
              + jitter
              + ", "
              + stampNoise);
    }
  }

  /**
   * Trouble without misread patterns.
   *
   * @param falseBallRate single false balls per frame
   * @param falseClusterRate starts of a series of false balls at one place near a robot, per frame
   * @param ballMiss share of balls that vision misses
   * @param robotMiss share of robots that vision misses
   * @param frameDrop share of frames that are lost
   * @param burstRate interruptions of a camera of 0.05 to 0.4 s, per second
   * @param jitter standard deviation of the exposure from the regular beat, s
   * @param stampNoise standard deviation of the time stamp from the exposure, s
   * @param duplicates share of frames that arrive twice
   * @param shadows whether robots hide the ball
   * @param outages cameras that are gone for a while
   */
  public Nuisance(
      double falseBallRate,
      double falseClusterRate,
      double ballMiss,
      double robotMiss,
      double frameDrop,
      double burstRate,
      double jitter,
      double stampNoise,
      double duplicates,
      boolean shadows,
      List<Outage> outages) {
    this(
        falseBallRate,
        falseClusterRate,
        ballMiss,
        robotMiss,
        frameDrop,
        burstRate,
        jitter,
        stampNoise,
        duplicates,
        shadows,
        outages,
        0);
  }

  /**
   * A camera sends nothing for a while.
   *
   * @param camera its number
   * @param from session time, s
   * @param duration s
   */
  public record Outage(int camera, double from, double duration) {

    /**
     * Checks the ranges. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is negative or NaN
     */
    public Outage {
      if (!(camera >= 0 && from >= 0 && duration >= 0)) {
        throw new IllegalArgumentException(
            "outage must not be negative: camera "
                + camera
                + ", "
                + from
                + " s, "
                + duration
                + " s");
      }
    }

    boolean covers(int id, double time) {
      return id == camera && time >= from && time < from + duration;
    }
  }

  /**
   * The same trouble with other outages.
   *
   * @param list cameras that are gone for a while
   * @return the changed nuisance
   */
  public Nuisance withOutages(List<Outage> list) {
    return new Nuisance(
        falseBallRate,
        falseClusterRate,
        ballMiss,
        robotMiss,
        frameDrop,
        burstRate,
        jitter,
        stampNoise,
        duplicates,
        shadows,
        list,
        robotMisread);
  }

  /**
   * The same trouble with other misread patterns.
   *
   * @param share of robots whose pattern is misread
   * @return the changed nuisance
   */
  public Nuisance withRobotMisread(double share) {
    return new Nuisance(
        falseBallRate,
        falseClusterRate,
        ballMiss,
        robotMiss,
        frameDrop,
        burstRate,
        jitter,
        stampNoise,
        duplicates,
        shadows,
        outages,
        share);
  }
}
