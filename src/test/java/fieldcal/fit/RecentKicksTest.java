package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** What is kept of each kick gives the same cameras, to the last bit, as looking at all kicks again. */
class RecentKicksTest {
  private static final int MEMORY = 5;

  /** Saw balls, but nobody published its calibration. */
  private static final int UNPUBLISHED = 3;

  /** Its lens does not see what lies farther than some metres from below it. */
  private static final int FOLDED = 1;

  private final SplittableRandom random = new SplittableRandom(19);

  private static CameraView view(int id, double distortion) {
    CameraCalibration c =
        new CameraCalibration(id, 1500, 1000, 1200, distortion, 1, 0, 0, 0, 0, 0, 4, 0, 0, 4, 0, 0);
    return CameraView.of(id, Optional.of(Camera.of(c)));
  }

  private static CameraViews published() {
    return CameraViews.of(List.of(view(0, 0.12), view(FOLDED, -0.3), view(2, 0.05)));
  }

  /** A ball that lies still at x0, then rolls at 2 m/s; with coordinates on a grid unless that is 0. */
  private Kick kick(int id, double x0, double grid, int... cameras) {
    Observations.Builder b = new Observations.Builder();
    for (int k = 0; k < 110; k++) {
      for (int camera : cameras) {
        double t = k / 70.0 + 0.003 * camera;
        double noise = 0.001 * (1 + camera);
        double x = x0 + 2 * Math.max(0, t - 0.6) + 0.02 * camera;
        double seenX = x + noise * IdealKicks.gaussian(random);
        double seenY = 1 + noise * IdealKicks.gaussian(random);
        b.add(t, camera, rounded(seenX, grid), rounded(seenY, grid), 0, 0);
      }
    }
    boolean fromRest = id % 4 != 0;
    return new Kick(
        id, 0.6, x0, 1, 2, 0, Optional.empty(), fromRest, KickEnd.TOUCHED_ROBOT, 1.6, b.build());
  }

  private static double rounded(double x, double grid) {
    return grid == 0 ? x : Math.round(x / grid) * grid;
  }

  private List<Kick> kicks() {
    List<Kick> kicks = new ArrayList<>();
    int id = 1;
    for (int k = 0; k < 4; k++) {
      kicks.add(kick(id++, -0.5, 0.01, 0, FOLDED));
      kicks.add(kick(id++, -0.5, 0, FOLDED, 2));
      kicks.add(kick(id++, 0, 0, 0, UNPUBLISHED));
    }
    // From here on the folded lens is no longer usable; later it is again.
    kicks.add(kick(id++, 3.5, 0, 0, FOLDED));
    for (int k = 0; k < 4; k++) {
      kicks.add(kick(id++, 0.5, 0, 0, FOLDED, 2));
      kicks.add(kick(id++, -0.5, 0.01, 2));
    }
    return kicks;
  }

  private static CameraViews lookedAtAgain(List<Kick> kicks, CameraViews before) {
    TreeSet<Integer> ids = new TreeSet<>();
    kicks.forEach(k -> Arrays.stream(k.observations().cameras()).forEach(ids::add));
    List<CameraView> all = new ArrayList<>(published().all());
    all.forEach(v -> ids.remove(v.id()));
    ids.forEach(id -> all.add(CameraView.of(id, Optional.empty())));
    CameraViews known =
        LensCheck.usable(kicks, CameraViews.of(all))
            .map(v -> v.withNoise(before.get(v.id()).noise()));
    return OverlapOffsets.estimate(kicks, CameraNoise.measured(kicks, known));
  }

  @Test
  void camerasAreThoseOfAllKicksLookedAtAgain() {
    RecentKicks recent = new RecentKicks(published(), MEMORY);
    CameraViews before = published();
    List<Kick> kicks = kicks();
    TreeSet<Boolean> usable = new TreeSet<>();
    int offsets = 0;
    for (int last = 0; last < kicks.size(); last++) {
      recent.add(kicks.get(last));
      List<Kick> counted = kicks.subList(Math.max(0, last + 1 - MEMORY), last + 1);
      CameraViews now = recent.views(before);
      for (CameraView expected : lookedAtAgain(counted, before).all()) {
        CameraView actual = now.get(expected.id());
        assertThat(actual.noise()).as("noise, kick %d", last).isEqualTo(expected.noise());
        assertThat(actual.offsetX()).as("offset, kick %d", last).isEqualTo(expected.offsetX());
        assertThat(actual.offsetY()).as("offset, kick %d", last).isEqualTo(expected.offsetY());
        assertThat(hasPixels(actual)).as("lens, kick %d", last).isEqualTo(hasPixels(expected));
        offsets += expected.offsetX() != 0 ? 1 : 0;
      }
      usable.add(hasPixels(now.get(FOLDED)));
      before = now;
    }
    assertThat(usable).as("the folded lens is used and not used").containsExactly(false, true);
    assertThat(offsets).isPositive();
    assertThat(before.get(0).noise()).isNotEqualTo(before.get(2).noise());
  }

  private static boolean hasPixels(CameraView view) {
    return view.camera().filter(Camera::hasPixels).isPresent();
  }

  @Test
  void remembersAtLeastOneKick() {
    assertThatThrownBy(() -> new RecentKicks(published(), 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("0");
  }
}
