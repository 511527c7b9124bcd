package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Who waits for a diagnosis sees that it goes on, and how far it is. */
class DiagnosisProgressTest {

  @Test
  void everyFitSaysSomethingNew() {
    List<String> said = new ArrayList<>();
    new Diagnoser().diagnose(FittedField.flats("air_drag:cd=0.45").problem(), said::add);

    assertThat(said.get(0)).isEqualTo("fitting all kicks together");
    assertThat(said)
        .anyMatch(
            s ->
                s.matches(
                    "searching for causes, attempt 1 of at most 6: 2 models tried so far, the"
                        + " residual of the best is 1\\.0 times the noise"))
        .contains("searching for causes, looking for simpler models")
        .contains("weighing the explanations, judging one effect");
    for (int i = 1; i < said.size(); i++) {
      assertThat(said.get(i)).isNotEqualTo(said.get(i - 1));
    }
  }
}
