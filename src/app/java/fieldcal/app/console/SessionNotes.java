package fieldcal.app.console;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * What a console remembers of a session beyond the decisions about kicks: {@code console.json}.
 *
 * @param schema of the file
 * @param diagnosis the last diagnosis in words; null when there is none
 * @param acceptance what became of its model
 * @param published what was sent, the latest first
 */
@JsonIgnoreProperties(ignoreUnknown = true)
record SessionNotes(
    String schema, DiagnosisNote diagnosis, Acceptance acceptance, List<Publication> published) {
  static final String FILE = "console.json";
  private static final String SCHEMA = "fieldcal.console/1";
  private static final int MOST_PUBLICATIONS = 50;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  SessionNotes {
    acceptance = acceptance == null ? Acceptance.OPEN : acceptance;
    published = published == null ? List.of() : List.copyOf(published);
  }

  /** What the operator said to a model with causes. */
  enum Acceptance {
    /** Nothing yet. */
    OPEN,
    /** The kicks are calibrated with its effects taken out. */
    ACCEPTED,
    /** The simple model stays. */
    REFUSED
  }

  /**
   * A diagnosis in words.
   *
   * @param verdict as in {@code diagnosis.json}
   * @param headline the verdict in one sentence
   * @param lines what it means in numbers
   * @param causes what was found
   * @param dropped the kicks that were left out by hand, to see whether it still holds
   * @param recordings the recordings it was made from, by start and size
   */
  @JsonIgnoreProperties(ignoreUnknown = true)
  record DiagnosisNote(
      String verdict,
      String headline,
      List<String> lines,
      List<CauseNote> causes,
      Set<String> dropped,
      List<String> recordings) {
    /** Copies the lists; notes of an earlier version do not name the recordings. */
    DiagnosisNote {
      recordings = recordings == null ? List.of() : List.copyOf(recordings);
    }
  }

  /**
   * One cause in words.
   *
   * @param effect its id
   * @param name a few words
   * @param what what is wrong
   * @param advice what to do about it
   * @param strength the numbers with their errors
   * @param rivals ids of the causes that would explain the same
   * @param next which kicks tell them apart; may be empty
   */
  @JsonIgnoreProperties(ignoreUnknown = true)
  record CauseNote(
      String effect,
      String name,
      String what,
      String advice,
      String strength,
      List<String> rivals,
      String next) {}

  /**
   * A model that was sent.
   *
   * @param unix when, Unix time in s
   * @param to address and port
   * @param format what kind of packet
   * @param text the model as protobuf's text
   */
  @JsonIgnoreProperties(ignoreUnknown = true)
  record Publication(double unix, String to, String format, String text) {}

  static SessionNotes none() {
    return new SessionNotes(SCHEMA, null, Acceptance.OPEN, List.of());
  }

  /** Reads the notes of an earlier run. */
  static SessionNotes read(Path directory) throws IOException {
    Path file = directory.resolve(FILE);
    if (!Files.exists(file)) {
      return none();
    }
    JsonNode root = JsonFiles.read(file);
    try {
      SessionNotes notes = MAPPER.treeToValue(root, SessionNotes.class);
      if (notes != null && SCHEMA.equals(notes.schema)) {
        return notes;
      }
    } catch (IOException e) {
      // Told below: another program's file.
    }
    throw new InputException(file + ": not the notes of a console (schema " + SCHEMA + ")");
  }

  void write(Path directory) throws IOException {
    JsonFiles.write(MAPPER.valueToTree(this), directory.resolve(FILE));
  }

  SessionNotes withDiagnosis(DiagnosisNote note) {
    return new SessionNotes(SCHEMA, note, Acceptance.OPEN, published);
  }

  SessionNotes with(Acceptance decision) {
    return new SessionNotes(SCHEMA, diagnosis, decision, published);
  }

  SessionNotes with(Publication publication) {
    List<Publication> all = new ArrayList<>(published);
    all.add(0, publication);
    return new SessionNotes(
        SCHEMA, diagnosis, acceptance, all.subList(0, Math.min(all.size(), MOST_PUBLICATIONS)));
  }
}
