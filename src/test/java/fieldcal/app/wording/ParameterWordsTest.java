package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What people call the parameters. */
class ParameterWordsTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "acc_slide is 2.3 σ from the mean | sliding deceleration (acc_slide) is 2.3 σ from the"
            + " mean",
        "damping_xy_first_hop is 2.8 σ from the mean | horizontal damping at the first impact"
            + " (damping_xy_first_hop) is 2.8 σ from the mean",
        "damping_z is 3.0 σ from the mean | vertical damping (damping_z) is 3.0 σ from the mean",
        "sliding deceleration (acc_slide) is 2.3 σ from the mean | sliding deceleration (acc_slide)"
            + " is 2.3 σ from the mean",
        "by hand: the ball hit a robot | by hand: the ball hit a robot",
        "by hand: my_acc_slide_test | by hand: my_acc_slide_test",
      })
  void notesOfTheLibrarySpellParametersOut(String note, String words) {
    assertThat(ParameterWords.spelledOut(note)).isEqualTo(words);
  }
}
