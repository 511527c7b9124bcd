package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HandSelectionTest {
  private static final String KEY = HandSelection.key(1763712345.123);

  @Test
  void theKeyIsTheTimeInHundredths() {
    assertThat(KEY).isEqualTo("1763712345.12");
    assertThat(HandSelection.key(1.0)).isEqualTo("1.00");
  }

  @Test
  void decisionsReplaceEachOther() {
    HandSelection none = HandSelection.none();
    HandSelection dropped = none.drop(KEY, "a foot on the field");
    assertThat(dropped.droppedBecause(KEY)).contains("a foot on the field");
    assertThat(dropped.isKept(KEY)).isFalse();
    HandSelection kept = dropped.keep(KEY);
    assertThat(kept.droppedBecause(KEY)).isEmpty();
    assertThat(kept.isKept(KEY)).isTrue();
    HandSelection again = kept.drop(KEY, "after all");
    assertThat(again.isKept(KEY)).isFalse();
    assertThat(again.dropped()).containsEntry(KEY, "after all").hasSize(1);
    // None of the values before has changed.
    assertThat(none.droppedBecause(KEY)).isEmpty();
    assertThat(dropped.droppedBecause(KEY)).isPresent();
    assertThat(kept.kept()).containsExactly(KEY);
  }

  @Test
  void aTimeThatMovedByTwoMillisecondsIsTheSameKick() {
    HandSelection s = HandSelection.none().drop(HandSelection.key(1763712345.1249), "foot");
    assertThat(s.droppedBecause(HandSelection.key(1763712345.1251))).contains("foot");
    assertThat(s.droppedBecause(HandSelection.key(1763712345.1151))).contains("foot");
    assertThat(s.droppedBecause(HandSelection.key(1763712345.15))).isEmpty();
    HandSelection k = HandSelection.none().keep(HandSelection.key(1763712345.1249));
    assertThat(k.isKept(HandSelection.key(1763712345.1251))).isTrue();
    assertThat(k.isKept(HandSelection.key(1763712345.2))).isFalse();
  }

  @Test
  void decidingAnewOnAKickWhoseTimeMovedReplacesTheDecision() {
    HandSelection s = HandSelection.none().drop("1763712345.12", "foot").keep("1763712345.13");
    assertThat(s.isKept("1763712345.13")).isTrue();
    assertThat(s.droppedBecause("1763712345.13")).isEmpty();
  }

  @Test
  void copiesDoNotChangeTheSelection() {
    HandSelection s = HandSelection.none().drop(KEY, "foot").keep("1.00");
    s.dropped().clear();
    s.kept().clear();
    assertThat(s.droppedBecause(KEY)).isPresent();
    assertThat(s.isKept("1.00")).isTrue();
  }
}
