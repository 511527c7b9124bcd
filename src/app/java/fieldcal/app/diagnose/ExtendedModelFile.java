package fieldcal.app.diagnose;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedModelDocument;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;

/** {@code extended_model.json}: the bytes around {@link ExtendedModelDocument}. */
public final class ExtendedModelFile {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private ExtendedModelFile() {}

  /**
   * Writes.
   *
   * @param model what to write
   * @param epoch of the model's clock
   * @param from the recordings that it was found in
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void write(ExtendedModel model, Epoch epoch, MadeFrom from, Path file)
      throws IOException {
    ObjectNode document = MAPPER.valueToTree(ExtendedModelDocument.of(model, epoch));
    from.writeTo(document);
    JsonFiles.write(document, file);
  }

  /**
   * Reads.
   *
   * @param file from where
   * @param epoch of the clock on which kicks are told
   * @return the model
   * @throws InputException when there is no such file or it is no extended model, with file and field
   * @throws IOException when it cannot be read
   */
  public static ExtendedModel read(Path file, Epoch epoch) throws IOException {
    JsonNode root = JsonFiles.read(file);
    if (!root.isObject()) {
      throw new InputException(file + ": no extended model, but " + kind(root));
    }
    try {
      return ExtendedModelDocument.read(MAPPER.convertValue(root, Map.class), epoch);
    } catch (IllegalArgumentException e) {
      throw new InputException(file + ", field " + e.getMessage());
    }
  }

  private static String kind(JsonNode root) {
    return root.isMissingNode() ? "empty" : root.isArray() ? "a list" : "a single value";
  }
}
