package fieldcal.app.calibrate;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.files.WholeFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads and writes the JSON files of the tools, with errors that name file and line. */
public final class JsonFiles {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private JsonFiles() {}

  /**
   * Writes a document so that a crash leaves either the old file or the new one.
   *
   * @param document what to write
   * @param file where; its directory is made if needed
   * @throws IOException when it cannot be written
   */
  public static void write(JsonNode document, Path file) throws IOException {
    DefaultPrettyPrinter printer = new DefaultPrettyPrinter();
    printer.indentArraysWith(DefaultPrettyPrinter.FixedSpaceIndenter.instance);
    printer.indentObjectsWith(new DefaultIndenter("  ", "\n"));
    byte[] bytes =
        (MAPPER.writer(printer).writeValueAsString(document) + "\n")
            .getBytes(StandardCharsets.UTF_8);
    write(bytes, file);
  }

  /**
   * A document as it is when it was written and read again: numbers of one value are equal, whatever type they had.
   *
   * @param document what would be written
   * @return what would be read
   */
  static JsonNode asRead(JsonNode document) {
    try {
      return MAPPER.readTree(MAPPER.writeValueAsString(document));
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("cannot read what was written: " + e.getMessage(), e);
    }
  }

  /**
   * Writes bytes so that a crash leaves either the old file or the new one.
   *
   * @param bytes what to write
   * @param file where; its directory is made if needed
   * @throws IOException when it cannot be written
   */
  public static void write(byte[] bytes, Path file) throws IOException {
    WholeFile.write(bytes, file);
  }

  /**
   * Reads a whole file.
   *
   * @param file from where
   * @return its bytes
   * @throws InputException when there is no such file, it is a directory, a pipe or a device, or it may not be read
   * @throws IOException when the device fails
   */
  public static byte[] bytes(Path file) throws IOException {
    if (!Files.exists(file)) {
      throw new InputException(file + ": no such file");
    }
    if (Files.isDirectory(file)) {
      throw new InputException(file + ": is a directory; name a file in it");
    }
    if (!Files.isRegularFile(file)) {
      throw new InputException(file + ": is a pipe or a device; save it as a file first");
    }
    if (!Files.isReadable(file)) {
      throw new InputException(file + ": cannot be read; check its permissions");
    }
    return Files.readAllBytes(file);
  }

  /**
   * Reads a document.
   *
   * @param file from where
   * @return its root
   * @throws InputException when there is no such file or it is not JSON
   * @throws IOException when it cannot be read
   */
  public static JsonNode read(Path file) throws IOException {
    try {
      return MAPPER.readTree(bytes(file));
    } catch (JsonProcessingException e) {
      throw new InputException(
          file
              + ", line "
              + (e.getLocation() == null ? 1 : e.getLocation().getLineNr())
              + ": not valid JSON: "
              + e.getOriginalMessage());
    }
  }
}
