package fieldcal.app.diagnose;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.verdict.Surroundings;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** What the command would hold in its hands after a diagnosis that is given. */
public final class SampleOutcome {
  /** Of the kicks' times. */
  public static final Epoch EPOCH = new Epoch(1_763_712_345_000_000_000L);

  private SampleOutcome() {}

  /** With so many remarks about the data. */
  public static DiagnosisOutcome of(Diagnosis diagnosis, int problems) {
    List<Kick> kicks = diagnosis.kicks().stream().map(KickResiduals::kick).toList();
    CameraViews cameras =
        CameraViews.of(
            SampleDiagnosis.observers().stream()
                .map(o -> CameraView.of(o.id(), o.camera()))
                .toList());
    CollectedKicks data =
        new CollectedKicks(
            EPOCH,
            kicks,
            kicks.stream().collect(Collectors.toMap(Kick::id, k -> "friday.log.gz")),
            cameras,
            SampleDiagnosis.observers(),
            Map.of(),
            Optional.empty(),
            BallModels.NONE,
            java.util.stream.IntStream.range(0, problems)
                .mapToObj(i -> new DataProblem("friday.log.gz", "remark " + i, 1, "nothing to do"))
                .toList(),
            0.5,
            List.of(),
            300,
            Map.of());
    List<CommandFile.Command> commands = List.of();
    CalibrationOutcome calibration =
        new CalibrationOutcome(
            List.of(Path.of("friday.log.gz")),
            data,
            BallModels.NONE,
            HandSelection.none(),
            commands,
            new Calibration(
                List.of(), Map.of(), Map.of(), Optional.empty(), cameras, diagnosis.seed()),
            Optional.empty(),
            Surroundings.UNKNOWN,
            Optional.empty(),
            Optional.empty());
    DiagnosisProblem problem =
        new DiagnosisProblem(
            List.of(), cameras, SampleDiagnosis.observers(), 0.5, Map.of(), 8, diagnosis.seed());
    return new DiagnosisOutcome(calibration, problem, diagnosis);
  }

  /** One whose diagnosis did not use two of its kicks: one was given to it, the other had no fit. */
  public static DiagnosisOutcome without(
      Diagnosis whole, KickResiduals given, KickResiduals unfitted) {
    DiagnosisOutcome all = of(whole, 0);
    DiagnosisProblem p = all.problem();
    KickFit fit =
        new KickFitter(FitSettings.defaults())
            .fit(
                FitProblem.of(
                    given.kick(),
                    p.cameras(),
                    whole.model().flat().orElseThrow(),
                    whole.model().chip().orElseThrow()),
                given.kind());
    List<KickResiduals> used =
        whole.kicks().stream().filter(k -> k != given && k != unfitted).toList();
    return new DiagnosisOutcome(
        all.calibration(),
        new DiagnosisProblem(
            List.of(fit),
            p.cameras(),
            p.observers(),
            p.sessionStart(),
            p.commands(),
            p.maxCauses(),
            p.seed()),
        SampleDiagnosis.of(whole, used));
  }
}
