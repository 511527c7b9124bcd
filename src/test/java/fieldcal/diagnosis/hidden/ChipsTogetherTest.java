package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.effect.motion.BounceSpinCoupling;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Cases of the study of seed 2311, drawn once, in which all chips went wrong together. */
class ChipsTogetherTest {
  /** One camera sees chips fly towards it; they seem to be kicked a tenth of a second late, and then nothing fits. */
  @ParameterizedTest
  @ValueSource(longs = {2_311_000_003L, 2_311_000_021L})
  void nothingIsFoundInSoundChipsTowardsTheOnlyCamera(long seed) {
    HiddenCase hidden = HiddenCase.draw(seed);
    assertThat(hidden.hidden()).isEmpty();
    Answer answer = HiddenRun.of(hidden, step -> {}).answer();
    assertThat(answer.verdict()).isEqualTo(Answer.ADEQUATE);
  }

  /** Each chip alone makes up with a hop too many for bounces that the simple model does not know, and all together hold each other there. */
  @Test
  void bouncesThatFollowTheSpinAreNamedAlthoughEachChipTakesAHopTooMany() {
    HiddenCase hidden = HiddenCase.draw(2_311_000_197L);
    Answer answer = HiddenRun.of(hidden, step -> {}).answer();
    assertThat(answer.verdict()).isEqualTo(Answer.EXPLAINED);
    assertThat(answer.causes())
        .singleElement()
        .satisfies(
            c -> {
              assertThat(c.effect()).isInstanceOf(BounceSpinCoupling.class);
              double off = ((BounceSpinCoupling) c.effect()).coefficient() - 0.0847;
              assertThat(Math.abs(off)).isLessThan(3 * c.standardErrors().get("coefficient"));
            });
  }
}
