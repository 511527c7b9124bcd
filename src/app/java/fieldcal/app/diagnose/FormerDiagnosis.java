package fieldcal.app.diagnose;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.diagnosis.Verdict;
import fieldcal.verdict.Finding;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What an earlier diagnosis found, and of which kicks. Decides for terminal and console alike whether it still counts.
 *
 * @param finding verdict and causes
 * @param dropped keys of the kicks that were left out by hand
 * @param recordings the {@linkplain RecordingFacts#identity identities} of the recordings, in order
 */
public record FormerDiagnosis(Finding finding, Set<String> dropped, List<String> recordings) {
  /** The file in the directory of the results. */
  public static final String FILE = "diagnosis.json";

  /** Copies the collections. {@inheritDoc} */
  public FormerDiagnosis {
    dropped = Set.copyOf(dropped);
    recordings = List.copyOf(recordings);
  }

  /**
   * Reads what was found before.
   *
   * @param directory of the results
   * @return empty when there is no diagnosis, or none that says of which kicks it is
   */
  public static Optional<FormerDiagnosis> read(Path directory) {
    return document(directory).flatMap(FormerDiagnosis::of);
  }

  private static Optional<JsonNode> document(Path directory) {
    Path file = directory.resolve(FILE);
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    try {
      return Optional.of(JsonFiles.read(file));
    } catch (IOException e) {
      // The file is for the user to read; a verdict does without it.
      return Optional.empty();
    }
  }

  /**
   * The verdict on a model that was calibrated before its diagnosis: the one that the diagnosis made of the same kicks.
   *
   * @param directory of the results
   * @param calibration the content of its {@code calibration.json}
   * @return as in {@code calibration.json}; empty when there is no diagnosis of these kicks, or the calibration counts it already
   */
  public static Optional<JsonNode> verdictOn(Path directory, JsonNode calibration) {
    if (calibration.has("extended_model") || calibration.has("forced_kind")) {
      return Optional.empty();
    }
    return read(directory)
        .filter(
            d ->
                d.dropped.equals(Set.copyOf(texts(calibration.path("dropped_by_hand"))))
                    && d.recordings.equals(texts(calibration.path("recordings"))))
        .filter(d -> !d.isCountedIn(calibration.at("/verdict/reasons")))
        .flatMap(d -> document(directory))
        .map(root -> root.path("model_verdict"))
        .filter(JsonNode::isObject);
  }

  private boolean isCountedIn(JsonNode reasons) {
    for (JsonNode reason : reasons) {
      if (reason.path("reason").asText().equals("diagnosed")) {
        return reason.path("verdict").asText().equals(finding.verdict().id())
            && texts(reason.path("causes")).equals(finding.causes());
      }
    }
    return false;
  }

  private static List<String> texts(JsonNode list) {
    List<String> texts = new ArrayList<>();
    list.forEach(text -> texts.add(text.asText()));
    return texts;
  }

  private static Optional<FormerDiagnosis> of(JsonNode root) {
    JsonNode dropped = root.path("kicks").path("dropped");
    JsonNode from = root.path("recordings");
    if (!DiagnosisJson.SCHEMA.equals(root.path("schema").textValue())
        || !dropped.isArray()
        || !from.isArray()) {
      return Optional.empty();
    }
    List<String> causes = new ArrayList<>();
    root.path("causes").forEach(cause -> causes.add(cause.path("effect").asText()));
    return Verdict.ofId(root.path("verdict").asText())
        .map(
            verdict ->
                new FormerDiagnosis(
                    new Finding(verdict, causes), Set.copyOf(texts(dropped)), texts(from)));
  }

  /**
   * Whether it is a diagnosis of these kicks.
   *
   * @param nowDropped keys of the kicks that are left out by hand now
   * @param now the recordings that are used now, in order
   * @return false when a recording or a decision is another
   */
  public boolean isOf(Set<String> nowDropped, List<RecordingFacts> now) {
    return dropped.equals(nowDropped) && recordings.equals(identities(now));
  }

  /**
   * What it says of a calibration.
   *
   * @param now the calibration
   * @return empty when it was made of other kicks, or all kicks are taken to be of one kind now
   */
  public Optional<Finding> about(CalibrationOutcome now) {
    return now.forced().isEmpty()
            && isOf(now.selection().dropped().keySet(), now.data().recordings())
        ? Optional.of(finding)
        : Optional.empty();
  }

  /**
   * What stays when a file is renamed or a folder is moved, and is another when a file is replaced.
   *
   * @param recordings in order
   * @return the identity of each
   */
  public static List<String> identities(List<RecordingFacts> recordings) {
    return recordings.stream().map(RecordingFacts::identity).toList();
  }
}
