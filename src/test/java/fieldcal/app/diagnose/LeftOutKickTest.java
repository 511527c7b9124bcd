package fieldcal.app.diagnose;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.recording.DataProblem;
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
    assertThat(left.get(0).reason()).contains("not explained by");
    assertThat(left.get(1).reason()).isEqualTo("it could not be fitted");
    assertThat(LeftOutKick.remarks(left).get(0).toString())
        .contains("friday.log.gz", "kick " + third + " was left out");
  }

  @Test
  void kicksWithTheSameReasonShareARemark() {
    List<LeftOutKick> left =
        List.of(
            new LeftOutKick(whole.kicks().get(1).kick(), "friday.log.gz", "too few detections"),
            new LeftOutKick(whole.kicks().get(2).kick(), "friday.log.gz", "it could not be fitted"),
            new LeftOutKick(whole.kicks().get(4).kick(), "friday.log.gz", "too few detections"),
            new LeftOutKick(whole.kicks().get(5).kick(), "monday.log.gz", "too few detections"));
    List<DataProblem> remarks = LeftOutKick.remarks(left);
    assertThat(remarks).extracting(DataProblem::count).containsExactly(2L, 1L, 1L);
    assertThat(remarks.get(0).what())
        .isEqualTo(
            "kicks "
                + left.get(0).kick().id()
                + ", "
                + left.get(2).kick().id()
                + " were left out: too few detections");
    assertThat(remarks.get(2).where()).isEqualTo("monday.log.gz");
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
