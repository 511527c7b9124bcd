package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** What is left must be told from noise without knowing what it is. */
class StructureTest {
  private final ChipsField field = ChipsField.fitted();

  /** All kicks somewhere else, in standard deviations of the noise. */
  private FittedHypothesis moved(double sigmas) {
    double noise = 1 / field.fitter.kicks.get(0).w11[0];
    List<double[]> own = new ArrayList<>();
    for (double[] o : field.simple.own()) {
      double[] aside = o.clone();
      aside[0] += sigmas * noise;
      own.add(aside);
    }
    return field.spoilt(own, field.simple.flights());
  }

  @Test
  void noiseHasNone() {
    Structure s = Structure.of(field.fitter, field.simple);
    assertThat(Math.abs(s.deviation())).isLessThan(4);
    assertThat(s.isSignificant()).isFalse();
  }

  @Test
  void itsSizeIsThatOfTheError() {
    Structure nothing = Structure.of(field.fitter, field.simple);
    for (double sigmas : new double[] {1, 3}) {
      Structure s = Structure.of(field.fitter, moved(sigmas));
      // One of two axes is off.
      assertThat(s.systematic() - nothing.systematic())
          .isCloseTo(sigmas * sigmas / 2, within(0.25 * sigmas * sigmas));
      assertThat(s.isSignificant()).isTrue();
    }
  }

  @Test
  void whatIsLeftIsTheWrongKicksDoing() {
    assertThat(Structure.of(field.fitter, field.simple).isNothing()).isTrue();
    assertThat(Structure.shareOf(KickKind.CHIP, field.fitter, field.simple)).isZero();
    FittedHypothesis wrong = moved(3);
    assertThat(Structure.of(field.fitter, wrong).isNothing()).isFalse();
    assertThat(Structure.shareOf(KickKind.CHIP, field.fitter, wrong)).isEqualTo(1);
    assertThat(Structure.shareOf(KickKind.FLAT, field.fitter, wrong)).isZero();
  }

  @Test
  void blocksAreOfOneCameraWithoutGapsAndNothingIsInTwo() {
    for (KickData kick : field.fitter.kicks) {
      Set<Integer> seen = new HashSet<>();
      for (int[] block : Structure.blocks(kick)) {
        assertThat(block.length).isBetween(Structure.BLOCK / 2, Structure.BLOCK);
        for (int j = 0; j < block.length; j++) {
          assertThat(seen.add(block[j])).isTrue();
          assertThat(kick.used[block[j]]).isTrue();
          assertThat(kick.camera[block[j]]).isEqualTo(kick.camera[block[0]]);
          if (j > 0) {
            assertThat(kick.time[block[j]] - kick.time[block[j - 1]]).isBetween(0.0, 0.1);
          }
        }
      }
    }
  }
}
