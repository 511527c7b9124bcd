package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.WornRegion;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Beyond its reach an effect makes no difference; the search relies on it. */
class ReachTest {
  private static final long SEED = 20261124;
  private static final double ROUNDING = 1e-15;
  private static final Arena ARENA =
      new Arena(-4.5, 4.5, -3, 3, new double[] {0, 60}, true, true, List.of(), List.of());

  @Test
  void aFunctionOfAMapIsZeroBeyondItsReach() {
    SplittableRandom random = new SplittableRandom(SEED);
    List<LearnedTerm> maps = LearnedLibrary.maps(ARENA);
    assertThat(maps).hasSize(3);
    for (LearnedTerm map : maps) {
      double[] one = new double[map.coefficients().length];
      for (int i = 0; i < one.length; i++) {
        one[i] = 0.1;
        LearnedTerm term = map.withParameters(one);
        one[i] = 0;
        Area reach = term.reach().orElseThrow();
        int inside = 0;
        for (int n = 0; n < 200; n++) {
          double x = random.nextDouble(-6, 6);
          double y = random.nextDouble(-4.5, 4.5);
          if (reach.isNear(x, y, x, y, 0)) {
            inside++;
          } else {
            assertThat(Math.abs(term.valueAt(0, x, y)))
                .as("function %d at (%f, %f)", i, x, y)
                .isLessThan(ROUNDING);
          }
        }
        assertThat(inside).as("function %d", i).isLessThan(150);
      }
    }
  }

  @Test
  void severalFunctionsReachAsFarAsAllOfThem() {
    LearnedTerm map = LearnedLibrary.maps(ARENA).get(0);
    double[] both = new double[map.coefficients().length];
    both[0] = 0.1;
    both[both.length - 1] = 0.1;
    Area reach = map.withParameters(both).reach().orElseThrow();
    assertThat(reach.isNear(-4, -2.5, -4, -2.5, 0)).isTrue();
    assertThat(reach.isNear(4, 2.5, 4, 2.5, 0)).isTrue();
    assertThat(map.reach()).as("without any function").isEmpty();
  }

  @Test
  void aRegionReachesToItsBoundsAndDragAnywhere() {
    assertThat(new WornRegion(0.2, -1, 2, 0, 3).reach()).contains(new Area(-1, 2, 0, 3));
    assertThat(new AirDrag(0.4).reach()).isEmpty();
  }

  @Test
  void aPathIsNearWhereItsStraightPiecesAre() {
    Area area = new Area(0, 1, 0, 1);
    assertThat(area.isNear(-1, 0.5, 2, 0.5, 0)).as("across").isTrue();
    assertThat(area.isNear(-1, -1, -0.2, 2, 0)).as("beside").isFalse();
    assertThat(area.isNear(-1, -1, -0.2, 2, 0.3)).as("beside, with a margin").isTrue();
    assertThat(area.and(new Area(-2, 0.5, 3, 4))).isEqualTo(new Area(-2, 1, 0, 4));
  }
}
