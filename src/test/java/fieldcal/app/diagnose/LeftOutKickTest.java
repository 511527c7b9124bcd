package fieldcal.app.diagnose;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.diagnosis.Diagnosis;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Kicks that a diagnosis was not made of are named, with the reason. */
class LeftOutKickTest {
  private final Diagnosis whole = SampleDiagnosis.explained(6);

  /** Of six kicks the third stood out, and the sixth had no fit. */
  private final DiagnosisOutcome some =
      SampleOutcome.without(whole, whole.kicks().get(2), whole.kicks().get(5));

  @Test
  void noneIsLeftOutWhereAllAreUsed() {
    assertThat(LeftOutKick.of(SampleOutcome.of(whole, 0))).isEmpty();
  }

  @Test
  void eachHasItsReason() {
    int third = whole.kicks().get(2).kick().id();
    List<LeftOutKick> left = LeftOutKick.of(some);
    assertThat(left)
        .extracting(k -> k.kick().id())
        .containsExactly(third, whole.kicks().get(5).kick().id());
    assertThat(left.get(0).reason()).contains("does not explain it");
    assertThat(left.get(1).reason()).isEqualTo("it could not be fitted");
    assertThat(left.get(0).remark().toString())
        .contains("friday.log.gz", "kick " + third + " was left out");
  }

  @Test
  void theDocumentListsThem() {
    var kicks = new DiagnosisJson(some).build().get("kicks");
    assertThat(kicks.get("found").intValue()).isEqualTo(6);
    assertThat(kicks.get("used").intValue()).isEqualTo(4);
    assertThat(kicks.get("left_out").findValuesAsText("reason"))
        .containsExactlyElementsOf(LeftOutKick.of(some).stream().map(LeftOutKick::reason).toList());
  }
}
