package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.hidden.HiddenCase;
import fieldcal.diagnosis.hidden.HiddenRun;
import fieldcal.simulation.ScenarioKind;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Where a fit ends must not depend on where it starts: a second cause would explain the difference. */
class HypothesisFitterTest {
  /** Flat kicks with side spin: no straight path leads from where some of the balls lay. */
  private static final long CURVED = 41000392;

  private final ChipsField field = ChipsField.fitted();
  private final FittedHypothesis simple = field.simple;

  private void assertSame(FittedHypothesis again) {
    assertThat(again.flights()).isEqualTo(simple.flights());
    assertThat(again.chiSquare()).isCloseTo(simple.chiSquare(), within(1.0));
    assertThat(again.shared()).containsExactly(simple.shared(), within(1e-4));
  }

  private FittedHypothesis fitFrom(FittedHypothesis start) {
    return field.fitter.fit(Hypothesis.SIMPLE, simple.shared().clone(), start, true);
  }

  @Test
  void nothingButNoiseIsLeftWhereNothingIsHidden() {
    assertThat(simple.chiSquare() / simple.residuals()).isCloseTo(1, within(0.1));
  }

  @Test
  void wrongNumbersOfHopsOfAllChipsDoNotHoldEachOtherUp() {
    int[] oneMore = Arrays.stream(simple.flights()).map(n -> n + 1).toArray();
    assertSame(fitFrom(field.spoilt(simple.own(), oneMore)));
  }

  @Test
  void aChipWhoseHeightWasConfusedStartsAnew() {
    assertSame(fitFrom(field.withConfused(3)));
  }

  @Test
  void aFitIsTakenToOtherKicksAsFarAsTheyAreTheSame() {
    List<KickData> some = field.fitter.kicks.subList(2, 6);
    HypothesisFitter fewer = field.fitter.of(some);
    FittedHypothesis adopted = fewer.adopt(simple, field.fitter.kicks);
    assertThat(adopted.own()).isEqualTo(simple.own().subList(2, 6));
    assertThat(adopted.flights()).isEqualTo(Arrays.copyOfRange(simple.flights(), 2, 6));
    assertThat(adopted.shared()).isEqualTo(simple.shared());
    FittedHypothesis back = field.fitter.adopt(adopted, some);
    assertThat(back.own().subList(2, 6)).isEqualTo(simple.own().subList(2, 6));
    assertThat(back.own().get(0)).isEqualTo(field.fitter.kicks.get(0).start);
    assertThat(back.flights()[0]).isEqualTo(field.fitter.kicks.get(0).flights);
    assertSame(fitFrom(back));
  }

  @Test
  void aRestThatNoStraightPathExplainsIsKept() {
    List<KickData> curved =
        ChipsField.kicks(
            HiddenRun.problem(
                HiddenCase.of(CURVED, ScenarioKind.FLAT, "side_spin:fraction=-0.1153")));
    for (KickData kick : curved) {
      double[] rest = Outliers.rest(kick.kick);
      int resting = 0;
      int used = 0;
      for (int i = 0; i < kick.size && kick.time[i] < kick.kick.time() - 0.1; i++) {
        resting++;
        used += kick.used[i] ? 1 : 0;
      }
      assertThat(used).as("kick %d", kick.kick.id()).isGreaterThan(resting / 2);
      assertThat(Math.hypot(kick.start[0] - rest[0], kick.start[1] - rest[1]))
          .as("start of kick %d", kick.kick.id())
          .isLessThan(0.1);
    }
  }
}
