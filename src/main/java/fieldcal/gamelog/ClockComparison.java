package fieldcal.gamelog;

/**
 * Compares one camera's clock, which stamps captures, with the recorder's, which stamps receptions: their difference and their rates, in constant memory.
 *
 * <p>The difference contains the delay from capture to reception, some 10 ms. The rate is the slope of a straight line through both times, jumps of the clock left out. For one thread.
 */
public final class ClockComparison {
  /** Longest delay of a frame, s; more is the difference of two clocks. Vision and networks delay frames by tens of milliseconds, simulators by some hundred. */
  public static final double MAX_DELAY = 1;

  /** Nothing is received before it was captured, but rounding may make it look so by this much, s. */
  private static final double ROUNDING = 1e-3;

  /** A rate that is off by more than this is reported: it makes accelerations 1 % wrong. Quartz clocks are off by less than 0.0001. */
  public static final double NOTABLE_RATE = 0.005;

  /** Delays of single frames scatter by up to 0.05 s; over this many seconds that is a tenth of the notable rate. */
  private static final double LEAST_SPAN = 100;

  /** With at least this many frames a tenth of that span is enough, since the scatter averages out. */
  private static final int MANY_FRAMES = 300;

  private long frames;
  private double mean;

  // The stretch since the last jump: its first frame, then means and moments relative to it.
  private long inStretch;
  private double firstCapture;
  private double firstDelay;
  private double meanCapture;
  private double meanDelay;
  private double moment;
  private double covariance;
  private double span;

  // Stretches that are over.
  private double pastMoment;
  private double pastCovariance;
  private double pastSpan;

  /** Starts with nothing seen. */
  public ClockComparison() {}

  /**
   * Takes a frame.
   *
   * @param captureTime by the camera's clock, s
   * @param receivedTime by the recorder's clock, s
   */
  public void add(double captureTime, double receivedTime) {
    double delay = receivedTime - captureTime;
    frames++;
    mean += (delay - mean) / frames;
    if (inStretch == 0) {
      firstCapture = captureTime;
      firstDelay = delay;
    }
    inStretch++;
    double x = captureTime - firstCapture;
    double y = delay - firstDelay;
    double fromMean = x - meanCapture;
    meanCapture += fromMean / inStretch;
    meanDelay += (y - meanDelay) / inStretch;
    moment += fromMean * (x - meanCapture);
    covariance += fromMean * (y - meanDelay);
    span = x;
  }

  /** One of the clocks jumped: later frames are compared only with each other. */
  public void jumped() {
    pastMoment += moment;
    pastCovariance += covariance;
    pastSpan += span;
    inStretch = 0;
    meanCapture = 0;
    meanDelay = 0;
    moment = 0;
    covariance = 0;
    span = 0;
  }

  /**
   * Mean of reception minus capture.
   *
   * @return s; NaN without frames
   */
  public double difference() {
    return frames == 0 ? Double.NaN : mean;
  }

  /**
   * Whether the difference cannot be a delay: then the latency cannot be derived from it.
   *
   * @return true when it is more than {@link #MAX_DELAY}, or negative
   */
  public boolean differ() {
    return isNoDelay(mean);
  }

  static boolean isNoDelay(double difference) {
    return difference > MAX_DELAY || difference < -ROUNDING;
  }

  /**
   * How many seconds of the recorder's clock a second of the camera's takes.
   *
   * @return 1 for equal clocks; NaN when too little was seen to distinguish 0.5 % from nothing
   */
  public double rate() {
    boolean enough =
        pastSpan + span >= LEAST_SPAN
            || frames >= MANY_FRAMES && pastSpan + span >= LEAST_SPAN / 10;
    return enough ? 1 + (pastCovariance + covariance) / (pastMoment + moment) : Double.NaN;
  }

  /**
   * Whether the clocks run at different rates.
   *
   * @return true when the rate is known and more than {@link #NOTABLE_RATE} from 1
   */
  public boolean ratesDiffer() {
    return Math.abs(rate() - 1) > NOTABLE_RATE;
  }
}
