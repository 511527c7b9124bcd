package fieldcal.gamelog;

/**
 * Compares one camera's clock, which stamps captures, with the recorder's, which stamps receptions: their difference and their rates, in constant memory.
 *
 * <p>The difference contains the delay from capture to reception, some 10 ms. Whoever reads late adds to that delay and never takes from it, so the rate is taken from the least delay within each of many short
 * blocks of time: it is the median of the slopes between blocks that are an eighth of all blocks apart. Neither some late blocks nor a single step of a clock changes it. (Moon, Skelly and Towsley, Estimation and
 * removal of clock skew from network delay measurements, INFOCOM 1999, fit a line below all delays; one that starts late or a step would tilt it.) For one thread.
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

  /** With at least this many frames a tenth of that span is enough, since the least delays scatter far less. */
  private static final int MANY_FRAMES = 300;

  private long frames;
  private double mean;
  private final DelayBlocks blocks = new DelayBlocks();

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
    blocks.add(captureTime, delay);
  }

  /** One of the clocks jumped: later frames are compared only with each other. */
  public void jumped() {
    blocks.jumped();
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
    double span = blocks.span();
    boolean enough = span >= LEAST_SPAN || frames >= MANY_FRAMES && span >= LEAST_SPAN / 10;
    double slope = blocks.slope();
    // Two standard errors, 95 % of a normal distribution, tell a notable rate from none.
    double largestError = Math.max(NOTABLE_RATE, Math.abs(slope) - NOTABLE_RATE);
    return enough && 2 * blocks.slopeError() < largestError ? 1 + slope : Double.NaN;
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
