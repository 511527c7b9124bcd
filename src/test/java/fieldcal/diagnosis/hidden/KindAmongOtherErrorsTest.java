package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Whether a kick was chipped is told right where other causes leave much more than the noise. Seeds of a study whose cases came out wrong before. */
class KindAmongOtherErrorsTest {
  private static List<KickKind> kinds(long seed) {
    return HiddenRun.problem(HiddenCase.draw(seed)).fits().stream().map(KickFit::kind).toList();
  }

  /** Nine flat kicks, then nine chips, one of which rolls for six of its seven seconds; a rolling shutter of 8 ms and a seam leave 3 to 9 mm. */
  @Test
  void aChipThatRollsForLongIsAChip() {
    List<KickKind> kinds = kinds(909_000_021);
    assertThat(kinds.subList(0, 9)).containsOnly(KickKind.FLAT);
    assertThat(kinds.subList(9, 18)).containsOnly(KickKind.CHIP);
  }

  /** A friction that falls with the slip makes fast kicks look as if they flew. */
  @Test
  void flatKicksOfAnOddFrictionAreFlat() {
    assertThat(kinds(909_000_035)).containsOnly(KickKind.FLAT);
  }
}
