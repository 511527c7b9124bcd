package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.effect.measurement.LensDistortionError;
import fieldcal.effect.motion.WornRegion;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

/** Where effects are looked for. */
class ArenaTest {
  private static Arena arena(double[] times, ObservedCamera... cameras) {
    return new Arena(-4, 4, -3, 3, times, true, false, List.of(cameras), List.of());
  }

  @Test
  void instantsLieBetweenKicks() {
    assertThat(arena(new double[] {30, 10, 90}).instantsBetweenKicks(8)).containsExactly(20, 60);
    assertThat(arena(new double[] {10}).instantsBetweenKicks(8)).isEmpty();
    double[] times = DoubleStream.iterate(0, t -> t + 10).limit(101).toArray();
    assertThat(arena(times).instantsBetweenKicks(4)).containsExactly(125, 375, 625, 875);
    assertThatThrownBy(() -> arena(times).instantsBetweenKicks(0))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void regionsCoverTheArenaAndMore() {
    List<Effect> regions = new WornRegion(0, 0, 0, 0, 0).candidates(arena(new double[] {1}));
    assertThat(regions)
        .contains(
            new WornRegion(0, -4.5, 0, -3.5, 3.5),
            new WornRegion(0, 0, 4.5, 0, 3.5),
            new WornRegion(0, -4.5, 4.5, -3.5, 0))
        .hasSize(25);
  }

  @Test
  void aLensIsAskedForWhereItIsKnownAndForAllAtOnce() {
    Effect lens = new LensDistortionError(0.1, 5);
    ObservedCamera unknown = ObservedCamera.unknown(2, 3);
    ObservedCamera one = MeasurementEffectsTest.camera(0, -2);
    ObservedCamera two = MeasurementEffectsTest.camera(1, 2);
    double[] times = {1, 2};
    assertThat(lens.canShowIn(arena(times, unknown))).isFalse();
    assertThat(lens.candidates(arena(times, unknown, one)))
        .containsExactly(new LensDistortionError(0, 0));
    assertThat(lens.candidates(arena(times, one, two)))
        .containsExactly(
            new LensDistortionError(0, 0),
            new LensDistortionError(0, 1),
            new LensDistortionError(0, LensDistortionError.ALL_CAMERAS));
  }
}
