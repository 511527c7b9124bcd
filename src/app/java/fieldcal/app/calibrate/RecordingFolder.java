package fieldcal.app.calibrate;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.recording.ReadableRecordings;
import fieldcal.app.recording.RecordingChoice;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The recordings of a folder, what the robots were commanded in them, and which of them somebody decided to use or to leave out ({@code recordings.json}). */
public final class RecordingFolder {
  /** Name of the file with the decisions. */
  public static final String DECISIONS = "recordings.json";

  private static final String SCHEMA = "fieldcal.recordings/1";

  /** How files end that say what the robots were commanded: {@code commands.csv}, {@code practice.commands.csv}. */
  private static final String COMMANDS = "commands.csv";

  private RecordingFolder() {}

  /**
   * The recordings.
   *
   * @param folder to look into, not into its subfolders
   * @return its game logs, by name
   * @throws IOException when it cannot be listed
   */
  public static List<Path> logs(Path folder) throws IOException {
    return files(folder, ".log", ".log.gz");
  }

  /**
   * What the robots were commanded, of all recordings; a full disk may have left an empty file.
   *
   * @param folder to look into
   * @return the commands
   * @throws IOException when a file cannot be read
   */
  public static List<CommandFile.Command> commands(Path folder) throws IOException {
    return commands(folder, List.of());
  }

  /**
   * What the robots were commanded, but not in recordings that are left out.
   *
   * @param folder to look into
   * @param leftOut its recordings that are not used; the commands beside them have their names
   * @return the commands
   * @throws IOException when a file cannot be read
   */
  public static List<CommandFile.Command> commands(Path folder, List<Path> leftOut)
      throws IOException {
    Set<String> skipped =
        leftOut.stream()
            .map(log -> log.getFileName().toString().replaceFirst("log(\\.gz)?$", COMMANDS))
            .collect(Collectors.toSet());
    List<CommandFile.Command> all = new ArrayList<>();
    for (Path file : files(folder, COMMANDS)) {
      if (!skipped.contains(file.getFileName().toString()) && Files.size(file) > 0) {
        all.addAll(CommandFile.read(file));
      }
    }
    return all;
  }

  private static List<Path> files(Path folder, String... endings) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> endsWith(file.getFileName().toString(), endings))
          .filter(Files::isRegularFile)
          .sorted()
          .toList();
    } catch (UncheckedIOException e) {
      // The disk was pulled out while it was listed.
      throw e.getCause();
    }
  }

  private static boolean endsWith(String name, String... endings) {
    return Stream.of(endings).anyMatch(name.toLowerCase(Locale.ROOT)::endsWith);
  }

  /**
   * Chooses which recordings of a folder are calibrated together.
   *
   * @param readable those of its recordings that can be read
   * @param folder with the decisions
   * @return the choice
   * @throws IOException when the decisions cannot be read
   */
  public static RecordingChoice choice(ReadableRecordings readable, Path folder)
      throws IOException {
    return RecordingChoice.of(readable.facts(), decisions(folder));
  }

  /**
   * What somebody decided.
   *
   * @param folder of the recordings
   * @return by the name of a file whether it is used; empty when nothing was decided
   * @throws IOException when the file cannot be read, or is another program's
   */
  public static Map<String, Boolean> decisions(Path folder) throws IOException {
    Path file = folder.resolve(DECISIONS);
    Map<String, Boolean> decided = new TreeMap<>();
    if (!Files.exists(file)) {
      return decided;
    }
    JsonNode root = JsonFiles.read(file);
    if (!root.path("schema").asText().equals(SCHEMA) || !root.path("use").isObject()) {
      throw new InputException(
          file + ": is not a file with decisions about recordings (schema " + SCHEMA + ")");
    }
    for (Map.Entry<String, JsonNode> one : root.path("use").properties()) {
      if (!one.getValue().isBoolean()) {
        throw new InputException(file + ": use." + one.getKey() + " must be true or false");
      }
      decided.put(one.getKey(), one.getValue().asBoolean());
    }
    return decided;
  }

  /**
   * Keeps decisions.
   *
   * @param folder of the recordings
   * @param decided by the name of a file whether it is used
   * @throws IOException when the file cannot be written
   */
  public static void decide(Path folder, Map<String, Boolean> decided) throws IOException {
    ObjectNode root = JsonNodeFactory.instance.objectNode();
    root.put("schema", SCHEMA);
    ObjectNode use = root.putObject("use");
    decided.forEach(use::put);
    JsonFiles.write(root, folder.resolve(DECISIONS));
  }
}
