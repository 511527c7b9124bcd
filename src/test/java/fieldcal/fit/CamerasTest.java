package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

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

  @Test
  void withoutOverlapNothingChanges() {
    double[][] truth = {{0.03, 0.01}, {0, 0}};
    Kick alone = kick(1, new int[] {1}, new double[] {0.001, 0.001}, truth, 0);
    CameraViews views = views(2);
    assertThat(OverlapOffsets.estimate(List.of(alone), views).get(1)).isEqualTo(views.get(1));
    assertThat(OverlapOffsets.estimate(List.of(), views).get(1)).isEqualTo(views.get(1));
  }
}
