package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.gamelog.CameraStatistics;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ClockNotesTest {
  /** With a mean of reception minus capture, and seconds of the recorder's clock per second of its own. */
  private static CameraStatistics camera(int id, double difference, double rate) {
    return new CameraStatistics(
        id, 1000, 70, 0, 0, 0, 1e-3, Double.NaN, difference, rate, 1000, 6000, 1e-3, 1);
  }

  private static List<String> lines(CameraStatistics... cameras) {
    return new ClockNotes(Arrays.asList(cameras)).lines();
  }

  @Test
  void clocksThatAgreeAreNothingToSay() {
    assertThat(lines(camera(0, 0.02, 1), camera(1, 0.9, 1.004))).isEmpty();
    assertThat(lines(camera(0, Double.NaN, Double.NaN))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "1.5, 1.5 s behind",
    "-0.25, 250 ms ahead of",
    "-1.5, 1.5 s ahead of",
    "172800, 2.0 days behind",
    "1763712345, 55.9 years behind"
  })
  void howFarAClockIsOffIsSaidInAUnitThatTells(double difference, String words) {
    assertThat(lines(camera(2, difference, 1)))
        .containsExactly(
            "camera 2: the clock is " + words + " the recorder's, so the latency is not known");
  }

  @Test
  void camerasOfWhichTheSameIsToBeSaidShareALine() {
    assertThat(lines(camera(0, 3, 1), camera(1, 0.02, 0.98), camera(3, 3, 1.02), camera(4, 0, 1)))
        .containsExactly(
            "cameras 0, 3: the clock is 3.0 s behind the recorder's, so the latency is not known",
            "camera 1: the clock runs 2.0 % faster than the recorder's; if the camera's clock is"
                + " wrong, all speeds are wrong, too",
            "camera 3: the clock runs 2.0 % slower than the recorder's; if the camera's clock is"
                + " wrong, all speeds are wrong, too");
  }
}
