package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.SampleOutcome;
import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** What the terminal shows: words first, no more than a screen. */
class DiagnosisTextTest {

  private static List<String> printed(Diagnosis diagnosis, int problems) {
    return printed(SampleOutcome.of(diagnosis, problems));
  }

  private static List<String> printed(DiagnosisOutcome outcome) {
    StringWriter text = new StringWriter();
    new DiagnosisText(new PrintWriter(text)).print(outcome, Path.of("out"));
    List<String> lines = text.toString().lines().toList();
    assertThat(lines).hasSizeLessThanOrEqualTo(48);
    assertThat(lines).allSatisfy(line -> assertThat(line.length()).isLessThanOrEqualTo(100));
    assertThat(text.toString()).doesNotContain("NaN").doesNotContain("null");
    return lines;
  }

  @Test
  void nothingWrongIsSaidAtOnce() {
    List<String> lines = printed(SampleDiagnosis.adequate(24), 0);
    assertThat(lines.get(0))
        .startsWith("The calibrated model is off by 13 mm after 1 s. These kicks show no error");
    assertThat(lines.get(1)).contains("24 kicks");
    assertThat(lines).hasSizeLessThanOrEqualTo(5);
    assertThat(String.join(" ", lines)).doesNotContain("So few kicks");
    assertThat(String.join(" ", printed(SampleDiagnosis.adequate(6), 0))).contains("So few kicks");
  }

  @Test
  void kicksThatWereNotUsedAreNamed() {
    Diagnosis whole = SampleDiagnosis.explained(6);
    String all = String.join("\n", printed(whole, 0));
    assertThat(all).contains("6 of 6 kicks used").doesNotContain("Left out");
    String some =
        String.join(
            " ", printed(SampleOutcome.without(whole, whole.kicks().get(2), whole.kicks().get(5))));
    assertThat(some)
        .contains("4 of 6 kicks used")
        .contains("Left out: kick 3: not explained by what explains the other kicks")
        .contains("Left out: kick 6: it could not be fitted.");
  }

  @Test
  void causesComeInWordsWithTheirNumbers() {
    String text = String.join("\n", printed(SampleDiagnosis.explained(24), 2));
    assertThat(text)
        .startsWith(
            "The calibrated model is off by 38 mm after 1 s, the extended model by 12 mm. The");
    assertThat(text.replace('\n', ' '))
        .contains(
            "These kicks do not follow the model, and 2 causes are found: offset of camera 1; air"
                + " drag.");
    assertThat(text).contains("1. Camera 1 reports everything");
    assertThat(text).contains("21.20 ± 0.12").contains("(83 %; 95 % bounds 12 to 13 mm)");
    assertThat(text).contains("; certain. It reduces the rms of held-out kicks by");
    assertThat(text).contains("These kicks do not show whether camera 0 or camera 1 is shifted.");
    assertThat(text.replaceAll("\\s+", " "))
        .contains(
            "Another cause would explain these kicks about as well: wrong ball height in vision.");
    assertThat(text).doesNotContain("evidence", "18234");
    assertThat(text).contains("calibrated model").contains("14.20").contains("64.9");
    assertThat(text).contains("extended model").contains("1.52").contains("29.0");
    assertThat(text).contains("What remains is no more than noise.");
    assertThat(text).contains("out/diagnosis.html");
  }

  @Test
  void whatIsUnexplainedSaysOnWhatItDepends() {
    String text = String.join("\n", printed(SampleDiagnosis.unexplained(24), 12));
    assertThat(text)
        .startsWith("The calibrated model is off by 19 mm after 1 s. Something is wrong");
    assertThat(text).contains("depending on the time since the kick");
    assertThat(text).contains("In the data:\n  ").contains("\n  9 more, see diagnosis.json");
  }

  @Test
  void whatIsPartlyExplainedSaysWhatIsFoundWhatIsLeftAndWhatToDo() {
    String text = String.join("\n", printed(SampleDiagnosis.partly(24), 0));
    assertThat(text)
        .startsWith(
            "The calibrated model is off by 50 cm after 1 s, the extended model by 9 cm. The");
    String line = text.replace("\n   ", " ").replace('\n', ' ');
    assertThat(line).contains("a part of that is explained: air drag.");
    assertThat(line).contains("odds better than a thousand to one");
    assertThat(line)
        .contains("replaces a law of the calibrated model: -  The carpet grips the ball");
    assertThat(line)
        .contains("the reports of camera 1 are too far")
        .contains("It reduces the rms of held-out kicks by 1.4 mm");
    assertThat(line).containsOnlyOnce("depends on the place in the image:");
    assertThat(line)
        .contains("2.90 mm beyond the noise remain unexplained, depending on the height");
    assertThat(line).contains("Use the extended model").contains("To find the rest: record chips");
  }

  @Test
  void whatGainsNothingBeyondChanceStandsApart() {
    Diagnosis d = SampleDiagnosis.partly(24);
    List<LearnedFinding> learned = new ArrayList<>();
    for (LearnedFinding f : d.learned()) {
      learned.add(
          new LearnedFinding(
              f.effect(),
              f.actsOn(),
              f.dependsOn(),
              f.camera(),
              f.curves(),
              f.scatter(),
              f.follows(),
              f.kind() == LearnedFinding.Kind.CURVE ? new Gain(0.011, 0.4, -1.2, 1.2) : f.gain()));
    }
    List<String> lines = printed(SampleDiagnosis.learning(d, learned), 0);
    int helping = lines.indexOf("What helps without a proven cause:");
    int others =
        lines.indexOf("In the extended model, but held-out kicks do not show that it helps:");
    assertThat(lines.subList(helping, others)).filteredOn(line -> line.startsWith("-")).hasSize(1);
    assertThat(lines.subList(others, lines.size()))
        .filteredOn(line -> line.startsWith("-"))
        .hasSize(3);
    assertThat(String.join(" ", lines).replaceAll(" +", " "))
        .contains(
            "It reduces the rms of held-out kicks by 0.011 mm (0 %; 95 % bounds −1.2 to 1.2 mm).")
        .doesNotContain("also fit better");
  }

  @Test
  void theTableDoesNotHideWhatASingleKickDoes() {
    Diagnosis d = SampleDiagnosis.explained(24);
    Quality base =
        new Quality(13.6, 1.5, 17.8, Map.of(0.5, 514.7, 1.0, 1048.7), Map.of(0.5, 28.1, 1.0, 54.3));
    String text =
        String.join(" ", printed(SampleDiagnosis.with(d, d.causes(), base, List.of()), 0));
    assertThat(text)
        .startsWith("The calibrated model is off by 54 mm after 1 s")
        .contains("54.3")
        .contains("some kicks are predicted far worse than most")
        .contains("of all kicks is 1049 mm");
  }

  @Test
  void aStageThatFailedIsSaid() {
    Diagnosis d = SampleDiagnosis.adequate(4);
    Diagnosis failed = SampleDiagnosis.with(d, List.of(), d.base(), List.of("the search failed"));
    assertThat(String.join(" ", printed(failed, 0)))
        .contains("There may be more to find: the search failed.");
  }

  @Test
  void eightCausesStillFitOnAScreen() {
    Diagnosis d = SampleDiagnosis.explained(24);
    List<Cause> eight = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      eight.addAll(d.causes().stream().map(DiagnosisTextTest::withoutRivals).toList());
    }
    List<String> lines = printed(SampleDiagnosis.with(d, eight, d.base(), List.of()), 5);
    assertThat(lines).anyMatch(line -> line.startsWith("8. "));
  }

  private static Cause withoutRivals(Cause c) {
    return new Cause(
        c.effect(), c.standardErrors(), c.scatter(), c.evidence(), c.gain(), List.of());
  }
}
