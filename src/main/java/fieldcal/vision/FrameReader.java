package fieldcal.vision;

import com.google.protobuf.CodedInputStream;
import fieldcal.proto.SSL_DetectionBall;
import fieldcal.proto.SSL_DetectionFrame;
import fieldcal.proto.SSL_DetectionRobot;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads a detection frame straight off the wire.
 *
 * <p>The generated message class would build an object per detection only to be copied from; nearly all bytes of a recording are
 * frames, so this is where its reading time goes. Follows the wire format's rules: fields in any order, unknown ones skipped, the last
 * one of several wins. Not thread-safe.
 */
final class FrameReader {
  private static final int VARINT = 0;
  private static final int FIXED64 = 1;
  private static final int BYTES = 2;
  private static final int FIXED32 = 5;

  private static final int FRAME_NUMBER = tag(SSL_DetectionFrame.FRAME_NUMBER_FIELD_NUMBER, VARINT);
  private static final int T_CAPTURE = tag(SSL_DetectionFrame.T_CAPTURE_FIELD_NUMBER, FIXED64);
  private static final int T_SENT = tag(SSL_DetectionFrame.T_SENT_FIELD_NUMBER, FIXED64);
  private static final int T_CAPTURE_CAMERA =
      tag(SSL_DetectionFrame.T_CAPTURE_CAMERA_FIELD_NUMBER, FIXED64);
  private static final int CAMERA_ID = tag(SSL_DetectionFrame.CAMERA_ID_FIELD_NUMBER, VARINT);
  private static final int BALLS = tag(SSL_DetectionFrame.BALLS_FIELD_NUMBER, BYTES);
  private static final int ROBOTS_YELLOW =
      tag(SSL_DetectionFrame.ROBOTS_YELLOW_FIELD_NUMBER, BYTES);
  private static final int ROBOTS_BLUE = tag(SSL_DetectionFrame.ROBOTS_BLUE_FIELD_NUMBER, BYTES);

  private static final int BALL_CONFIDENCE =
      tag(SSL_DetectionBall.CONFIDENCE_FIELD_NUMBER, FIXED32);
  private static final int BALL_AREA = tag(SSL_DetectionBall.AREA_FIELD_NUMBER, VARINT);
  private static final int BALL_X = tag(SSL_DetectionBall.X_FIELD_NUMBER, FIXED32);
  private static final int BALL_Y = tag(SSL_DetectionBall.Y_FIELD_NUMBER, FIXED32);
  private static final int BALL_Z = tag(SSL_DetectionBall.Z_FIELD_NUMBER, FIXED32);
  private static final int BALL_PIXEL_X = tag(SSL_DetectionBall.PIXEL_X_FIELD_NUMBER, FIXED32);
  private static final int BALL_PIXEL_Y = tag(SSL_DetectionBall.PIXEL_Y_FIELD_NUMBER, FIXED32);

  private static final int ROBOT_CONFIDENCE =
      tag(SSL_DetectionRobot.CONFIDENCE_FIELD_NUMBER, FIXED32);
  private static final int ROBOT_ID = tag(SSL_DetectionRobot.ROBOT_ID_FIELD_NUMBER, VARINT);
  private static final int ROBOT_X = tag(SSL_DetectionRobot.X_FIELD_NUMBER, FIXED32);
  private static final int ROBOT_Y = tag(SSL_DetectionRobot.Y_FIELD_NUMBER, FIXED32);
  private static final int ROBOT_ORIENTATION =
      tag(SSL_DetectionRobot.ORIENTATION_FIELD_NUMBER, FIXED32);
  private static final int ROBOT_HEIGHT = tag(SSL_DetectionRobot.HEIGHT_FIELD_NUMBER, FIXED32);

  /** Latest plausible time, s of Unix time: more seconds do not fit into 64-bit nanoseconds. */
  private static final double MAX_UNIX_SECONDS = 9.2e9;

  private static final int ABSENT = -1;
  private static final double MM_PER_M = 1000.0;

  private final Epoch epoch;
  private final DecodingCounts counts;
  private final RobotId[][] robotIds =
      new RobotId[Team.values().length][VisionDecoder.MAX_ROBOT_NUMBER + 1];
  private final List<BallDetection> balls = new ArrayList<>();
  private final List<RobotDetection> robots = new ArrayList<>();
  private final List<RobotDetection> blueRobots = new ArrayList<>();

  FrameReader(Epoch epoch, DecodingCounts counts) {
    this.epoch = epoch;
    this.counts = counts;
  }

  /** Reads up to the current limit; null if the frame is unusable, which is then counted. */
  VisionFrame read(CodedInputStream in) throws IOException {
    balls.clear();
    robots.clear();
    blueRobots.clear();
    long number = 0;
    double capture = Double.NaN;
    boolean hasCapture = false;
    double sent = Double.NaN;
    boolean hasSent = false;
    double cameraClock = Double.NaN;
    long camera = ABSENT;
    for (int tag = in.readTag(); tag != 0; tag = in.readTag()) {
      if (tag == BALLS) {
        readBall(in);
      } else if (tag == ROBOTS_YELLOW) {
        readRobot(in, Team.YELLOW, robots);
      } else if (tag == ROBOTS_BLUE) {
        readRobot(in, Team.BLUE, blueRobots);
      } else if (tag == FRAME_NUMBER) {
        number = Integer.toUnsignedLong(in.readUInt32());
      } else if (tag == T_CAPTURE) {
        capture = in.readDouble();
        hasCapture = true;
      } else if (tag == T_SENT) {
        sent = in.readDouble();
        hasSent = true;
      } else if (tag == CAMERA_ID) {
        camera = Integer.toUnsignedLong(in.readUInt32());
      } else if (tag == T_CAPTURE_CAMERA) {
        cameraClock = in.readDouble();
      } else {
        skip(in, tag);
      }
    }
    if (!isUsable(hasCapture && camera != ABSENT, camera, capture)) {
      return null;
    }
    if (hasSent && !isUnixTime(sent)) {
      counts.add(DecodingProblem.BAD_SENT_TIME);
      sent = Double.NaN;
    }
    robots.addAll(blueRobots);
    double cameraTime = Double.isFinite(cameraClock) ? cameraClock : Double.NaN;
    return new VisionFrame(
        (int) camera,
        number,
        epoch.seconds(capture),
        epoch.seconds(sent),
        cameraTime,
        balls,
        robots);
  }

  /** Whether the frame can be used; counts the reason if not. */
  private boolean isUsable(boolean complete, long camera, double capture) {
    if (!complete) {
      counts.add(DecodingProblem.INCOMPLETE_FRAME);
    } else if (camera > VisionDecoder.MAX_CAMERA_ID) {
      counts.add(DecodingProblem.BAD_CAMERA_ID);
    } else if (!isUnixTime(capture)) {
      counts.add(DecodingProblem.BAD_CAPTURE_TIME);
    } else {
      return true;
    }
    return false;
  }

  private void readBall(CodedInputStream in) throws IOException {
    int oldLimit = in.pushLimit(in.readRawVarint32());
    float confidence = 1;
    int area = 0;
    float x = 0;
    float y = 0;
    boolean hasX = false;
    boolean hasY = false;
    float z = Float.NaN;
    float pixelX = Float.NaN;
    float pixelY = Float.NaN;
    for (int tag = in.readTag(); tag != 0; tag = in.readTag()) {
      if (tag == BALL_X) {
        x = in.readFloat();
        hasX = true;
      } else if (tag == BALL_Y) {
        y = in.readFloat();
        hasY = true;
      } else if (tag == BALL_CONFIDENCE) {
        confidence = readDetail(in);
      } else if (tag == BALL_AREA) {
        area = in.readUInt32();
      } else if (tag == BALL_PIXEL_X) {
        pixelX = readDetail(in);
      } else if (tag == BALL_PIXEL_Y) {
        pixelY = readDetail(in);
      } else if (tag == BALL_Z) {
        z = readDetail(in);
      } else {
        skip(in, tag);
      }
    }
    in.checkLastTagWas(0);
    in.popLimit(oldLimit);
    if (!isUsable(hasX && hasY, x, y, DecodingProblem.INCOMPLETE_BALL)) {
      return;
    }
    balls.add(
        new BallDetection(
            x / MM_PER_M,
            y / MM_PER_M,
            z / MM_PER_M,
            Float.isNaN(confidence) ? 0 : confidence,
            Math.max(area, 0),
            pixelX,
            pixelY));
  }

  private void readRobot(CodedInputStream in, Team team, List<RobotDetection> into)
      throws IOException {
    int oldLimit = in.pushLimit(in.readRawVarint32());
    float confidence = 1;
    long number = ABSENT;
    float x = 0;
    float y = 0;
    boolean hasX = false;
    boolean hasY = false;
    float orientation = Float.NaN;
    float height = Float.NaN;
    for (int tag = in.readTag(); tag != 0; tag = in.readTag()) {
      if (tag == ROBOT_X) {
        x = in.readFloat();
        hasX = true;
      } else if (tag == ROBOT_Y) {
        y = in.readFloat();
        hasY = true;
      } else if (tag == ROBOT_ORIENTATION) {
        orientation = readDetail(in);
      } else if (tag == ROBOT_ID) {
        number = Integer.toUnsignedLong(in.readUInt32());
      } else if (tag == ROBOT_CONFIDENCE) {
        confidence = readDetail(in);
      } else if (tag == ROBOT_HEIGHT) {
        height = readDetail(in);
      } else {
        skip(in, tag);
      }
    }
    in.checkLastTagWas(0);
    in.popLimit(oldLimit);
    if (!isUsable(hasX && hasY && number != ABSENT, x, y, DecodingProblem.INCOMPLETE_ROBOT)) {
      return;
    }
    if (number > VisionDecoder.MAX_ROBOT_NUMBER) {
      counts.add(DecodingProblem.IMPOSSIBLE_ROBOT);
      return;
    }
    into.add(
        new RobotDetection(
            robotId(team, (int) number),
            x / MM_PER_M,
            y / MM_PER_M,
            orientation,
            Float.isNaN(confidence) ? 0 : confidence,
            height / MM_PER_M));
  }

  /** Whether the detection can be used; counts the reason if not. The problems of balls and robots come in the same order. */
  private boolean isUsable(boolean complete, float x, float y, DecodingProblem incomplete) {
    boolean ball = incomplete == DecodingProblem.INCOMPLETE_BALL;
    if (!complete) {
      counts.add(incomplete);
    } else if (!Float.isFinite(x) || !Float.isFinite(y)) {
      counts.add(ball ? DecodingProblem.NON_FINITE_BALL : DecodingProblem.NON_FINITE_ROBOT);
    } else if (Math.max(Math.abs(x), Math.abs(y)) > VisionDecoder.MAX_COORDINATE * MM_PER_M) {
      counts.add(ball ? DecodingProblem.FAR_BALL : DecodingProblem.IMPOSSIBLE_ROBOT);
    } else {
      return true;
    }
    return false;
  }

  private RobotId robotId(Team team, int number) {
    RobotId[] known = robotIds[team.ordinal()];
    if (known[number] == null) {
      known[number] = new RobotId(team, number);
    }
    return known[number];
  }

  /** A value that a detection can do without: NaN, and counted, if it is not finite. */
  private float readDetail(CodedInputStream in) throws IOException {
    float value = in.readFloat();
    if (Float.isFinite(value)) {
      return value;
    }
    counts.add(DecodingProblem.NON_FINITE_DETAIL);
    return Float.NaN;
  }

  static void skip(CodedInputStream in, int tag) throws IOException {
    if (!in.skipField(tag)) {
      // An end-group tag without its start: no message ends like this.
      in.checkLastTagWas(0);
    }
  }

  private static boolean isUnixTime(double seconds) {
    return Math.abs(seconds) <= MAX_UNIX_SECONDS;
  }

  private static int tag(int field, int wireType) {
    return field << 3 | wireType;
  }
}
