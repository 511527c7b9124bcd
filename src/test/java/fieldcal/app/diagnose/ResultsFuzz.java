package fieldcal.app.diagnose;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.hardening.ParserFuzz;
import fieldcal.app.report.diagnosis.SampleDiagnosis;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What lies in the directory of the results from an earlier run, for {@link ParserFuzz}. */
public final class ResultsFuzz {
  private static final String CALIBRATION = "calibration.json";

  private ResultsFuzz() {}

  /**
   * The diagnosis and the calibration of the same kicks.
   *
   * @param scratch a folder
   * @return by name
   * @throws IOException when the good files cannot be made
   */
  public static Map<String, ParserFuzz.Target> targets(Path scratch) throws IOException {
    DiagnosisOutcome outcome = SampleOutcome.of(SampleDiagnosis.explained(2), 1);
    Path folder = Files.createDirectories(scratch.resolve("results"));
    Path diagnosis = folder.resolve(FormerDiagnosis.FILE);
    Path calibration = folder.resolve(CALIBRATION);
    DiagnosisSession.writeJson(outcome, diagnosis);
    CalibrationSession.writeJson(outcome.calibration(), calibration);
    JsonNode calibrated = JsonFiles.read(calibration);
    Map<String, ParserFuzz.Target> all = new LinkedHashMap<>();
    List<byte[]> found = List.of(Files.readAllBytes(diagnosis), small());
    all.put("diagnosis", new ParserFuzz.Target(b -> former(b, scratch, calibrated), found));
    all.put(
        "calibration-beside",
        new ParserFuzz.Target(
            bytes -> beside(bytes, folder, outcome), List.of(Files.readAllBytes(calibration))));
    return all;
  }

  /** Without the numbers, of which a verdict reads none: more changes hit what it reads. */
  private static byte[] small() {
    return """
    {"schema": "fieldcal.diagnosis/1", "verdict": "explained", "recordings": ["5 ns, 7 bytes"], "sources": ["a.log"],
     "causes": [{"effect": "air_drag"}], "kicks": {"dropped": ["12.5"]}, "model_verdict": {"decision": "publish"}}
    """
        .getBytes(java.nio.charset.StandardCharsets.UTF_8);
  }

  private static void former(byte[] bytes, Path scratch, JsonNode calibrated) throws IOException {
    Path file = scratch.resolve(FormerDiagnosis.FILE);
    ParserFuzz.replace(file, bytes);
    MadeFrom.read(file).unlike(MadeFrom.of(calibrated));
    FormerDiagnosis.verdictOn(scratch, calibrated);
    if (FormerDiagnosis.read(scratch).isEmpty()) {
      throw new IOException("no diagnosis, or of which kicks it is not known");
    }
  }

  private static void beside(byte[] bytes, Path folder, DiagnosisOutcome outcome)
      throws IOException {
    Path file = folder.resolve(CALIBRATION);
    ParserFuzz.replace(file, bytes);
    MadeFrom.read(file).unlike(MadeFrom.of(outcome.calibration()));
    if (CalibrationBeside.judgeAgain(outcome, folder) == CalibrationBeside.NONE) {
      throw new IOException("no calibration of these kicks");
    }
  }
}
