package fieldcal.app.calibrate;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.wording.RecordingNames;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The recordings that a result was made from, as {@code calibration.json}, {@code diagnosis.json} and {@code extended_model.json} name them.
 *
 * @param sources paths, as they were given
 * @param recordings the {@linkplain RecordingFacts#identity identities} of those that were used, in order; empty when they are not known
 */
public record MadeFrom(List<String> sources, List<String> recordings) {
  /** Of a file that does not say it. */
  public static final MadeFrom UNKNOWN = new MadeFrom(List.of(), List.of());

  /** Copies the lists. {@inheritDoc} */
  public MadeFrom {
    sources = List.copyOf(sources);
    recordings = List.copyOf(recordings);
  }

  /**
   * What a calibration was made from.
   *
   * @param outcome the calibration
   * @return its recordings
   */
  public static MadeFrom of(CalibrationOutcome outcome) {
    return new MadeFrom(
        outcome.logs().stream().map(Path::toString).toList(),
        outcome.data().recordings().stream().map(RecordingFacts::identity).toList());
  }

  /**
   * What a document was made from.
   *
   * @param document the content of the file
   * @return its recordings
   */
  public static MadeFrom of(JsonNode document) {
    return new MadeFrom(texts(document.path("sources")), texts(document.path("recordings")));
  }

  /**
   * What a file was made from.
   *
   * @param file that may be there
   * @return its recordings; unknown when the file is missing or cannot be read
   */
  public static MadeFrom read(Path file) {
    if (!Files.isRegularFile(file)) {
      return UNKNOWN;
    }
    try {
      return of(JsonFiles.read(file));
    } catch (IOException e) {
      // Who needs the file itself says what is wrong with it.
      return UNKNOWN;
    }
  }

  private static List<String> texts(JsonNode list) {
    List<String> texts = new ArrayList<>();
    list.forEach(text -> texts.add(text.asText()));
    return texts;
  }

  /**
   * Adds the fields {@code sources} and {@code recordings}.
   *
   * @param document to which
   */
  public void writeTo(ObjectNode document) {
    ArrayNode paths = document.putArray("sources");
    sources.forEach(paths::add);
    ArrayNode identities = document.putArray("recordings");
    recordings.forEach(identities::add);
  }

  /**
   * What tells these recordings from others, for people.
   *
   * @param others from which
   * @return for example "other recordings (a.log.gz)"; empty when they are the same, or one of both is not known
   */
  public Optional<String> unlike(MadeFrom others) {
    boolean known = !recordings.isEmpty() && !others.recordings.isEmpty();
    if (!known || Set.copyOf(recordings).equals(Set.copyOf(others.recordings))) {
      return Optional.empty();
    }
    // A file that replaced another one often has its name.
    String names = names().equals(others.names()) ? " of the same names" : "";
    return Optional.of("other recordings" + names + " (" + RecordingNames.of(names()) + ")");
  }

  private List<String> names() {
    return sources.stream().map(path -> path.replaceFirst("^.*[/\\\\]", "")).toList();
  }
}
