package fieldcal.simulation.imaging;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.RandomStream;
import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;

/** One camera and the vision computer behind it. Not thread-safe. */
public final class SimulatedCamera {
  /** From exposure to the detections leaving vision: image transfer and processing, s (chosen: what logs of 2026 show). */
  private static final double LATENCY = 0.011;

  private static final double LATENCY_SPREAD = 0.0008;

  private final CameraCalibration trueCalibration;
  private final CameraCalibration publishedCalibration;
  private final Camera trueCamera;
  private final Camera publishedCamera;
  private final CameraErrors errors;
  private final double rollingShutter;
  private final CameraSettings settings;
  private final Nuisance nuisance;
  private final double pixelNoise;
  private final double rate;
  private final double phase;
  private final RandomStream timing;
  private final RandomStream transfer;
  private final RandomStream sensor;
  private final RandomStream robotSensor;
  private final FalseBalls falseBalls;
  private final double[] ball = new double[3];
  private final double[] pixel = new double[2];
  private final double[] ground = new double[2];

  private long index = -1;
  private double exposure;
  private double stamp;
  private double sent;
  private boolean lost;
  private double blindUntil = Double.NEGATIVE_INFINITY;

  private SimulatedCamera(
      CameraCalibration trueCalibration,
      CameraCalibration publishedCalibration,
      CameraErrors errors,
      double rollingShutter,
      CameraSettings settings,
      Nuisance nuisance,
      long seed) {
    this.trueCalibration = trueCalibration;
    this.publishedCalibration = publishedCalibration;
    this.errors = errors;
    this.rollingShutter = rollingShutter;
    this.settings = settings;
    this.nuisance = nuisance;
    trueCamera = Camera.of(trueCalibration);
    publishedCamera = Camera.of(publishedCalibration, settings.ballPlane());
    pixelNoise =
        settings.ballNoise() * trueCalibration.focalLength() / trueCamera.heightAboveBallPlane();
    String name = " of camera " + trueCalibration.id();
    boolean together = settings.exposure() == CameraSettings.Exposure.TOGETHER;
    timing = RandomStream.of(seed, together ? "timing of all cameras" : "timing" + name);
    transfer = together ? RandomStream.of(seed, "transfer" + name) : timing;
    sensor = RandomStream.of(seed, "balls" + name);
    robotSensor = RandomStream.of(seed, "robots" + name);
    falseBalls = new FalseBalls(nuisance, RandomStream.of(seed, "false balls" + name));
    rate = timing.uniform(settings.rateMin(), settings.rateMax());
    phase = timing.uniform(0, 1 / rate);
    advance();
  }

  static SimulatedCamera create(
      int id,
      Pose pose,
      Pose.Lens lens,
      CameraErrors errors,
      double rollingShutter,
      CameraSettings settings,
      Nuisance nuisance,
      long seed) {
    Pose published =
        pose.tilted(errors.tilt(), errors.tiltAxis())
            .moved(errors.shiftX(), errors.shiftY(), errors.heightError());
    Pose.Lens publishedLens =
        new Pose.Lens(
            lens.focalLength(),
            lens.principalX(),
            lens.principalY(),
            lens.distortion() + errors.distortionError());
    int width = CameraRig.IMAGE_WIDTH;
    int height = CameraRig.IMAGE_HEIGHT;
    return new SimulatedCamera(
        pose.calibration(id, lens, width, height),
        published.calibration(id, publishedLens, width, height),
        errors,
        rollingShutter,
        settings,
        nuisance,
        seed);
  }

  /**
   * The camera as it is.
   *
   * @return the true calibration
   */
  public CameraCalibration trueCalibration() {
    return trueCalibration;
  }

  /**
   * The camera as vision believes it to be.
   *
   * @return the published calibration
   */
  public CameraCalibration publishedCalibration() {
    return publishedCalibration;
  }

  /**
   * What is wrong with it, the contradiction between cameras included.
   *
   * @return the errors
   */
  public CameraErrors errors() {
    return errors;
  }

  /**
   * Frame rate.
   *
   * @return 1/s
   */
  public double rate() {
    return rate;
  }

  /**
   * When the next frame is exposed.
   *
   * @return session time, s
   */
  public double nextExposure() {
    return exposure;
  }

  /**
   * How long after {@link #nextExposure} the scene must be known.
   *
   * @return s
   */
  public double exposureSpan() {
    return Math.max(0, rollingShutter);
  }

  /**
   * Takes the next frame and moves on.
   *
   * @param scene what there is to see
   * @param frames gets no frame when it is lost, two when it is duplicated
   */
  public void expose(Scene scene, List<VisionFrame> frames) {
    List<RobotView> robots = scene.robotsAt(exposure);
    List<BallDetection> balls = new ArrayList<>(2);
    seeBall(scene, robots, balls);
    List<RobotDetection> detections = new ArrayList<>(robots.size());
    for (RobotView robot : robots) {
      seeRobot(robot, detections);
    }
    falseBalls.addTo(balls, robots, this);
    if (!lost) {
      VisionFrame frame =
          new VisionFrame(trueCalibration.id(), index, stamp, sent, Double.NaN, balls, detections);
      frames.add(frame);
      if (transfer.happens(nuisance.duplicates())) {
        frames.add(frame);
      }
    }
    advance();
  }

  private void advance() {
    index++;
    double beat = phase + index / rate;
    exposure = beat + limited(timing.gaussian(nuisance.jitter()));
    stamp =
        exposure
            + limited(timing.gaussian(nuisance.stampNoise()))
            + errors.timeOffset()
            + errors.clockSkew() * exposure;
    sent = exposure + LATENCY + Math.abs(transfer.gaussian(LATENCY_SPREAD));
    if (transfer.happens(nuisance.burstRate() / rate)) {
      blindUntil = beat + transfer.uniform(0.05, 0.4);
    }
    boolean dropped = transfer.happens(nuisance.frameDrop());
    boolean gone = nuisance.outages().stream().anyMatch(o -> o.covers(trueCalibration.id(), beat));
    lost = dropped || gone || beat < blindUntil;
  }

  /** Frames must stay in order. */
  private double limited(double deviation) {
    double most = 0.4 / rate;
    return Math.max(-most, Math.min(most, deviation));
  }

  private void seeBall(Scene scene, List<RobotView> robots, List<BallDetection> balls) {
    // Draw first: what a frame shows must not change the luck of the next one.
    double noiseU = sensor.gaussian(pixelNoise);
    double noiseV = sensor.gaussian(pixelNoise);
    boolean missed = sensor.happens(nuisance.ballMiss());
    double brightness = sensor.uniform(0.9, 1.1);
    double confidence = sensor.uniform(0.88, 1);
    if (!scene.ballAt(exposure, ball)) {
      return;
    }
    trueCamera.worldToPixel(ball[0], ball[1], ball[2], pixel);
    if (rollingShutter != 0) {
      // The row that sees the ball is exposed later, while the ball moves: two rounds settle it.
      for (int i = 0; i < 2 && Double.isFinite(pixel[1]); i++) {
        double row = Math.max(0, Math.min(1, pixel[1] / trueCalibration.imageHeight()));
        if (!scene.ballAt(exposure + rollingShutter * row, ball)) {
          return;
        }
        trueCamera.worldToPixel(ball[0], ball[1], ball[2], pixel);
      }
    }
    double share = nuisance.shadows() ? Occlusion.visibleShare(trueCamera, ball, robots) : 1;
    if (missed || share < 0.4 || !inImage(pixel[0], pixel[1])) {
      return;
    }
    double scale = trueCalibration.focalLength() / (trueCamera.positionZ() - ball[2]);
    double area =
        Math.PI * Camera.BALL_RADIUS * Camera.BALL_RADIUS * scale * scale * share * brightness;
    BallDetection seen =
        report(pixel[0] + noiseU, pixel[1] + noiseV, (int) Math.round(area), confidence * share);
    if (seen != null) {
      balls.add(seen);
    }
  }

  /** A ball as vision reports it; null when the published calibration has no ground there. */
  BallDetection report(double u, double v, int area, double confidence) {
    float pixelX = (float) u;
    float pixelY = (float) v;
    publishedCamera.pixelToPlane(u, v, settings.ballPlane() - Camera.BALL_RADIUS, ground);
    if (!Double.isFinite(ground[0]) || !Double.isFinite(ground[1])) {
      return null;
    }
    return new BallDetection(
        Millimetres.rounded(ground[0] + shiftX()),
        Millimetres.rounded(ground[1] + errors.shiftYAt(exposure)),
        Double.NaN,
        (float) confidence,
        area,
        pixelX,
        pixelY);
  }

  /** By how much what is seen at the present place on the ground is reported along x, m. */
  private double shiftX() {
    double height = publishedCamera.positionZ();
    double xi = (ground[0] - publishedCalibration.derivedWorldX()) / height;
    double eta = (ground[1] - publishedCalibration.derivedWorldY()) / height;
    return errors.shiftXAt(exposure, xi, eta);
  }

  /** Where a point of the world appears in the image; false when it does not. */
  boolean imageOf(double x, double y, double z, double[] result) {
    trueCamera.worldToPixel(x, y, z - Camera.BALL_RADIUS, result);
    return inImage(result[0], result[1]);
  }

  private void seeRobot(RobotView robot, List<RobotDetection> detections) {
    double noiseX = robotSensor.gaussian(settings.robotNoise());
    double noiseY = robotSensor.gaussian(settings.robotNoise());
    double noiseAngle = robotSensor.gaussian(settings.robotAngleNoise());
    boolean missed = robotSensor.happens(nuisance.robotMiss());
    double confidence = robotSensor.uniform(0.8, 1);
    if (missed || !imageOf(robot.x(), robot.y(), robot.height(), pixel)) {
      return;
    }
    publishedCamera.pixelToPlane(pixel[0], pixel[1], robot.height() - Camera.BALL_RADIUS, ground);
    if (!Double.isFinite(ground[0]) || !Double.isFinite(ground[1])) {
      return;
    }
    double turn = Math.IEEEremainder(robot.orientation() + noiseAngle, 2 * Math.PI);
    detections.add(
        new RobotDetection(
            robot.id(),
            Millimetres.rounded(ground[0] + shiftX() + noiseX),
            Millimetres.rounded(ground[1] + errors.shiftYAt(exposure) + noiseY),
            (float) turn,
            (float) confidence,
            Millimetres.rounded(robot.height())));
  }

  private boolean inImage(double u, double v) {
    return u >= 0
        && v >= 0
        && u < trueCalibration.imageWidth()
        && v < trueCalibration.imageHeight();
  }

  /** A random place in the image. */
  void anywhere(RandomStream random, double[] result) {
    result[0] = random.uniform(0, trueCalibration.imageWidth());
    result[1] = random.uniform(0, trueCalibration.imageHeight());
  }
}
