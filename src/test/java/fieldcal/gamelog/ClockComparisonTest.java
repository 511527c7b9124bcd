package fieldcal.gamelog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The camera's clock against the recorder's. */
class ClockComparisonTest {
  private final ClockComparison clocks = new ClockComparison();
  private final SplittableRandom random = new SplittableRandom(3);

  /** Frames at 70 Hz, received 10 to 30 ms late, by a camera's clock that is off. */
  private void record(double seconds, double difference, double rate) {
    for (int i = 0; i < 70 * seconds; i++) {
      double captured = i / 70.0;
      clocks.add(captured, difference + rate * captured + random.nextDouble(0.01, 0.03));
    }
  }

  @Test
  void withoutFramesNothingIsKnown() {
    assertThat(clocks.difference()).isNaN();
    assertThat(clocks.rate()).isNaN();
    assertThat(clocks.differ()).isFalse();
    assertThat(clocks.ratesDiffer()).isFalse();
  }

  @Test
  void aDelayIsNoDifference() {
    record(20, 0, 1);
    assertThat(clocks.difference()).isEqualTo(0.02, within(0.001));
    assertThat(clocks.differ()).isFalse();
    assertThat(clocks.rate()).isEqualTo(1, within(0.0005));
    assertThat(clocks.ratesDiffer()).isFalse();
  }

  @Test
  void aSimulatedClockDiffersByYearsAndRunsSlow() {
    record(100, 1.76e9, 1.02);
    assertThat(clocks.differ()).isTrue();
    assertThat(clocks.difference()).isEqualTo(1.76e9, within(2.0));
    assertThat(clocks.rate()).isEqualTo(1.02, within(0.0002));
    assertThat(clocks.ratesDiffer()).isTrue();
  }

  @Test
  void nothingIsReceivedBeforeItWasCaptured() {
    record(20, -0.2, 1);
    assertThat(clocks.differ()).isTrue();
    assertThat(clocks.ratesDiffer()).isFalse();
  }

  @Test
  void aJumpIsNoRate() {
    record(20, 0, 1);
    clocks.jumped();
    record(20, 30, 1);
    assertThat(clocks.rate()).isEqualTo(1, within(0.0005));
  }

  @Test
  void aFewSecondsDoNotTellTheRate() {
    record(3, 0, 1.1);
    assertThat(clocks.rate()).isNaN();
  }
}
