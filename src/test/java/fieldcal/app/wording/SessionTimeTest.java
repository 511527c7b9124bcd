package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A session may be some minutes of field time, or the recordings of a week. */
class SessionTimeTest {
  @ParameterizedTest
  @CsvSource({
    "20, from 20 s into the session on",
    "750, from 12.5 minutes into the session on",
    "5400, from 90.0 minutes into the session on",
    "9000, from 2.5 hours into the session on",
    "604800, from 7.0 days into the session on"
  })
  void whatBeginsIsSaidInTheUnitThatFits(double at, String words) {
    assertThat(SessionTime.from(at)).isEqualTo(words);
  }

  @ParameterizedTest
  @CsvSource({
    "66, minute 1.1",
    "3000, minute 50",
    "9000, 2.5 hours into the session",
    "604800, 7.0 days into the session"
  })
  void anInstantIsAMinuteOnlyInAShortSession(double at, String words) {
    assertThat(SessionTime.at(at)).isEqualTo(words);
  }
}
