package fieldcal.gamelog;

import fieldcal.vision.VisionFrame;

/** Collects what {@link CameraStatistics} holds of one camera, in constant memory. */
final class CameraObserver {
  private static final double NANOSECOND = 1e-9;
  private static final double MAX_INTERVAL = 1;
  private static final int MIN_INTERVALS = 20;

  /** From the median absolute deviation to the standard deviation of a normal distribution. */
  private static final double MAD_TO_SIGMA = 1.4826;

  /** An interval is the difference of two times, so its scatter is larger than theirs. */
  private static final double INTERVAL_TO_TIME = Math.sqrt(0.5);

  private final int id;
  private final RestingBallNoise noise = new RestingBallNoise();
  private final QuantileSketch intervals = new QuantileSketch(1e-4, MAX_INTERVAL);
  private final QuantileSketch deviations = new QuantileSketch(NANOSECOND, MAX_INTERVAL);
  private final ClockComparison clock = new ClockComparison();
  private final QuantileSketch latencies = new QuantileSketch(1e-5, 10 * ClockComparison.MAX_DELAY);
  private final long[] steps = new long[FrameStep.MAX + 1];
  private long frames;
  private long balls;
  private long robots;
  private long gaps;
  private double longestGap;
  private double lastTime;
  private long lastNumber;
  private double pace = Double.NaN;
  private double regularTime;
  private long regularIntervals;

  CameraObserver(int id) {
    this.id = id;
  }

  void add(VisionFrame frame, double receivedTime) {
    if (frames > 0) {
      addInterval(frame);
    }
    frames++;
    balls += frame.balls().size();
    robots += frame.robots().size();
    lastTime = frame.captureTime();
    lastNumber = frame.frameNumber();
    clock.add(frame.captureTime(), receivedTime);
    latencies.add(Math.max(receivedTime - frame.captureTime(), 0));
    noise.add(frame);
  }

  /** The clock jumped: the interval to the next frame does not count. */
  void clockJumped() {
    lastTime = Double.NaN;
    clock.jumped();
  }

  CameraStatistics statistics() {
    boolean enough = intervals.total() >= MIN_INTERVALS;
    return new CameraStatistics(
        id,
        frames,
        enough && regularTime > 0 ? regularIntervals / regularTime : Double.NaN,
        lostFrames(),
        gaps,
        longestGap,
        enough ? MAD_TO_SIGMA * INTERVAL_TO_TIME * deviations.quantile(0.5) : Double.NaN,
        enough && !clock.differ() ? latencies.quantile(0.5) : Double.NaN,
        clock.difference(),
        clock.rate(),
        balls,
        robots,
        noise.standardDeviation(),
        noise.blocks());
  }

  private void addInterval(VisionFrame frame) {
    double interval = frame.captureTime() - lastTime;
    if (!(interval > 0)) {
      return;
    }
    if (interval > RecordingStatistics.GAP) {
      gaps++;
      longestGap = Math.max(longestGap, interval);
      return;
    }
    long step = frame.frameNumber() - lastNumber;
    if (step >= 1) {
      steps[(int) Math.min(step, FrameStep.MAX)]++;
    }
    intervals.add(interval);
    if (intervals.total() == MIN_INTERVALS || intervals.total() % 1000 == 0) {
      pace = intervals.quantile(0.5);
    }
    // Only intervals without a lost frame show rate and jitter.
    if (interval > 0.5 * pace && interval < 1.5 * pace) {
      regularTime += interval;
      regularIntervals++;
      deviations.add(Math.abs(interval - regularTime / regularIntervals));
    }
  }

  private long lostFrames() {
    FrameStep usual = FrameStep.of(steps);
    long lost = 0;
    for (int step = 1; step < steps.length; step++) {
      lost += steps[step] * usual.missing(0, step);
    }
    return lost;
  }
}
