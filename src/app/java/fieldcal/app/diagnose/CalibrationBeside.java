package fieldcal.app.diagnose;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** What became of a calibration of the same kicks that was in the directory before a diagnosis was written there. */
public enum CalibrationBeside {
  /** There is none of these kicks, or it counts this diagnosis already. */
  NONE,
  /** It was the very same calibration, so its files were written again with the new verdict. */
  JUDGED_AGAIN,
  /** It was made with other options, so its files are as they were, with a verdict that does not count the diagnosis. */
  OUTDATED;

  /**
   * Makes the verdict in a directory that of a diagnosis which was written there.
   *
   * @param outcome the diagnosis
   * @param directory of the results
   * @return what was done
   * @throws IOException when a file cannot be written
   */
  public static CalibrationBeside judgeAgain(DiagnosisOutcome outcome, Path directory)
      throws IOException {
    Path file = directory.resolve("calibration.json");
    if (!Files.isRegularFile(file)) {
      return NONE;
    }
    JsonNode before;
    try {
      before = JsonFiles.read(file);
    } catch (InputException e) {
      // Whatever it is, it is no calibration of these kicks.
      return NONE;
    }
    if (FormerDiagnosis.verdictOn(directory, before).isEmpty()) {
      return NONE;
    }
    CalibrationOutcome judged = outcome.judged();
    if (!CalibrationSession.isIn(before, judged)) {
      return OUTDATED;
    }
    CalibrationSession.writeAll(judged, directory);
    return JUDGED_AGAIN;
  }
}
