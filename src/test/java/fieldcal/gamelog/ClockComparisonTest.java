package fieldcal.gamelog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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

  /** A program that starts on a busy machine: frames are read 80 to 120 ms late at first, and ever less late. */
  @ParameterizedTest
  @ValueSource(doubles = {0.994, 1, 1.006, 1.02})
  void aReaderThatIsLateAtTheBeginningIsNoRate(double rate) {
    for (int i = 0; i < 70 * 16; i++) {
      double captured = i / 70.0;
      double late = i % 10 == 0 && i > 70 ? 0 : 0.12 * Math.exp(-captured / 8);
      clocks.add(captured, rate * captured + late + random.nextDouble(0.003, 0.008));
    }
    assertThat(clocks.rate()).isEqualTo(rate, within(0.0005));
    assertThat(clocks.ratesDiffer()).isEqualTo(rate != 1);
  }

  @Test
  void aReaderThatPausesIsNoRate() {
    for (int i = 0; i < 70 * 40; i++) {
      double captured = i / 70.0;
      double paused = captured > 10 && captured < 12 ? 12 : captured > 30 && captured < 32 ? 32 : 0;
      double received = captured + random.nextDouble(0.01, 0.03);
      clocks.add(captured, Math.max(received, paused));
    }
    assertThat(clocks.rate()).isEqualTo(1, within(0.0005));
  }

  /** Nobody said that it jumped. */
  @Test
  void aRecorderThatIsSetIsNoRate() {
    record(30, 0, 1);
    for (int i = 0; i < 70 * 20; i++) {
      clocks.add(30 + i / 70.0, 130 + i / 70.0 + random.nextDouble(0.01, 0.03));
    }
    assertThat(clocks.rate()).isEqualTo(1, within(0.0005));
  }

  @Test
  void scatterThatHidesTheRateIsSaidAsSuch() {
    double late = 0;
    for (int i = 0; i < 70 * 12; i++) {
      double captured = i / 70.0;
      late = i % 18 == 0 ? random.nextDouble(0.4) : late;
      clocks.add(captured, captured + late);
    }
    assertThat(clocks.rate()).isNaN();
  }

  @Test
  void aClockThatJumpsAllTheTimeNeedsNoMoreMemoryAndHasNoRate() {
    for (int jump = 0; jump < 1000; jump++) {
      record(0.1, jump, 1);
      clocks.jumped();
    }
    assertThat(clocks.rate()).isNaN();
  }
}
