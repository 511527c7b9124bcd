package fieldcal.app.twin;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.CommandFile.Command;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.app.limits.LimitsOutcome;
import fieldcal.app.limits.LimitsSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.statistics.FieldRecording;
import fieldcal.app.statistics.RecordedFrames;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Recordings in, a twin and its check out. */
public final class TwinSession {
  private static final String SETTINGS = "twin.json";

  private final FitSettings settings;
  private final LogOpener opener;

  /**
   * A session.
   *
   * @param settings of the fits; their seed is also that of the diagnosis and of the twin's recordings
   * @param opener opens the recordings
   */
  public TwinSession(FitSettings settings, LogOpener opener) {
    this.settings = settings;
    this.opener = opener;
  }

  /**
   * Makes a twin, writes its settings, records the kicks again and compares.
   *
   * @param logs at least one
   * @param commands what the robots were commanded; may be empty
   * @param directory for {@code twin.json}, {@code twin_check.json}, {@code twin.html} and the twin's recordings; made if needed
   * @param progress is called with how far it is
   * @return the twin and its check
   * @throws IOException when a recording cannot be read or a file not be written; one line for the operator
   */
  public TwinOutcome run(
      List<Path> logs, List<Command> commands, Path directory, DiagnosisSession.Progress progress)
      throws IOException {
    DiagnosisOutcome diagnosis =
        new DiagnosisSession(settings, DiagnosisProblem.DEFAULT_MAX_CAUSES, opener)
            .run(logs, HandSelection.none(), commands, progress);
    progress.diagnosing("measuring cameras and robots");
    FieldRecording field = FieldRecording.of(diagnosis.calibration(), opener);
    LimitsOutcome limits = new LimitsSession(1, opener).run(logs, (read, total) -> {});
    Twin twin = new TwinBuilder(diagnosis, field, limits).build();
    Files.createDirectories(directory);
    TwinFile.write(twin, directory.resolve(SETTINGS));
    progress.diagnosing("recording the kicks again");
    List<Path> recordings = record(diagnosis, field, twin, directory, progress);
    CalibrationOutcome again =
        new CalibrationSession(settings)
            .run(
                CalibrationRequest.of(recordings, HandSelection.none(), List.of()),
                CalibrationSession.Progress.UNSEEN);
    TwinCheck check = TwinCheck.of(field, FieldRecording.of(again, LogOpener.USUAL));
    TwinOutcome outcome = new TwinOutcome(twin, diagnosis, recordings, check);
    TwinCheckJson.write(outcome, directory.resolve("twin_check.json"));
    TwinPage.write(outcome, directory.resolve("twin.html"));
    return outcome;
  }

  private List<Path> record(
      DiagnosisOutcome diagnosis,
      FieldRecording field,
      Twin twin,
      Path directory,
      DiagnosisSession.Progress progress)
      throws IOException {
    Recreation recreation = new Recreation(field, diagnosis.diagnosis());
    List<Path> recordings = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (RecordedFrames one : field.frames()) {
      if (one.spans().isEmpty()) {
        continue;
      }
      String name =
          one.log().getFileName().toString().replaceFirst("\\.gz$", "").replaceFirst("\\.log$", "");
      int number = 2;
      for (String wanted = name; !names.add(name); name = wanted + "-" + number++) {
        // Two recordings of one name lie in different directories.
      }
      Path log = directory.resolve(name + ".twin.log.gz");
      recreation.write(
          one, twin.settings().withSeed(settings.seed() + recordings.size()), log, share -> {});
      recordings.add(log);
      progress.diagnosing("recorded " + log.getFileName());
    }
    if (recordings.isEmpty()) {
      throw new InputException(diagnosis.calibration().logs() + ": no frame");
    }
    return recordings;
  }
}
