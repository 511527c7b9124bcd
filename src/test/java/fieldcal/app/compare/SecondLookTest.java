package fieldcal.app.compare;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.app.simulation.RecordingFiles;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.Unexplained;
import fieldcal.fit.FitSettings;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The second look at a field of which a first diagnosis left something unexplained. */
class SecondLookTest {
  @TempDir private static Path folder;

  private static DiagnosisOutcome found;

  @BeforeAll
  static void diagnose() throws IOException {
    RecordingFiles files = RecordingFiles.besides(folder.resolve("field.log"));
    files.write(SimulationSettings.DEFAULT.withScenario(ScenarioKind.FLAT, 8), share -> {});
    found =
        new DiagnosisSession(
                FitSettings.defaults(), DiagnosisProblem.DEFAULT_MAX_CAUSES, LogOpener.USUAL)
            .run(
                List.of(files.log()),
                HandSelection.none(),
                List.of(),
                DiagnosisSession.Progress.UNSEEN);
  }

  /** The same with something unexplained, which predicts held-out kicks that many times worse. */
  private static DiagnosisOutcome lost(double worse) {
    Diagnosis d = found.diagnosis();
    Quality q = d.extended();
    Quality other =
        new Quality(
            q.rmsMm(),
            q.noiseMm(),
            worse * q.holdoutRmsMm(),
            q.predictionErrorMm(),
            q.typicalErrorMm());
    return new DiagnosisOutcome(
        found.calibration(),
        found.problem(),
        SampleDiagnosis.leaving(d, other, new Unexplained(true, 1, 1, List.of())));
  }

  @Test
  void aFieldThatIsExplainedIsNotLookedAtAgain() {
    assertThat(SecondLook.at(found, found, said -> {})).isSameAs(found);
  }

  @Test
  void theSimplerModelStandsUnlessItPredictsWorse() {
    DiagnosisOutcome equal = SecondLook.at(lost(1), found, said -> {});
    assertThat(equal.diagnosis().unexplained().significant()).isFalse();
    assertThat(equal.diagnosis().extended()).isEqualTo(found.diagnosis().extended());
    DiagnosisOutcome better = lost(0.9);
    assertThat(SecondLook.at(better, found, said -> {})).isSameAs(better);
  }
}
