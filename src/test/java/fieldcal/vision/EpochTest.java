package fieldcal.vision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class EpochTest {
  private static final long NANOS = 1_763_712_345_678_901_234L;

  @Test
  void keepsNanosecondsApart() {
    Epoch epoch = new Epoch(NANOS);

    assertThat(epoch.secondsOfNanos(NANOS + 3_600_000_000_001L))
        .isCloseTo(3600.000000001, within(1e-12));
    assertThat(epoch.unixNanosOf(epoch.secondsOfNanos(NANOS + 12_345_678_901L)))
        .isEqualTo(NANOS + 12_345_678_901L);
  }

  @Test
  void unixSecondsComeBackExactly() {
    Epoch epoch = Epoch.atSecondOf(NANOS);
    double unix = 1_763_712_399.123456;

    assertThat(epoch.unixNanos()).isEqualTo(1_763_712_345_000_000_000L);
    assertThat(epoch.unixSeconds(epoch.seconds(unix))).isEqualTo(unix);
    assertThat(Epoch.atSecondOf(1_763_712_345.9)).isEqualTo(epoch);
  }

  @Test
  void theFractionOfAnEpochCounts() {
    Epoch epoch = new Epoch(NANOS);

    assertThat(epoch.seconds(1_763_712_346.5)).isCloseTo(0.821098766, within(1e-9));
    assertThat(epoch.unixSeconds(0)).isCloseTo(1_763_712_345.678901, within(1e-6));
    assertThat(new Epoch(-1).seconds(0)).isCloseTo(1e-9, within(1e-15));
  }

  @Test
  void rejectsWhatIsNoTime() {
    assertThatThrownBy(() -> Epoch.atSecondOf(Double.NaN)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> Epoch.atSecondOf(1e10)).hasMessageContaining("1.0E10");
  }
}
