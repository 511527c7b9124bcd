package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.effect.measurement.LensDistortionError;
import fieldcal.effect.motion.AirDrag;
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
  void regionsAreRectanglesOfTiles() {
    Mosaic mosaic = new WornRegion(0, 0, 0, 0, 0).mosaic(arena(new double[] {1})).orElseThrow();
    assertThat(mosaic.tiles())
        .hasSize(8 * 6)
        .contains(new WornRegion(0, -4.5, -3, -3.5, -2), new WornRegion(0, 0, 1, 2, 3.5));
    assertThat(mosaic.pieces())
        .extracting(Mosaic.Piece::effect)
        .doesNotHaveDuplicates()
        .contains(new WornRegion(0, -4.5, 0, -3.5, 3.5), new WornRegion(0, -2, 1, 0, 2))
        .doesNotContain(new WornRegion(0, -4.5, 4.5, -3.5, 3.5));
    for (Mosaic.Piece piece : mosaic.pieces()) {
      WornRegion whole = (WornRegion) piece.effect();
      List<Effect> within =
          mosaic.tiles().stream().filter(t -> contains(whole, (WornRegion) t)).toList();
      assertThat(piece.tiles().stream().map(mosaic.tiles()::get))
          .containsExactlyInAnyOrderElementsOf(within);
    }
  }

  private static boolean contains(WornRegion whole, WornRegion tile) {
    return tile.x0() >= whole.x0()
        && tile.x1() <= whole.x1()
        && tile.y0() >= whole.y0()
        && tile.y1() <= whole.y1();
  }

  /** What a search has found can be compared with all other places only if it is one of them. */
  @Test
  void theRegionItselfIsAmongThem() {
    WornRegion found = new WornRegion(0.3, -1.3, -0.95, 1.2, 20);
    Mosaic mosaic = found.mosaic(arena(new double[] {1})).orElseThrow();
    assertThat(mosaic.pieces())
        .extracting(Mosaic.Piece::effect)
        .contains(new WornRegion(0, -1.3, -0.95, 1.2, 3.5));
  }

  @Test
  void aRegionReachesHardlyFartherThanTheBalls() {
    Arena arena = arena(new double[] {1});
    assertThat(new WornRegion(0.2, -11, 1, -2, 20).within(arena))
        .isEqualTo(new WornRegion(0.2, -4.5, 1, -2, 3.5));
    assertThat(new AirDrag(0.4).within(arena)).isEqualTo(new AirDrag(0.4));
  }

  @Test
  void aPieceNeedsTilesThatExist() {
    Effect none = new WornRegion(0, 0, 1, 0, 1);
    List<Mosaic.Piece> pieces = List.of(new Mosaic.Piece(none, List.of(0, 1)));
    assertThatThrownBy(() -> new Mosaic(List.of(none), pieces))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("1");
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
