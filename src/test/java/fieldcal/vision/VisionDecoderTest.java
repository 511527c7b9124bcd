package fieldcal.vision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.proto.SSL_BallModelStraightTwoPhase;
import fieldcal.proto.SSL_DetectionBall;
import fieldcal.proto.SSL_DetectionFrame;
import fieldcal.proto.SSL_DetectionRobot;
import fieldcal.proto.SSL_GeometryData;
import fieldcal.proto.SSL_GeometryModels;
import fieldcal.proto.SSL_WrapperPacket;
import java.util.Arrays;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class VisionDecoderTest {
  private static final Epoch EPOCH = new Epoch(1_763_712_345_000_000_000L);

  private final VisionDecoder decoder = new VisionDecoder(EPOCH);

  @Test
  void absentOptionalFieldsAreNormal() {
    VisionFrame frame =
        decode(
            frame()
                .addBalls(SSL_DetectionBall.newBuilder().setX(1000).setY(-2000).buildPartial())
                .addRobotsBlue(
                    SSL_DetectionRobot.newBuilder().setX(1).setY(2).setRobotId(5).buildPartial()));

    assertThat(frame.balls())
        .containsExactly(new BallDetection(1, -2, Double.NaN, 1, 0, Double.NaN, Double.NaN));
    assertThat(frame.robots())
        .containsExactly(
            new RobotDetection(new RobotId(Team.BLUE, 5), 0.001, 0.002, Double.NaN, 1, Double.NaN));
    assertThat(frame.cameraClockTime()).isNaN();
    assertThat(frame.captureTime()).isEqualTo(0.5);
    assertThat(decoder.counts().total()).isZero();
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
  void nonFiniteCoordinatesAreLeftOutAndCounted(float bad) {
    VisionFrame frame =
        decode(
            frame()
                .addBalls(SSL_DetectionBall.newBuilder().setX(bad).setY(0).buildPartial())
                .addBalls(SSL_DetectionBall.newBuilder().setX(0).setY(bad).buildPartial())
                .addBalls(SSL_DetectionBall.newBuilder().setX(0).setY(0).setZ(bad).buildPartial())
                .addRobotsYellow(
                    SSL_DetectionRobot.newBuilder().setX(0).setY(bad).setRobotId(1).buildPartial())
                .addRobotsYellow(
                    SSL_DetectionRobot.newBuilder()
                        .setX(0)
                        .setY(0)
                        .setOrientation(bad)
                        .setRobotId(2)
                        .buildPartial()));

    assertThat(frame.balls()).hasSize(1);
    assertThat(frame.balls().get(0).z()).isNaN();
    assertThat(frame.robots()).hasSize(1);
    assertThat(frame.robots().get(0).orientation()).isNaN();
    assertThat(decoder.counts().asMap())
        .isEqualTo(
            Map.of(
                DecodingProblem.NON_FINITE_BALL, 2L,
                DecodingProblem.NON_FINITE_ROBOT, 1L,
                DecodingProblem.NON_FINITE_DETAIL, 2L));
  }

  @Test
  void impossibleDetectionsAreLeftOutAndCounted() {
    VisionFrame frame =
        decode(
            frame()
                .addBalls(SSL_DetectionBall.newBuilder().setX(1e9f).setY(0).buildPartial())
                .addBalls(SSL_DetectionBall.newBuilder().setX(0).buildPartial())
                .addRobotsBlue(SSL_DetectionRobot.newBuilder().setX(0).setY(0).buildPartial())
                .addRobotsBlue(
                    SSL_DetectionRobot.newBuilder().setX(0).setY(0).setRobotId(-1).buildPartial()));

    assertThat(frame.balls()).isEmpty();
    assertThat(frame.robots()).isEmpty();
    assertThat(decoder.counts().asMap())
        .isEqualTo(
            Map.of(
                DecodingProblem.FAR_BALL, 1L,
                DecodingProblem.INCOMPLETE_BALL, 1L,
                DecodingProblem.INCOMPLETE_ROBOT, 1L,
                DecodingProblem.IMPOSSIBLE_ROBOT, 1L));
  }

  @Test
  void framesWithoutUsableTimeOrCameraAreLeftOut() {
    assertThat(packet(frame().clearTCapture()).frame()).isEmpty();
    assertThat(packet(frame().clearCameraId()).frame()).isEmpty();
    assertThat(packet(frame().setTCapture(Double.NaN)).frame()).isEmpty();
    assertThat(packet(frame().setTCapture(1e300)).frame()).isEmpty();
    assertThat(packet(frame().setCameraId(-1)).frame()).isEmpty();
    assertThat(packet(frame().setTSent(Double.NEGATIVE_INFINITY)).frame().get().sentTime()).isNaN();

    assertThat(decoder.counts().asMap())
        .isEqualTo(
            Map.of(
                DecodingProblem.INCOMPLETE_FRAME, 2L,
                DecodingProblem.BAD_CAPTURE_TIME, 2L,
                DecodingProblem.BAD_CAMERA_ID, 1L,
                DecodingProblem.BAD_SENT_TIME, 1L));
  }

  @Test
  void brokenPartsOfTheGeometryCostOnlyThemselves() {
    VisionEncoder encoder = new VisionEncoder(EPOCH);
    FieldGeometry good = new VisionSamples(3).geometry();
    SSL_GeometryData.Builder message = VisionEncoder.toMessage(good).toBuilder();
    message.addCalibBuilder().setCameraId(6).setFocalLength(500);
    message.addCalib(message.getCalib(0).toBuilder().setCameraId(7).setQ2(Float.NaN));
    message.addCalib(message.getCalib(0));
    message.getFieldBuilder().addFieldLinesBuilder().setName("half a line");
    message.setModels(
        SSL_GeometryModels.newBuilder()
            .setStraightTwoPhase(
                SSL_BallModelStraightTwoPhase.newBuilder()
                    .setAccSlide(3)
                    .setAccRoll(-0.3)
                    .setKSwitch(0.6)));
    SSL_WrapperPacket packet =
        SSL_WrapperPacket.newBuilder().setGeometry(message.buildPartial()).buildPartial();

    FieldGeometry geometry = decoder.decode(packet.toByteArray()).geometry().orElseThrow();

    assertThat(geometry.cameras()).isEqualTo(good.cameras());
    assertThat(geometry.lines()).isEqualTo(good.lines());
    assertThat(geometry.flat()).isEmpty();
    assertThat(decoder.counts().asMap())
        .isEqualTo(
            Map.of(
                DecodingProblem.BAD_CALIBRATION, 3L,
                DecodingProblem.BAD_FIELD_LINE, 1L,
                DecodingProblem.BAD_MODEL, 1L));
    assertThat(encoder.encode(VisionPacket.of(geometry))).isNotEmpty();
  }

  @Test
  void aFieldWithoutSizeIsNoField() {
    SSL_WrapperPacket packet =
        SSL_WrapperPacket.newBuilder()
            .setGeometry(SSL_GeometryData.getDefaultInstance())
            .buildPartial();

    assertThat(decoder.decode(packet.toByteArray())).isEqualTo(VisionPacket.EMPTY);
    assertThat(decoder.counts().of(DecodingProblem.BAD_FIELD_SIZE)).isEqualTo(1);
  }

  @Test
  void theSameGeometryIsTheSameObject() {
    byte[] bytes =
        new VisionEncoder(EPOCH).encode(VisionPacket.of(new VisionSamples(3).geometry()));

    assertThat(decoder.decode(bytes).geometry().get())
        .isSameAs(decoder.decode(bytes.clone()).geometry().get());
  }

  @Test
  void decodesWithinALargerArray() {
    VisionFrame frame = new VisionSamples(5).frame();
    byte[] bytes = new VisionEncoder(EPOCH).encode(VisionPacket.of(frame));
    byte[] padded = new byte[bytes.length + 20];
    Arrays.fill(padded, (byte) 0xff);
    System.arraycopy(bytes, 0, padded, 7, bytes.length);

    assertThat(decoder.decode(padded, 7, bytes.length).frame()).contains(frame);
    assertThatThrownBy(() -> decoder.decode(padded, 7, padded.length))
        .isInstanceOf(IndexOutOfBoundsException.class);
  }

  @Test
  void anyDamageIsCountedNotThrown() {
    long seed = 20261121;
    SplittableRandom random = new SplittableRandom(seed);
    VisionSamples samples = new VisionSamples(seed);
    VisionEncoder encoder = new VisionEncoder(EPOCH);
    for (int round = 0; round < 20_000; round++) {
      VisionPacket packet =
          round % 4 == 0 ? VisionPacket.of(samples.geometry()) : VisionPacket.of(samples.frame());
      byte[] bytes = encoder.encode(packet);
      for (int hits = 1 + random.nextInt(4); hits > 0; hits--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      bytes = Arrays.copyOf(bytes, bytes.length - random.nextInt(1 + bytes.length / 4));

      VisionPacket back = decoder.decode(bytes);

      back.frame()
          .ifPresent(
              frame ->
                  assertThat(frame.balls())
                      .as("seed %d", seed)
                      .allMatch(ball -> Math.abs(ball.x()) <= VisionDecoder.MAX_COORDINATE));
    }
    assertThat(decoder.counts().of(DecodingProblem.MALFORMED_PACKET)).isPositive();
  }

  @Test
  void noiseIsNoPacket() {
    SplittableRandom random = new SplittableRandom(1);
    for (int round = 0; round < 20_000; round++) {
      byte[] noise = new byte[random.nextInt(200)];
      random.nextBytes(noise);
      assertThat(decoder.decode(noise)).isNotNull();
    }
  }

  private VisionFrame decode(SSL_DetectionFrame.Builder frame) {
    return packet(frame).frame().orElseThrow();
  }

  private VisionPacket packet(SSL_DetectionFrame.Builder frame) {
    return decoder.decode(
        SSL_WrapperPacket.newBuilder()
            .setDetection(frame.buildPartial())
            .buildPartial()
            .toByteArray());
  }

  private static SSL_DetectionFrame.Builder frame() {
    return SSL_DetectionFrame.newBuilder()
        .setTCapture(1_763_712_345.5)
        .setTSent(1_763_712_345.625)
        .setFrameNumber(1)
        .setCameraId(2);
  }
}
