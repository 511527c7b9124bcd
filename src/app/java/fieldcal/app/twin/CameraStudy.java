package fieldcal.app.twin;

import fieldcal.app.statistics.FieldRecording;
import fieldcal.app.statistics.RecordedFrames;
import fieldcal.app.statistics.RestStretches;
import fieldcal.app.statistics.RestStretches.Stretch;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.FrameStep;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraRig;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.InstalledCamera.NoiseGrowth;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.Region;
import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import org.apache.commons.math3.stat.StatUtils;

/** Measures each camera of a recording: how good it is, how often it takes and loses frames, what it misses and invents. */
final class CameraStudy {
  /** Median of the absolute value to the standard deviation, of normal samples. */
  private static final double MAD = 1.4826;

  /** Standard deviation of x₋ − 2·x + x₊ to that of x. */
  private static final double SECOND_DIFFERENCE = Math.sqrt(6);

  /** A loss of that many frames in a row is an interruption, not bad luck: 0.05 s, the shortest that the simulator makes, at 75 Hz. */
  private static final int INTERRUPTION = 4;

  /** A longer silence is no interruption of one camera but a gap of the recording, s. */
  private static final double GAP = 0.45;

  /** What a camera sees beyond the outermost detection, m: a robot's radius. */
  private static final double MARGIN = 0.1;

  /** Share of equal time stamps from which on two cameras take their frames together. */
  private static final double TOGETHER = 0.95;

  private static final double SAME_TIME = 1e-6;

  /** Mean and standard deviation of the absolute value of a normal number, which the simulator adds to the latency, over its standard deviation: √(2/π), √(1 − 2/π). */
  private static final double HALF_NORMAL_MEAN = Math.sqrt(2 / Math.PI);

  private static final double HALF_NORMAL_DEVIATION = Math.sqrt(1 - 2 / Math.PI);

  /** Latency where nothing tells, s (chosen: what logs of 2026 show). */
  private static final double USUAL_LATENCY = 0.011;

  /** Frames per second that the simulator allows, 1/s. */
  private static final double SLOWEST = 5;

  private static final double FASTEST = 1000;

  /** Stands for the frame number of a robot that was not yet seen: far below all others. */
  private static final double UNSEEN = -1e9;

  private static final double MM = 1000;

  private final FieldRecording field;
  private final List<Stretch> rests = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();

  CameraStudy(FieldRecording field) {
    this.field = field;
    for (RecordedFrames one : field.frames()) {
      rests.addAll(RestStretches.of(one, field.kicks(one)));
    }
  }

  /** What was assumed. */
  List<String> notes() {
    return notes;
  }

  /** Whether all cameras take their frames at the same moments. */
  boolean together() {
    RecordedFrames one = field.frames().get(0);
    List<List<VisionFrame>> lists = List.copyOf(one.frames().values());
    if (lists.size() < 2) {
      return false;
    }
    for (List<VisionFrame> other : lists.subList(1, lists.size())) {
      if (same(lists.get(0), other) < TOGETHER * Math.min(lists.get(0).size(), other.size())) {
        return false;
      }
    }
    return true;
  }

  private static int same(List<VisionFrame> a, List<VisionFrame> b) {
    int same = 0;
    int j = 0;
    for (VisionFrame frame : a) {
      while (j < b.size() && b.get(j).captureTime() < frame.captureTime() - SAME_TIME) {
        j++;
      }
      if (j < b.size() && b.get(j).captureTime() < frame.captureTime() + SAME_TIME) {
        same++;
      }
    }
    return same;
  }

  /** All cameras that sent enough frames to tell their rate. */
  List<InstalledCamera> cameras(Map<Integer, CameraCalibration> published) {
    Map<Integer, Double> rates = new TreeMap<>();
    field.frames().stream()
        .flatMap(f -> f.frames().keySet().stream())
        .forEach(id -> rates.put(id, rate(id)));
    rates.forEach(
        (id, rate) -> {
          if (!isRate(rate)) {
            notes.add(
                "Camera "
                    + id
                    + " sent too few frames to tell its rate: the twin does not have it.");
          }
        });
    rates.values().removeIf(rate -> !isRate(rate));
    boolean together = together();
    double common = rates.values().stream().mapToDouble(rate -> rate).average().orElse(Double.NaN);
    NoiseGrowth growth = growth(published);
    List<InstalledCamera> all = new ArrayList<>();
    rates.forEach(
        (id, rate) ->
            all.add(camera(id, published.get(id), growth, together ? common : rate, together)));
    return all;
  }

  private static boolean isRate(double rate) {
    return rate >= SLOWEST && rate <= FASTEST;
  }

  private double over(int id, ToDoubleFunction<CameraStatistics> what) {
    double[] values =
        field.frames().stream()
            .flatMap(f -> f.camera(id).stream())
            .mapToDouble(what)
            .filter(Double::isFinite)
            .toArray();
    return values.length == 0 ? Double.NaN : StatUtils.mean(values);
  }

  private double rate(int id) {
    return over(id, CameraStatistics::rate);
  }

  private List<VisionFrame> frames(int id) {
    return field.frames().stream()
        .flatMap(f -> f.frames().getOrDefault(id, List.of()).stream())
        .toList();
  }

  private InstalledCamera camera(
      int id, CameraCalibration announced, NoiseGrowth growth, double rate, boolean together) {
    List<VisionFrame> frames = frames(id);
    FrameStep step = FrameStep.of(frames);
    Region view = view(frames);
    Camera camera = Camera.of(announced);
    CameraCalibration vision = vision(announced, camera, view);
    boolean pixels =
        camera.hasPixels()
            && frames.stream()
                .flatMap(f -> f.balls().stream())
                .anyMatch(b -> b.pixelX() != 0 && Double.isFinite(b.pixelX()));
    double latency = sent(frames);
    if (Double.isNaN(latency)) {
      latency = USUAL_LATENCY;
      notes.add(
          "The delay of camera " + id + " is not known; " + MM * latency + " ms are assumed.");
    }
    double spread = sentSpread(frames);
    double first = frames.isEmpty() ? 0 : frames.get(0).captureTime();
    double start = first - field.calibration().data().sessionStart();
    double phase = together ? 0 : start - Math.floor(start * rate) / rate;
    return new InstalledCamera(
        vision,
        announced,
        pixels,
        view,
        noise(id, Camera.of(vision), growth),
        growth,
        robotNoise(frames, step, RobotDetection::x),
        robotNoise(frames, step, RobotDetection::orientation),
        rate,
        phase,
        latency,
        spread,
        nuisance(id, frames, step, rate),
        CameraErrors.NONE);
  }

  /** The area of its detections. */
  private static Region view(List<VisionFrame> frames) {
    double[] b = {Double.MAX_VALUE, -Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE};
    for (VisionFrame frame : frames) {
      for (BallDetection ball : frame.balls()) {
        extend(b, ball.x(), ball.y());
      }
      for (RobotDetection robot : frame.robots()) {
        extend(b, robot.x(), robot.y());
      }
    }
    return b[0] > b[1]
        ? Region.NONE
        : new Region(b[0] - MARGIN, b[1] + MARGIN, b[2] - MARGIN, b[3] + MARGIN);
  }

  private static void extend(double[] b, double x, double y) {
    b[0] = Math.min(b[0], x);
    b[1] = Math.max(b[1], x);
    b[2] = Math.min(b[2], y);
    b[3] = Math.max(b[3], y);
  }

  /** What vision projects with: the published calibration, or one that looks straight down from the published place. */
  private CameraCalibration vision(CameraCalibration announced, Camera camera, Region view) {
    boolean whole = announced.imageWidth() > 0 && announced.imageHeight() > 0;
    if (camera.hasPixels() && whole) {
      return announced;
    }
    if (camera.hasPixels()) {
      return withImage(announced);
    }
    notes.add(
        "Of camera "
            + announced.id()
            + " only the position is published: the twin's camera hangs there and looks straight"
            + " down.");
    return CameraRig.lookingDown(
        announced.id(), camera.positionX(), camera.positionY(), camera.positionZ(), view);
  }

  /** An image about its principal point. */
  private static CameraCalibration withImage(CameraCalibration c) {
    return new CameraCalibration(
        c.id(),
        c.focalLength(),
        c.principalPointX(),
        c.principalPointY(),
        c.distortion(),
        c.q0(),
        c.q1(),
        c.q2(),
        c.q3(),
        c.tx(),
        c.ty(),
        c.tz(),
        c.derivedWorldX(),
        c.derivedWorldY(),
        c.derivedWorldZ(),
        Math.max(1, (int) Math.round(2 * c.principalPointX())),
        Math.max(1, (int) Math.round(2 * c.principalPointY())));
  }

  /** Noise on the ground at a place over noise straight below the camera, if it is the same everywhere in the image. */
  private static double factor(Camera camera, double x, double y) {
    double[] here = new double[4];
    double[] below = new double[4];
    camera.groundPerPixel(x, y, here);
    camera.groundPerPixel(camera.positionX(), camera.positionY(), below);
    double ratio = Math.sqrt(squares(here) / squares(below));
    return Double.isFinite(ratio) && ratio > 0 ? ratio : 1;
  }

  private static double squares(double[] values) {
    return DoubleStream.of(values).map(v -> v * v).sum();
  }

  /** Whichever leaves the smaller scatter of the noise between places. */
  private NoiseGrowth growth(Map<Integer, CameraCalibration> published) {
    double inImage = 0;
    double onGround = 0;
    for (Map.Entry<Integer, CameraCalibration> entry : published.entrySet()) {
      int id = entry.getKey();
      CameraCalibration c = entry.getValue();
      Camera camera = Camera.of(c);
      if (!camera.hasPixels()) {
        camera =
            Camera.of(
                CameraRig.lookingDown(
                    id,
                    camera.positionX(),
                    camera.positionY(),
                    camera.positionZ(),
                    view(frames(id))));
      }
      List<Double> ground = new ArrayList<>();
      List<Double> image = new ArrayList<>();
      for (Stretch s : rests) {
        if (s.camera() == id && s.sigma() > 0) {
          ground.add(Math.log(s.sigma()));
          image.add(Math.log(s.sigma() / factor(camera, s.x(), s.y())));
        }
      }
      if (ground.size() > 1) {
        inImage += scatter(image) * image.size();
        onGround += scatter(ground) * ground.size();
      }
    }
    return onGround < inImage ? NoiseGrowth.NONE : NoiseGrowth.IMAGE;
  }

  private static double scatter(List<Double> values) {
    return StatUtils.variance(values.stream().mapToDouble(v -> v).toArray());
  }

  private double noise(int id, Camera camera, NoiseGrowth growth) {
    double[] below =
        rests.stream()
            .filter(s -> s.camera() == id)
            .mapToDouble(
                s -> s.sigma() / (growth == NoiseGrowth.IMAGE ? factor(camera, s.x(), s.y()) : 1))
            .toArray();
    if (below.length > 0) {
      // Not the mean: before a few kicks the ball is not quite at rest.
      return StatUtils.percentile(below, 50);
    }
    notes.add(
        "Camera "
            + id
            + " saw no resting ball; its noise is estimated from the residuals of the kicks.");
    return field.calibration().calibration().cameras().get(id).noise();
  }

  /** Noise from second differences of frames that follow each other; motion hardly shows in them. */
  private static double robotNoise(
      List<VisionFrame> frames, FrameStep step, ToDoubleFunction<RobotDetection> what) {
    Map<RobotId, double[]> last = new HashMap<>();
    List<Double> differences = new ArrayList<>();
    for (VisionFrame frame : frames) {
      for (RobotDetection robot : frame.robots()) {
        double value = what.applyAsDouble(robot);
        double[] h = last.computeIfAbsent(robot.id(), k -> new double[] {UNSEEN, UNSEEN, 0, 0});
        long number = frame.frameNumber();
        boolean follows = number > h[1] && step.missing((long) h[1], number) == 0;
        if (follows && step.missing((long) h[0], (long) h[1]) == 0 && Double.isFinite(value)) {
          differences.add(Math.abs(Math.IEEEremainder(h[2] - 2 * h[3] + value, 2 * Math.PI)));
        }
        h[0] = h[1];
        h[1] = number;
        h[2] = h[3];
        h[3] = value;
      }
    }
    if (differences.isEmpty()) {
      return 0;
    }
    double median = StatUtils.percentile(differences.stream().mapToDouble(d -> d).toArray(), 50);
    return Math.min(0.1, MAD * median / SECOND_DIFFERENCE);
  }

  private static double sent(List<VisionFrame> frames) {
    double[] delays = delays(frames);
    return delays.length == 0
        ? Double.NaN
        : Math.max(0, StatUtils.mean(delays) - HALF_NORMAL_MEAN * sentSpread(frames));
  }

  private static double sentSpread(List<VisionFrame> frames) {
    double[] delays = delays(frames);
    return delays.length < 2
        ? 0
        : Math.min(1, Math.sqrt(StatUtils.variance(delays)) / HALF_NORMAL_DEVIATION);
  }

  private static double[] delays(List<VisionFrame> frames) {
    return frames.stream()
        .mapToDouble(f -> f.sentTime() - f.captureTime())
        .filter(d -> Double.isFinite(d) && d >= 0 && d < 1)
        .toArray();
  }

  private Nuisance nuisance(int id, List<VisionFrame> frames, FrameStep step, double rate) {
    long single = 0;
    long interruptions = 0;
    long robotsLost = 0;
    long robotsSeen = 0;
    Map<RobotId, Long> lastSeen = new HashMap<>();
    VisionFrame before = null;
    for (VisionFrame frame : frames) {
      long missing = before == null ? 0 : step.missing(before.frameNumber(), frame.frameNumber());
      boolean follows =
          before != null
              && frame.captureTime() > before.captureTime()
              && frame.captureTime() - before.captureTime() < GAP;
      if (follows && missing > 0) {
        single += missing < INTERRUPTION ? missing : 0;
        interruptions += missing < INTERRUPTION ? 0 : 1;
      }
      for (RobotDetection robot : frame.robots()) {
        Long last = lastSeen.put(robot.id(), frame.frameNumber());
        if (follows && last != null && missing == 0) {
          long unseen = step.missing(last, frame.frameNumber());
          robotsLost += unseen > 0 && unseen < INTERRUPTION ? unseen : 0;
          robotsSeen++;
        }
      }
      before = frame;
    }
    double n = Math.max(1, frames.size());
    FalseBallCount strange = FalseBallCount.of(field, id);
    long duplicates = field.frames().stream().mapToLong(RecordedFrames::duplicates).sum();
    long all =
        field.frames().stream()
            .flatMap(f -> f.frames().values().stream())
            .mapToLong(List::size)
            .sum();
    return new Nuisance(
        strange.singles(),
        strange.series(),
        missedBalls(id),
        share(robotsLost, robotsLost + robotsSeen),
        share(single, n + single),
        interruptions * rate / n,
        jitter(frames, step),
        0,
        share(duplicates, Math.max(1, all)),
        true,
        List.of());
  }

  /** Deviation of exposures from an even pace that gives the measured scatter of the time between two frames. */
  private static double jitter(List<VisionFrame> frames, FrameStep step) {
    List<Double> intervals = new ArrayList<>();
    for (int i = 1; i < frames.size(); i++) {
      double interval = frames.get(i).captureTime() - frames.get(i - 1).captureTime();
      long missing = step.missing(frames.get(i - 1).frameNumber(), frames.get(i).frameNumber());
      if (missing == 0 && interval > 0 && interval < GAP) {
        intervals.add(interval);
      }
    }
    return intervals.size() < 2 ? 0 : Math.sqrt(scatter(intervals) / 2);
  }

  private static double share(double part, double all) {
    return all <= 0 ? 0 : Math.min(1, part / all);
  }

  private double missedBalls(int id) {
    long frames = 0;
    long seen = 0;
    for (Stretch s : rests) {
      if (s.camera() == id) {
        frames += s.frames();
        seen += s.detections();
      }
    }
    return share(frames - seen, frames);
  }

  /**
   * Balls that are none, while kicks are observed.
   *
   * @param singles per frame, those that stand alone
   * @param series per frame, begins of series at one place
   */
  private record FalseBallCount(double singles, double series) {
    /** Two false balls so near in place and time belong to one series. */
    private static final double NEAR = 0.15;

    private static final double SOON = 0.2;

    static FalseBallCount of(FieldRecording field, int camera) {
      long frames = 0;
      long singles = 0;
      long series = 0;
      for (RecordedFrames one : field.frames()) {
        for (Kick kick : field.kicks(one)) {
          List<double[]> strange = new ArrayList<>();
          frames += collect(one, camera, kick, strange);
          int run = 0;
          for (int i = 0; i < strange.size(); i++) {
            boolean follows = i > 0 && near(strange.get(i - 1), strange.get(i));
            run = follows ? run + 1 : 1;
            boolean ends = i + 1 == strange.size() || !near(strange.get(i), strange.get(i + 1));
            if (ends) {
              singles += run == 1 ? 1 : 0;
              series += run > 1 ? 1 : 0;
            }
          }
        }
      }
      return new FalseBallCount(share(singles, frames), share(series, frames));
    }

    private static boolean near(double[] a, double[] b) {
      return b[0] - a[0] < SOON && Math.hypot(a[1] - b[1], a[2] - b[2]) < NEAR;
    }

    private static long collect(RecordedFrames one, int camera, Kick kick, List<double[]> strange) {
      Observations seen = kick.observations();
      double from = seen.size() == 0 ? kick.time() : seen.time(0);
      long frames = 0;
      for (VisionFrame frame : one.frames().getOrDefault(camera, List.of())) {
        if (frame.captureTime() < from || frame.captureTime() > kick.endTime()) {
          continue;
        }
        frames++;
        for (BallDetection ball : one.strangeBalls(frame, kick)) {
          strange.add(new double[] {frame.captureTime(), ball.x(), ball.y()});
        }
      }
      return frames;
    }
  }

  /** The calibrations by camera that were published. */
  static Map<Integer, CameraCalibration> published(FieldRecording field) {
    Map<Integer, CameraCalibration> all = new HashMap<>();
    Optional.ofNullable(field.calibration().data().geometry().orElse(null))
        .ifPresent(g -> g.cameras().forEach(c -> all.put(c.id(), c)));
    return all;
  }
}
