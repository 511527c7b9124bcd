package fieldcal.vision;

import fieldcal.camera.CameraCalibration;
import fieldcal.proto.SSL_DetectionBall;
import fieldcal.proto.SSL_DetectionFrame;
import fieldcal.proto.SSL_DetectionRobot;
import fieldcal.proto.SSL_FieldCircularArc;
import fieldcal.proto.SSL_FieldLineSegment;
import fieldcal.proto.SSL_GeometryCameraCalibration;
import fieldcal.proto.SSL_GeometryData;
import fieldcal.proto.SSL_GeometryFieldSize;
import fieldcal.proto.SSL_WrapperPacket;
import fieldcal.proto.Vector2f;
import java.util.Objects;

/**
 * Encodes values in SI units as vision's messages; the inverse of {@link VisionDecoder}.
 *
 * <p>The messages carry 32-bit floats in mm. A value that came from a message returns to exactly the same bits. Immutable.
 */
public final class VisionEncoder {
  private static final double MM_PER_M = 1000.0;

  private final Epoch epoch;

  /**
   * Creates an encoder.
   *
   * @param epoch the instant that the frames' times count from
   */
  public VisionEncoder(Epoch epoch) {
    this.epoch = Objects.requireNonNull(epoch, "epoch");
  }

  /**
   * Encodes a packet.
   *
   * @param packet what to send
   * @return the bytes of a {@code SSL_WrapperPacket}
   */
  public byte[] encode(VisionPacket packet) {
    return toMessage(packet).toByteArray();
  }

  /**
   * The message of a packet.
   *
   * @param packet what to send
   * @return the message
   */
  public SSL_WrapperPacket toMessage(VisionPacket packet) {
    SSL_WrapperPacket.Builder message = SSL_WrapperPacket.newBuilder();
    packet.frame().ifPresent(frame -> message.setDetection(toMessage(frame)));
    packet.geometry().ifPresent(geometry -> message.setGeometry(toMessage(geometry)));
    return message.build();
  }

  /**
   * The message of a frame. Absent values (NaN) stay absent; the robots' pixels, which {@link RobotDetection} does not keep but the
   * message requires, are 0; an absent sending time becomes the capture time.
   *
   * @param frame what a camera saw
   * @return the message
   */
  public SSL_DetectionFrame toMessage(VisionFrame frame) {
    double sent = Double.isNaN(frame.sentTime()) ? frame.captureTime() : frame.sentTime();
    SSL_DetectionFrame.Builder message =
        SSL_DetectionFrame.newBuilder()
            .setFrameNumber((int) frame.frameNumber())
            .setTCapture(epoch.unixSeconds(frame.captureTime()))
            .setTSent(epoch.unixSeconds(sent))
            .setCameraId(frame.cameraId());
    if (!Double.isNaN(frame.cameraClockTime())) {
      message.setTCaptureCamera(frame.cameraClockTime());
    }
    for (BallDetection ball : frame.balls()) {
      message.addBalls(toMessage(ball));
    }
    for (RobotDetection robot : frame.robots()) {
      if (robot.id().team() == Team.YELLOW) {
        message.addRobotsYellow(toMessage(robot));
      } else {
        message.addRobotsBlue(toMessage(robot));
      }
    }
    return message.build();
  }

  /**
   * The message of a geometry.
   *
   * @param geometry the field
   * @return the message; sizes of the field are rounded to whole mm, as it demands
   */
  public static SSL_GeometryData toMessage(FieldGeometry geometry) {
    SSL_GeometryFieldSize.Builder field =
        SSL_GeometryFieldSize.newBuilder()
            .setFieldLength(wholeMm(geometry.length()))
            .setFieldWidth(wholeMm(geometry.width()))
            .setGoalWidth(wholeMm(geometry.goalWidth()))
            .setGoalDepth(wholeMm(geometry.goalDepth()))
            .setBoundaryWidth(wholeMm(geometry.boundaryWidth()));
    geometry.lines().forEach(line -> field.addFieldLines(toMessage(line)));
    geometry.arcs().forEach(arc -> field.addFieldArcs(toMessage(arc)));
    SSL_GeometryData.Builder message = SSL_GeometryData.newBuilder().setField(field);
    geometry.cameras().forEach(camera -> message.addCalib(toMessage(camera)));
    BallModels models = new BallModels(geometry.flat(), geometry.chip());
    if (!models.equals(BallModels.NONE)) {
      message.setModels(models.toMessage());
    }
    return message.build();
  }

  /**
   * The message of a camera calibration.
   *
   * @param camera the calibration
   * @return the message
   */
  public static SSL_GeometryCameraCalibration toMessage(CameraCalibration camera) {
    SSL_GeometryCameraCalibration.Builder message =
        SSL_GeometryCameraCalibration.newBuilder()
            .setCameraId(camera.id())
            .setFocalLength((float) camera.focalLength())
            .setPrincipalPointX((float) camera.principalPointX())
            .setPrincipalPointY((float) camera.principalPointY())
            .setDistortion((float) camera.distortion())
            .setQ0((float) camera.q0())
            .setQ1((float) camera.q1())
            .setQ2((float) camera.q2())
            .setQ3((float) camera.q3())
            .setTx(mm(camera.tx()))
            .setTy(mm(camera.ty()))
            .setTz(mm(camera.tz()));
    if (camera.hasDerivedPosition()) {
      message
          .setDerivedCameraWorldTx(mm(camera.derivedWorldX()))
          .setDerivedCameraWorldTy(mm(camera.derivedWorldY()))
          .setDerivedCameraWorldTz(mm(camera.derivedWorldZ()));
    }
    if (camera.imageWidth() > 0) {
      message.setPixelImageWidth(camera.imageWidth());
    }
    if (camera.imageHeight() > 0) {
      message.setPixelImageHeight(camera.imageHeight());
    }
    return message.build();
  }

  private static SSL_DetectionBall toMessage(BallDetection ball) {
    SSL_DetectionBall.Builder message =
        SSL_DetectionBall.newBuilder()
            .setConfidence((float) ball.confidence())
            .setX(mm(ball.x()))
            .setY(mm(ball.y()))
            .setPixelX(orZero(ball.pixelX()))
            .setPixelY(orZero(ball.pixelY()));
    if (ball.area() > 0) {
      message.setArea(ball.area());
    }
    if (ball.hasHeight()) {
      message.setZ(mm(ball.z()));
    }
    return message.build();
  }

  private static SSL_DetectionRobot toMessage(RobotDetection robot) {
    SSL_DetectionRobot.Builder message =
        SSL_DetectionRobot.newBuilder()
            .setConfidence((float) robot.confidence())
            .setRobotId(robot.id().number())
            .setX(mm(robot.x()))
            .setY(mm(robot.y()))
            .setPixelX(0)
            .setPixelY(0);
    if (!Double.isNaN(robot.orientation())) {
      message.setOrientation((float) robot.orientation());
    }
    if (!Double.isNaN(robot.height())) {
      message.setHeight(mm(robot.height()));
    }
    return message.build();
  }

  private static SSL_FieldLineSegment toMessage(FieldLine line) {
    return SSL_FieldLineSegment.newBuilder()
        .setName(line.name())
        .setP1(point(line.x1(), line.y1()))
        .setP2(point(line.x2(), line.y2()))
        .setThickness(mm(line.thickness()))
        .build();
  }

  private static SSL_FieldCircularArc toMessage(FieldArc arc) {
    return SSL_FieldCircularArc.newBuilder()
        .setName(arc.name())
        .setCenter(point(arc.x(), arc.y()))
        .setRadius(mm(arc.radius()))
        .setA1((float) arc.startAngle())
        .setA2((float) arc.endAngle())
        .setThickness(mm(arc.thickness()))
        .build();
  }

  private static Vector2f point(double x, double y) {
    return Vector2f.newBuilder().setX(mm(x)).setY(mm(y)).build();
  }

  private static float mm(double metres) {
    return (float) (metres * MM_PER_M);
  }

  private static int wholeMm(double metres) {
    return (int) Math.round(metres * MM_PER_M);
  }

  private static float orZero(double value) {
    return Double.isNaN(value) ? 0 : (float) value;
  }
}
