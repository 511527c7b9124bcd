package fieldcal.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Positions that another implementation of the camera model computed from pixels, balls and robots, four cameras and two. */
class RecordedDetectionsTest {

  /** Reported positions are 32-bit millimetres of up to 6000, rounded to 0.0005 mm at most. */
  private static final double BALL_TOLERANCE_MM = 0.002;

  /** A robot's pixels are rounded to 1/16; half of that is 0.1 mm on the ground, 0.25 in a corner of the image. */
  private static final double ROBOT_TOLERANCE_MM = 0.3;

  private final Map<String, Camera> cameras = new HashMap<>();
  private final List<String[]> detections = new ArrayList<>();

  RecordedDetectionsTest() throws IOException {
    try (InputStream in = getClass().getResourceAsStream("recorded-detections.csv")) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      text.lines()
          .filter(line -> !line.startsWith("#"))
          .map(line -> line.split(","))
          .forEach(this::read);
    }
  }

  private void read(String[] cells) {
    if (!cells[0].equals("camera")) {
      detections.add(cells);
      return;
    }
    double[] v = new double[cells.length];
    for (int i = 3; i < v.length; i++) {
      v[i] = Double.parseDouble(cells[i]) * (i >= 11 && i <= 16 ? 0.001 : 1);
    }
    cameras.put(
        cells[1] + cells[2],
        Camera.of(
            new CameraCalibration(
                Integer.parseInt(cells[2]),
                v[3],
                v[4],
                v[5],
                v[6],
                v[7],
                v[8],
                v[9],
                v[10],
                v[11],
                v[12],
                v[13],
                v[14],
                v[15],
                v[16],
                (int) v[17],
                (int) v[18])));
  }

  @Test
  void posesFitTheirPublishedPositions() {
    assertThat(cameras).hasSize(6);
    assertThat(cameras.values())
        .allSatisfy(
            camera -> {
              assertThat(camera.poseSource()).isEqualTo(PoseSource.CALIBRATION);
              assertThat(camera.consistency())
                  .isEqualTo("rotation and published position agree to 0.00 mm");
            });
  }

  @Test
  void pixelsGiveTheReportedPositionsAndBack() {
    assertThat(detections).hasSize(72);
    for (String[] cells : detections) {
      Camera camera = cameras.get(cells[1] + cells[2]);
      double z = Double.parseDouble(cells[3]) * 0.001 - Camera.BALL_RADIUS;
      double[] reportedMm = {Double.parseDouble(cells[4]), Double.parseDouble(cells[5])};
      double[] seen = {Double.parseDouble(cells[6]), Double.parseDouble(cells[7])};
      double tolerance = cells[0].equals("ball") ? BALL_TOLERANCE_MM : ROBOT_TOLERANCE_MM;

      double[] plane = new double[2];
      camera.pixelToPlane(seen[0], seen[1], z, plane);
      double[] planeMm = {plane[0] * 1000, plane[1] * 1000};
      assertThat(planeMm)
          .as(String.join(",", cells))
          .containsExactly(reportedMm, within(tolerance));

      double[] pixel = new double[2];
      camera.worldToPixel(reportedMm[0] * 0.001, reportedMm[1] * 0.001, z, pixel);
      // One pixel is 2.5 to 4 mm on the ground.
      assertThat(pixel).as(String.join(",", cells)).containsExactly(seen, within(tolerance / 2.5));
    }
  }
}
