package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Fourteen chips from rest, and balls that did not lie where they were kicked. */
class CleaningTest {
  /** A robot's nudge, m: six times the noise. */
  private static final double NUDGE = 0.012;

  private final HypothesisFitter fitter = ChipsField.anew();

  private void push(KickData kick) {
    for (int i = 0; i < kick.size && kick.time[i] < kick.kick.time(); i++) {
      kick.x[i] += NUDGE;
      kick.y[i] -= NUDGE;
    }
  }

  private List<KickData> ends() {
    return Cleaning.ends(fitter, fitter.fitSimple());
  }

  private static boolean usesRest(KickData kick) {
    for (int i = 0; i < kick.size && kick.time[i] < kick.kick.time(); i++) {
      if (kick.used[i]) {
        return true;
      }
    }
    return false;
  }

  @Test
  void whereNothingWasPushedAllRestsCount() {
    assertThat(ends()).isSameAs(fitter.kicks);
    assertThat(fitter.kicks).allMatch(k -> k.fromRest && usesRest(k));
  }

  @Test
  void theRestOfABallThatWasPushedBeforeItsKickDoesNotCount() {
    KickData pushed = fitter.kicks.get(3);
    push(pushed);
    List<KickData> clean = ends();
    for (int k = 0; k < clean.size(); k++) {
      boolean rest = fitter.kicks.get(k) != pushed;
      assertThat(clean.get(k).fromRest).as("kick %d", k).isEqualTo(rest);
      assertThat(usesRest(clean.get(k))).as("kick %d", k).isEqualTo(rest);
    }
    assertThat(clean.get(3).usedCount).isGreaterThan(pushed.usedCount / 2);
    HypothesisFitter again = fitter.of(clean);
    assertThat(Structure.of(again, again.fitSimple()).isSignificant()).isFalse();
  }

  @Test
  void whatAllKicksShowIsAFindingAndNoPush() {
    fitter.kicks.forEach(this::push);
    assertThat(ends()).allMatch(k -> k.fromRest);
  }
}
