package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is learnt of the cameras before any kick is fitted: noise and offsets. */
class CamerasTest {
  private final SplittableRandom random = new SplittableRandom(5);

  /** A ball that lies still for 0.6 s, then rolls at 2 m/s for a second. */
  private Kick kick(int id, int[] cameras, double[] noise, double[][] offsets, double falseShare) {
    Observations.Builder b = new Observations.Builder();
    double x0 = random.nextDouble(-1, 1);
    double y0 = random.nextDouble(-1, 1);
    for (int k = 0; k < 110; k++) {
      for (int camera : cameras) {
        double t = k / 70.0 + 0.003 * camera;
        double x = x0 + 2 * Math.max(0, t - 0.6);
        double wild = random.nextDouble() < falseShare ? 0.2 : 0;
        b.add(
            t,
            camera,
            x + offsets[camera][0] + noise[camera] * IdealKicks.gaussian(random) + wild,
            y0 + offsets[camera][1] + noise[camera] * IdealKicks.gaussian(random),
            0,
            0);
      }
    }
    return new Kick(
        id, 0.6, x0, y0, 2, 0, Optional.empty(), true, KickEnd.TOUCHED_ROBOT, 1.6, b.build());
  }

  private static CameraViews views(int cameras) {
    double[][] positions = new double[cameras][];
    for (int c = 0; c < cameras; c++) {
      positions[c] = new double[] {c - 0.5 * cameras, 0, 6};
    }
    return FitSupport.positionsOnly(0.0015, positions);
  }

  @Test
  void noiseIsThatOfTheRestingBallFalseDetectionsOrNot() {
    double[] truth = {0.0007, 0.0021};
    double[][] offsets = {{0.02, 0}, {-0.02, 0}};
    for (double falseShare : new double[] {0, 0.04}) {
      List<Kick> kicks = new ArrayList<>();
      for (int id = 1; id <= 20; id++) {
        kicks.add(kick(id, new int[] {0, 1}, truth, offsets, falseShare));
      }
      Map<Integer, Double> noise = CameraNoise.atRest(kicks, views(2));
      assertThat(noise).containsOnlyKeys(0, 1);
      // 800 detections: the median's own error is 3 %.
      assertThat(noise.get(0)).isEqualTo(truth[0], within(0.1 * truth[0]));
      assertThat(noise.get(1)).isEqualTo(truth[1], within(0.1 * truth[1]));
    }
  }

  @Test
  void noiseOfACameraThatSawTooLittleAtRestIsNotInvented() {
    double[][] offsets = {{0, 0}, {0, 0}};
    double[] truth = {0.001, 0.001};
    Kick one = kick(1, new int[] {0}, truth, offsets, 0);
    assertThat(CameraNoise.atRest(List.of(one), views(2))).isEmpty();
    Kick moving = FitSupport.with(one, false, one.observations());
    assertThat(CameraNoise.atRest(List.of(moving, moving, moving), views(2))).isEmpty();
  }

  /** Kickers that push the ball first leave no rest; 1.5 mm were then taken for measured, whatever the cameras were. */
  @Test
  void whereNoBallRestedTheNoiseIsThatOfTheMovingBall() {
    double[] truth = {0.0007, 0.0042};
    double[][] offsets = {{0.02, 0}, {-0.02, 0}};
    List<Kick> kicks = new ArrayList<>();
    for (int id = 1; id <= 20; id++) {
      Kick kick = kick(id, new int[] {0, 1}, truth, offsets, 0.02);
      Observations after = kick.observations().between(kick.time(), kick.endTime());
      kicks.add(FitSupport.with(kick, false, after));
    }
    Map<Integer, Double> noise = CameraNoise.inMotion(kicks, views(2));
    assertThat(noise.get(0)).isEqualTo(truth[0], within(0.12 * truth[0]));
    assertThat(noise.get(1)).isEqualTo(truth[1], within(0.12 * truth[1]));
    List<Kick> few =
        List.of(kicks.get(0).withObservations(kicks.get(0).observations().between(0.6, 0.8)));
    assertThat(CameraNoise.inMotion(few, views(2))).isEmpty();
  }

  @Test
  void noCameraIsWithoutNoise() {
    double[][] offsets = {{0, 0}};
    List<Kick> kicks = new ArrayList<>();
    for (int id = 1; id <= 4; id++) {
      kicks.add(kick(id, new int[] {0}, new double[] {0}, offsets, 0));
    }
    assertThat(CameraNoise.atRest(kicks, views(1)).get(0)).isEqualTo(CameraNoise.FLOOR);
    assertThat(views(1).get(0).withNoise(0).noise()).isEqualTo(CameraNoise.FLOOR);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.001, 0.005, 0.0125, 0.05, 0.2})
  void aGridOfCoordinatesIsNoise(double step) {
    double[][] offsets = {{0, 0}, {0, 0}};
    List<Kick> kicks = new ArrayList<>();
    for (int id = 1; id <= 4; id++) {
      Kick kick = kick(id, new int[] {0, 1}, new double[] {0.0001, 0.0001}, offsets, 0);
      Observations.Builder b = new Observations.Builder();
      Observations seen = kick.observations();
      for (int i = 0; i < seen.size(); i++) {
        // Camera 1 has no grid.
        double to = seen.camera(i) == 0 ? step : 1e-9;
        double x = Math.round(seen.x(i) / to) * to;
        double y = Math.round(seen.y(i) / to) * to;
        b.add(seen.time(i), seen.camera(i), x, y, 0, 0);
      }
      kicks.add(FitSupport.with(kick, true, b.build()));
    }
    CameraViews measured = CameraNoise.measured(kicks, views(2));
    double least = Math.hypot(CameraNoise.FLOOR, step / Math.sqrt(12));
    // A ball that lies on the edge of a cell jumps between two.
    assertThat(measured.get(0).noise()).isBetween(least - 1e-9, 1.5 * step + CameraNoise.FLOOR);
    assertThat(CameraNoise.least(kicks).get(0)).isEqualTo(least, within(1e-9));
    assertThat(measured.get(1).noise()).isEqualTo(CameraNoise.FLOOR);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.3, -0.5, -2, -10})
  void aLensThatDoesNotSeeWhatItsCameraReportsIsNotUsed(double distortion) {
    CameraCalibration sound =
        new CameraCalibration(0, 1500, 1000, 1200, 0.12, 1, 0, 0, 0, 0, 0, 4, 0, 0, 4, 0, 0);
    CameraCalibration folded =
        new CameraCalibration(1, 1500, 1000, 1200, distortion, 1, 0, 0, 0, 0, 0, 4, 0, 0, 4, 0, 0);
    CameraViews views =
        CameraViews.of(
            List.of(
                CameraView.of(0, Optional.of(Camera.of(sound))),
                CameraView.of(1, Optional.of(Camera.of(folded)))));
    Observations.Builder b = new Observations.Builder();
    for (int i = 0; i < 120; i++) {
      b.add(i / 60.0, i % 2, -3.5 + 7 * i / 120.0, 1, 0, 0);
    }
    Kick kick =
        new Kick(
            1, 0.5, -1, 1, 2, 0, Optional.empty(), true, KickEnd.TOUCHED_ROBOT, 1.9, b.build());
    assertThat(LensCheck.unusable(List.of(kick), views)).containsOnlyKeys(1);
    CameraViews usable = LensCheck.usable(List.of(kick), views);
    assertThat(usable.get(0)).isEqualTo(views.get(0));
    assertThat(usable.get(1).camera().orElseThrow().hasPixels()).isFalse();
    assertThat(usable.get(1).camera().orElseThrow().positionZ()).isEqualTo(4);
    // What is beyond the fold has the noise below the camera, not none; before it somewhat less.
    FlightData data = FlightData.of(kick.observations(), views);
    assertThat(Arrays.stream(data.w11)).allMatch(Double::isFinite);
    assertThat(Arrays.stream(data.w22)).allMatch(w -> w < 4 / CameraView.DEFAULT_NOISE);
  }

  @Test
  void offsetsAreThoseOfTheOverlap() {
    double[][] truth = {{0.02, -0.003}, {-0.02, 0.003}};
    List<Kick> kicks = new ArrayList<>();
    for (int id = 1; id <= 8; id++) {
      kicks.add(kick(id, new int[] {0, 1}, new double[] {0.002, 0.002}, truth, 0.03));
    }
    CameraViews found = OverlapOffsets.estimate(kicks, views(2));
    for (int c = 0; c < 2; c++) {
      assertThat(found.get(c).offsetX()).isEqualTo(truth[c][0], within(5e-4));
      assertThat(found.get(c).offsetY()).isEqualTo(truth[c][1], within(5e-4));
    }
  }

  @Test
  void offsetsOfAChainAddUpAndStrangersKeepNone() {
    // 0 sees balls with 1, 1 with 2; 3 sees balls alone.
    double[][] truth = {{0.03, 0.01}, {0, 0}, {-0.03, -0.01}, {0.05, 0.05}};
    double[] noise = {0.001, 0.001, 0.001, 0.001};
    List<Kick> kicks = new ArrayList<>();
    int[][] pairs = {{0, 1}, {1, 2}, {3}};
    for (int id = 1; id <= 18; id++) {
      kicks.add(kick(id, pairs[id % 3], noise, truth, 0));
    }
    CameraViews found = OverlapOffsets.estimate(kicks, views(4));
    for (int c = 0; c < 3; c++) {
      assertThat(found.get(c).offsetX()).as("camera %d", c).isEqualTo(truth[c][0], within(5e-4));
      assertThat(found.get(c).offsetY()).as("camera %d", c).isEqualTo(truth[c][1], within(5e-4));
    }
    assertThat(found.get(3).offsetX()).isZero();
    assertThat(found.get(3).offsetY()).isZero();
  }

  /** Two cameras 4 m apart and 5 m high; the second is off, and tilted by 5 mm/m. */
  private static final class Apart {
    static final double X = -0.03;
    static final double Y = 0.02;
    static final CameraViews VIEWS =
        FitSupport.positionsOnly(0.0015, new double[] {-2, 0, 5}, new double[] {2, 0, 5});

    private Apart() {}

    static double[] reported(int camera, double x, double y, double z) {
      double[] ground = new double[2];
      VIEWS.get(camera).camera().orElseThrow().projectToGround(x, y, z, ground);
      return camera == 0
          ? ground
          : new double[] {ground[0] + X + 0.005 * ground[0], ground[1] + Y + 0.005 * ground[1]};
    }
  }

  /** A chip along y; each impact leaves 47 % of the speed upwards, as on ten real fields. Both cameras see it all the time. */
  private Kick chip(int id, double until, double noise) {
    Observations.Builder b = new Observations.Builder();
    double y0 = random.nextDouble(-1.5, -1);
    for (int k = 0; k / 70.0 < until; k++) {
      for (int camera = 0; camera < 2; camera++) {
        double t = k / 70.0 + 0.004 * camera;
        double[] p = Apart.reported(camera, 0, y0 + along(t), height(t));
        b.add(
            t,
            camera,
            p[0] + noise * IdealKicks.gaussian(random),
            p[1] + noise * IdealKicks.gaussian(random),
            0,
            0);
      }
    }
    return new Kick(id, 0, 0, y0, 0, 3, Optional.empty(), true, KickEnd.LOST, until, b.build());
  }

  /** Height of a chip with 3.5 m/s upwards at the start, m. */
  private static double height(double t) {
    double left = t;
    for (double up = 3.5; up * up / (2 * 9.81) > 0.01; up *= 0.47) {
      double hop = 2 * up / 9.81;
      if (left < hop) {
        return up * left - 9.81 / 2 * left * left;
      }
      left -= hop;
    }
    return 0;
  }

  /** Its way on the ground at 2.5 m/s, 0.7 of that after the first impact, m. */
  private static double along(double t) {
    double first = 2 * 3.5 / 9.81;
    return 2.5 * Math.min(t, first) + 1.75 * Math.max(0, t - first);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0003, 0.0015, 0.004})
  void aBallInTheAirSaysNothingOfOffsets(double noise) {
    CameraViews views = Apart.VIEWS.map(v -> v.withNoise(noise));
    List<Kick> flying = new ArrayList<>();
    for (int id = 1; id <= 6; id++) {
      flying.add(chip(id, 0.45 + 0.1 * id, noise));
    }
    CameraViews found = OverlapOffsets.estimate(flying, views);
    assertThat(found.all()).containsExactlyElementsOf(views.all());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0003, 0.0015, 0.004})
  void fewChipsThatRollAtLastAreEnough(double noise) {
    CameraViews views = Apart.VIEWS.map(v -> v.withNoise(noise));
    // One of three rolls where both cameras see it; the others are lost in the air.
    List<Kick> kicks = List.of(chip(1, 0.6, noise), chip(2, 0.5, noise), chip(3, 1.8, noise));
    CameraViews found = OverlapOffsets.estimate(kicks, views);
    double x = found.get(1).offsetX() - found.get(0).offsetX();
    double y = found.get(1).offsetY() - found.get(0).offsetY();
    // The median of 18 differences has 0.3 of their noise; the tilt adds up to 11 mm where the ball
    // rolls.
    assertThat(x).isEqualTo(Apart.X, within(0.001 + 1.3 * noise));
    assertThat(y).isEqualTo(Apart.Y, within(0.011 + 1.3 * noise));
  }

  @Test
  void withoutOverlapNothingChanges() {
    double[][] truth = {{0.03, 0.01}, {0, 0}};
    Kick alone = kick(1, new int[] {1}, new double[] {0.001, 0.001}, truth, 0);
    CameraViews views = views(2);
    assertThat(OverlapOffsets.estimate(List.of(alone), views).get(1)).isEqualTo(views.get(1));
    assertThat(OverlapOffsets.estimate(List.of(), views).get(1)).isEqualTo(views.get(1));
  }
}
