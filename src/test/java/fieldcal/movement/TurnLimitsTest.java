package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Turns that are over too soon to be measured. */
class TurnLimitsTest {
  private static LimitEstimate reached(double value) {
    return new LimitEstimate(value, 0.01 * value, 100, true, "");
  }

  @Test
  void shortTurnsGiveALowerBoundOnly() {
    LimitEstimate bound = TurnLimits.unlessTooShort(reached(43.3), reached(4.7));
    assertThat(bound.value()).isEqualTo(43.3);
    assertThat(bound.reached()).isFalse();
    assertThat(bound.note()).contains("within 0.11 s").contains("lower bound");
    LimitEstimate seen = new LimitEstimate(3.9, 0.05, 100, false, "never kept");
    assertThat(TurnLimits.unlessTooShort(reached(42.1), seen).reached()).isFalse();
  }

  @Test
  void longerTurnsAndUnknownRatesLeaveItAsItIs() {
    LimitEstimate change = reached(46.2);
    assertThat(TurnLimits.unlessTooShort(change, reached(5.7))).isSameAs(change);
    LimitEstimate bound = new LimitEstimate(5.7, 0.05, 100, false, "never kept");
    assertThat(TurnLimits.unlessTooShort(change, bound)).isSameAs(change);
    LimitEstimate unknown = LimitEstimate.undetermined(3, "too few");
    assertThat(TurnLimits.unlessTooShort(change, unknown)).isSameAs(change);
    assertThat(TurnLimits.unlessTooShort(unknown, reached(4.7))).isSameAs(unknown);
  }
}
