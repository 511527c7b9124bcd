package fieldcal.simulation.imaging;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.physics.Region;
import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;

/** One camera and the vision computer behind it. Not thread-safe. */
public final class SimulatedCamera {
  /** From exposure to the detections leaving vision: image transfer and processing, s (chosen: what logs of 2026 show). */
  private static final double LATENCY = 0.011;

  private static final double LATENCY_SPREAD = 0.0008;

  /** Numbers that a robot's pattern can have (rules of the league). */
  private static final int PATTERNS = 16;

  private final CameraCalibration trueCalibration;
  private final CameraCalibration publishedCalibration;
  private final Camera trueCamera;
  private final Camera publishedCamera;
  private final InstalledCamera installed;
  private final CameraErrors errors;
  private final double rollingShutter;
  private final double ballPlane;
  private final Nuisance nuisance;
  private final RandomStream misreads;
  private final boolean noiseInImage;

  /** Standard deviation of a ball's position: pixels if the noise is added in the image, otherwise m. */
  private final double noise;

  private final RandomStream timing;
  private final RandomStream transfer;
  private final RandomStream sensor;
  private final RandomStream robotSensor;
  private final FalseBalls falseBalls;
  private final double[] ball = new double[3];
  private final double[] pixel = new double[2];
  private final double[] ground = new double[2];
  private final double[] shift = new double[2];

  private long index;
  private double exposure;
  private double stamp;
  private double sent;
  private boolean lost;
  private double blindUntil = Double.NEGATIVE_INFINITY;

  private SimulatedCamera(
      CameraCalibration trueCalibration,
      InstalledCamera installed,
      Beat beat,
      double rollingShutter,
      double ballPlane,
      long seed) {
    this.trueCalibration = trueCalibration;
    this.installed = installed;
    this.rollingShutter = rollingShutter;
    this.ballPlane = ballPlane;
    publishedCalibration = installed.vision();
    errors = installed.errors();
    nuisance = installed.nuisance();
    trueCamera = Camera.of(trueCalibration);
    publishedCamera = Camera.of(publishedCalibration, ballPlane);
    noiseInImage = installed.noiseGrowth() == InstalledCamera.NoiseGrowth.IMAGE;
    noise =
        noiseInImage
            ? installed.ballNoise()
                * trueCalibration.focalLength()
                / trueCamera.heightAboveBallPlane()
            : installed.ballNoise();
    String name = " of camera " + trueCalibration.id();
    timing = beat.timing();
    transfer =
        beat.exposure() == CameraSettings.Exposure.TOGETHER
            ? RandomStream.of(seed, "transfer" + name)
            : timing;
    sensor = RandomStream.of(seed, "balls" + name);
    robotSensor = RandomStream.of(seed, "robots" + name);
    misreads = RandomStream.of(seed, "misread patterns" + name);
    falseBalls = new FalseBalls(nuisance, RandomStream.of(seed, "false balls" + name));
    // A session may begin late on its clock.
    index = (long) Math.ceil((beat.from() - installed.phase()) * installed.rate()) - 1;
    advance();
  }

  /**
   * When a camera takes its frames.
   *
   * @param exposure whether all cameras share the beat
   * @param timing random numbers of the beat
   * @param from session time of the first frame, s
   */
  record Beat(CameraSettings.Exposure exposure, RandomStream timing, double from) {
    static Beat of(long seed, int camera, CameraSettings.Exposure exposure, double from) {
      boolean together = exposure == CameraSettings.Exposure.TOGETHER;
      String purpose = together ? "timing of all cameras" : "timing of camera " + camera;
      return new Beat(exposure, RandomStream.of(seed, purpose), from);
    }
  }

  /** A camera whose true pose is known; what vision believes follows from its errors. */
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
    CameraCalibration vision =
        published.calibration(
            id,
            lens.withDistortion(lens.distortion() + errors.distortionError()),
            CameraRig.IMAGE_WIDTH,
            CameraRig.IMAGE_HEIGHT);
    Beat beat = Beat.of(seed, id, settings.exposure(), 0);
    double rate = beat.timing().uniform(settings.rateMin(), settings.rateMax());
    double phase = beat.timing().uniform(0, 1 / rate);
    InstalledCamera installed =
        new InstalledCamera(
            vision,
            vision,
            true,
            Region.NONE,
            settings.ballNoise(),
            InstalledCamera.NoiseGrowth.IMAGE,
            settings.robotNoise(),
            settings.robotAngleNoise(),
            rate,
            phase,
            LATENCY,
            LATENCY_SPREAD,
            nuisance,
            errors);
    return new SimulatedCamera(
        pose.calibration(id, lens, CameraRig.IMAGE_WIDTH, CameraRig.IMAGE_HEIGHT),
        installed,
        beat,
        rollingShutter,
        settings.ballPlane(),
        seed);
  }

  /** A camera whose calibration in vision is known; its true pose follows from its errors. */
  static SimulatedCamera create(
      InstalledCamera camera,
      CameraErrors more,
      double rollingShutter,
      CameraSettings settings,
      double from,
      long seed) {
    CameraErrors errors = camera.errors().plus(more);
    CameraCalibration vision = camera.vision();
    boolean hangsRight =
        errors.tilt() == 0
            && errors.shiftX() == 0
            && errors.shiftY() == 0
            && errors.heightError() == 0
            && errors.distortionError() == 0;
    CameraCalibration truth =
        hangsRight
            ? vision
            : Pose.of(vision)
                .moved(-errors.shiftX(), -errors.shiftY(), -errors.heightError())
                .tilted(-errors.tilt(), errors.tiltAxis())
                .calibration(
                    vision.id(),
                    Pose.Lens.of(vision)
                        .withDistortion(vision.distortion() - errors.distortionError()),
                    vision.imageWidth(),
                    vision.imageHeight());
    Beat beat = Beat.of(seed, vision.id(), settings.exposure(), from);
    return new SimulatedCamera(
        truth, camera.withErrors(errors), beat, rollingShutter, settings.ballPlane(), seed);
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
   * The camera as the geometry messages announce it.
   *
   * @return the announced calibration
   */
  public CameraCalibration announcedCalibration() {
    CameraErrors.Misstated aside = errors.misstated();
    return Pose.displaced(installed.announced(), aside.x(), aside.y(), aside.height());
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
    return installed.rate();
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
    double rate = installed.rate();
    double beat = installed.phase() + index / rate;
    exposure = beat + limited(timing.gaussian(nuisance.jitter()));
    stamp =
        exposure + limited(timing.gaussian(nuisance.stampNoise())) + errors.stampErrorAt(exposure);
    sent = exposure + installed.latency() + Math.abs(transfer.gaussian(installed.latencySpread()));
    if (transfer.happens(nuisance.burstRate() / rate)) {
      blindUntil = beat + transfer.uniform(0.05, 0.4);
    }
    boolean dropped = transfer.happens(nuisance.frameDrop());
    boolean gone = nuisance.outages().stream().anyMatch(o -> o.covers(trueCalibration.id(), beat));
    lost = dropped || gone || beat < blindUntil;
  }

  /** Frames must stay in order. */
  private double limited(double deviation) {
    double most = 0.4 / installed.rate();
    return Math.max(-most, Math.min(most, deviation));
  }

  private void seeBall(Scene scene, List<RobotView> robots, List<BallDetection> balls) {
    // All numbers are drawn first, so that what a frame shows does not change the next one.
    double noiseU = sensor.gaussian(noise);
    double noiseV = sensor.gaussian(noise);
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
        report(
            pixel[0] + (noiseInImage ? noiseU : 0),
            pixel[1] + (noiseInImage ? noiseV : 0),
            noiseInImage ? 0 : noiseU,
            noiseInImage ? 0 : noiseV,
            (int) Math.round(area),
            confidence * share);
    if (seen != null && inView(seen.x(), seen.y())) {
      balls.add(seen);
    }
  }

  private boolean inView(double x, double y) {
    Region view = installed.view();
    return view.equals(Region.NONE) || view.contains(x, y);
  }

  /** A ball as vision reports it; null when the published calibration has no ground there. */
  BallDetection report(double u, double v, int area, double confidence) {
    return report(u, v, 0, 0, area, confidence);
  }

  private BallDetection report(
      double u, double v, double noiseX, double noiseY, int area, double confidence) {
    publishedCamera.pixelToPlane(u, v, ballPlane - Camera.BALL_RADIUS, ground);
    if (!Double.isFinite(ground[0]) || !Double.isFinite(ground[1])) {
      return null;
    }
    shift();
    boolean pixels = installed.reportsPixels();
    return new BallDetection(
        Millimetres.rounded(ground[0] + shift[0] + noiseX),
        Millimetres.rounded(ground[1] + shift[1] + noiseY),
        Double.NaN,
        (float) confidence,
        area,
        pixels ? (float) u : 0,
        pixels ? (float) v : 0);
  }

  /** Computes by how much a report at the present place on the ground is shifted. */
  private void shift() {
    errors.shiftAt(
        exposure,
        ground[0] - publishedCamera.positionX(),
        ground[1] - publishedCamera.positionY(),
        publishedCamera.positionZ(),
        shift);
  }

  /** Where a point of the world appears in the image; false when it does not. */
  boolean imageOf(double x, double y, double z, double[] result) {
    trueCamera.worldToPixel(x, y, z - Camera.BALL_RADIUS, result);
    return inImage(result[0], result[1]);
  }

  private void seeRobot(RobotView robot, List<RobotDetection> detections) {
    double noiseX = robotSensor.gaussian(installed.robotNoise());
    double noiseY = robotSensor.gaussian(installed.robotNoise());
    double noiseAngle = robotSensor.gaussian(installed.robotAngleNoise());
    boolean missed = robotSensor.happens(nuisance.robotMiss());
    double confidence = robotSensor.uniform(0.8, 1);
    if (missed || !imageOf(robot.x(), robot.y(), robot.height(), pixel)) {
      return;
    }
    publishedCamera.pixelToPlane(pixel[0], pixel[1], robot.height() - Camera.BALL_RADIUS, ground);
    if (!Double.isFinite(ground[0]) || !Double.isFinite(ground[1])) {
      return;
    }
    shift();
    double x = ground[0] + shift[0] + noiseX;
    double y = ground[1] + shift[1] + noiseY;
    if (!inView(x, y)) {
      return;
    }
    RobotId id = robot.id();
    double orientation = robot.orientation() + noiseAngle;
    if (misreads.happens(nuisance.robotMisread())) {
      if (misreads.happens(0.5)) {
        id = new RobotId(id.team(), (id.number() + 1 + misreads.below(PATTERNS - 1)) % PATTERNS);
      } else {
        orientation += misreads.happens(0.5) ? Math.PI / 2 : -Math.PI / 2;
      }
    }
    double turn = Math.IEEEremainder(orientation, 2 * Math.PI);
    detections.add(
        new RobotDetection(
            id,
            Millimetres.rounded(x),
            Millimetres.rounded(y),
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
