package fieldcal.app.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class VisionWatchTest {
  private final VisionWatch watch = new VisionWatch();

  private void frame(double captured, double arrived) {
    watch.frame(captured, Arrival.at(arrived));
  }

  /** It found the frames of 1.1 s at once, and those of the next 0.9 s did not fit. */
  @Test
  void aReaderThatWasPausedIsNoFaultOfVision() {
    for (int i = 0; i < 500; i++) {
      double time = 0.015 * i;
      boolean paused = time > 2 && time < 4;
      if (!paused) {
        frame(1000 + time, time);
      } else if (time < 3.1) {
        watch.frame(1000 + time, new Arrival(2, 4, true));
      }
    }
    assertThat(watch.complaints()).isEmpty();
  }

  /** Its receiver went on, and dropped what nobody took. */
  @Test
  void framesThatNobodyTookAreNoSilence() {
    frame(1000, 5);
    watch.frame(1001.7, new Arrival(6.7, 6.7, false));
    assertThat(watch.complaints()).isEmpty();
  }

  @Test
  void aClockThatGoesBackIsToldEvenByAPausedReader() {
    frame(1000, 5);
    watch.frame(900, new Arrival(5, 7, true));
    watch.frame(1000, new Arrival(7, 7.1, true));
    assertThat(watch.complaints()).hasSize(2);
  }

  @Test
  void aSteadyVisionIsNothingToTell() {
    for (int i = 0; i < 500; i++) {
      frame(1000 + 0.015 * i, 5 + 0.015 * i + 0.01 * (i % 3));
    }
    assertThat(watch.complaints()).isEmpty();
    assertThat(watch.notes()).isEmpty();
  }

  @Test
  void silencesAndJumpsAreToldAsTheyHappen() {
    frame(1000, 5);
    frame(1001.2, 6.2);
    assertThat(watch.complaints())
        .containsExactly("vision was silent for 1.2 s, 1 s after its first frame");
    frame(1000.7, 6.215);
    assertThat(watch.complaints()).hasSize(2);
    assertThat(watch.complaints().get(1)).startsWith("vision's clock jumped by −0.5");
    assertThat(watch.notes()).containsExactly("vision: 2 silences and jumps of its clock");
  }

  @Test
  void aVisionThatStallsAllTheTimeDoesNotFloodTheOperator() {
    for (int i = 0; i < 100; i++) {
      frame(i, i);
    }
    assertThat(watch.complaints()).hasSize(11);
    assertThat(watch.notes()).containsExactly("vision: 99 silences and jumps of its clock");
  }

  /** A recording without these frames must not say that vision was silent. */
  @Test
  void framesThatTheReaderMayHaveLostAreNoGapOfVision() {
    frame(1000, 5);
    assertThat(watch.frame(1000.01, Arrival.at(5.01))).isTrue();
    // Dropped, since nobody took them.
    assertThat(watch.frame(1001.7, new Arrival(6.7, 6.7, false))).isFalse();
    // Paused: what waited was found at once, the rest had not fitted.
    assertThat(watch.frame(1001.72, new Arrival(6.71, 8.5, true))).isTrue();
    assertThat(watch.frame(1003.5, Arrival.at(8.51))).isFalse();
    // Vision was silent, while its reader waited.
    assertThat(watch.frame(1004.5, Arrival.at(9.51))).isTrue();
    // Its clock jumped.
    assertThat(watch.frame(2004.5, Arrival.at(9.52))).isTrue();
  }

  @Test
  void jumpsOfTheClockAreSummedUp() {
    frame(1000, 5);
    frame(4600.01, 5.01);
    frame(4600.02, 5.02);
    assertThat(watch.jumps()).isCloseTo(3600, within(0.01));
    frame(4599.53, 5.03);
    assertThat(watch.jumps()).isCloseTo(3599.5, within(0.01));
  }
}
