package fieldcal.vision;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import fieldcal.camera.CameraCalibration;

/** Whatever arrives on vision's port: nothing is thrown, what is accepted is usable, and writing it loses nothing. */
class VisionFuzzTest {

  private static final Epoch EPOCH = new Epoch(1_700_000_000_000_000_000L);

  @FuzzTest(maxDuration = "60s")
  void decodes(byte[] bytes) {
    VisionPacket packet = new VisionDecoder(EPOCH).decode(bytes);
    packet.frame().ifPresent(VisionFuzzTest::assertUsable);
    packet
        .geometry()
        .ifPresent(
            geometry -> {
              assertThat(geometry.length()).isFinite().isPositive();
              assertThat(geometry.width()).isFinite().isPositive();
              assertThat(geometry.cameras())
                  .extracting(CameraCalibration::id)
                  .doesNotHaveDuplicates();
            });

    byte[] written = new VisionEncoder(EPOCH).encode(packet);
    VisionDecoder second = new VisionDecoder(EPOCH);
    VisionPacket again = second.decode(written);
    assertThat(second.counts().total()).isZero();
    assertThat(again.frame().isPresent()).isEqualTo(packet.frame().isPresent());
    assertThat(again.geometry().isPresent()).isEqualTo(packet.geometry().isPresent());
    // Times are rounded to the doubles of Unix seconds and metres to floats of millimetres on the
    // way; the second time nothing changes any more.
    assertThat(new VisionEncoder(EPOCH).encode(again)).isEqualTo(written);
  }

  private static void assertUsable(VisionFrame frame) {
    assertThat(frame.captureTime()).isFinite();
    assertThat(frame.cameraId()).isBetween(0, VisionDecoder.MAX_CAMERA_ID);
    assertThat(frame.balls())
        .allSatisfy(
            ball -> {
              assertThat(Math.abs(ball.x())).isLessThanOrEqualTo(VisionDecoder.MAX_COORDINATE);
              assertThat(Math.abs(ball.y())).isLessThanOrEqualTo(VisionDecoder.MAX_COORDINATE);
            });
    assertThat(frame.robots())
        .allSatisfy(
            robot -> {
              assertThat(Math.abs(robot.x())).isLessThanOrEqualTo(VisionDecoder.MAX_COORDINATE);
              assertThat(Math.abs(robot.y())).isLessThanOrEqualTo(VisionDecoder.MAX_COORDINATE);
            });
  }
}
