package fieldcal.app.monitor;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.live.BallSamples;
import fieldcal.live.LiveStateDocument;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** The samples of earlier matches in a file: the bytes around {@link LiveStateDocument}. */
public final class StateFile {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private StateFile() {}

  /**
   * Reads.
   *
   * @param file from where
   * @return the samples; none when there is no such file yet
   * @throws InputException when it is no state, with file and field
   * @throws IOException when it cannot be read
   */
  public static BallSamples read(Path file) throws IOException {
    if (!Files.exists(file)) {
      return BallSamples.NONE;
    }
    JsonNode root = JsonFiles.read(file);
    if (!root.isObject()) {
      throw new InputException(
          file + ": is not a state file of monitor; name another file for --state");
    }
    try {
      return LiveStateDocument.read(MAPPER.convertValue(root, Map.class));
    } catch (IllegalArgumentException e) {
      throw new InputException(file + ", field " + e.getMessage());
    }
  }

  /**
   * Whether it can be written when the match is over: to be told then would be too late.
   *
   * @param file where
   * @throws InputException when it cannot, with file and reason
   */
  static void check(Path file) throws InputException {
    if (Files.isDirectory(file)) {
      throw new InputException(file + ": is a directory; --state needs a file");
    }
    Path place = file.toAbsolutePath().getParent();
    while (!Files.exists(place)) {
      place = place.getParent();
    }
    if (!Files.isDirectory(place) || !Files.isWritable(place)) {
      throw new InputException(
          file
              + ": cannot be written, because "
              + place
              + " is not a directory that may be written to");
    }
  }

  /**
   * Writes.
   *
   * @param state what to keep
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void write(BallSamples state, Path file) throws IOException {
    JsonNode document = MAPPER.valueToTree(LiveStateDocument.of(state));
    JsonFiles.write(document, file);
  }
}
