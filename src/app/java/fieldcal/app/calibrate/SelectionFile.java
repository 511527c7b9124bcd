package fieldcal.app.calibrate;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.wording.ParameterWords;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.HandSelection;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalInt;

/**
 * Decisions about kicks as a file that people edit: {@code selection.json}.
 *
 * <p>One entry per kick with its key, number, kind and state, and {@code decision}: {@code auto} (the rules decide), {@code drop} or
 * {@code keep}, with a {@code reason} where there is one; {@code two_sigma_rounds} says how often the 2σ rule is applied. Entries of kicks that are not in the present recordings are kept.
 */
public final class SelectionFile {
  private static final String SCHEMA = "fieldcal.selection/1";

  private static final String ROUNDS = "two_sigma_rounds";

  private SelectionFile() {}

  /**
   * Reads the decisions.
   *
   * @param file from where
   * @return the decisions in it
   * @throws InputException when it is no selection file, with the place
   * @throws IOException when it cannot be read
   */
  public static HandSelection read(Path file) throws IOException {
    JsonNode root = JsonFiles.read(file);
    if (!SCHEMA.equals(root.path("schema").asText()) || !root.path("kicks").isArray()) {
      throw new InputException(
          file + ": not a selection file (schema " + SCHEMA + " with a list of kicks)");
    }
    HandSelection selection = HandSelection.none().withTwoSigmaRounds(rounds(root, file));
    int number = 0;
    for (JsonNode kick : root.path("kicks")) {
      number++;
      String key = kick.path("key").asText();
      String decision = kick.path("decision").asText("auto");
      if (!key.matches("-?\\d+\\.\\d\\d")) {
        throw new InputException(
            file
                + ", kick "
                + number
                + ": key must be a time in seconds with two decimals, not \""
                + key
                + "\"");
      }
      switch (decision) {
        case "auto" -> {}
        case "drop" ->
            selection = selection.drop(key, kick.path("reason").asText("no reason given"));
        case "keep" -> selection = selection.keep(key);
        default ->
            throw new InputException(
                file
                    + ", kick "
                    + number
                    + ": decision must be auto, drop or keep, not \""
                    + decision
                    + "\"");
      }
    }
    return selection;
  }

  private static OptionalInt rounds(JsonNode root, Path file) throws InputException {
    JsonNode rounds = root.path(ROUNDS);
    if (rounds.isMissingNode() || rounds.isNull()) {
      return OptionalInt.empty();
    }
    if (!rounds.canConvertToExactIntegral() || rounds.asInt() < 0) {
      throw new InputException(
          file + ": " + ROUNDS + " must be a number of rounds or null, not " + rounds);
    }
    return OptionalInt.of(rounds.asInt());
  }

  /**
   * Reads the file that was named, or else what a run before left.
   *
   * @param named by the operator; null when none was
   * @param out directory of the results; null when none is wanted
   * @return the decisions; none when there is no file
   * @throws InputException when it is no selection file, with the place
   * @throws IOException when it cannot be read
   */
  public static HandSelection readOrFormer(Path named, Path out) throws IOException {
    if (named != null) {
      return read(named);
    }
    Path former = out == null ? null : out.resolve("selection.json");
    return former != null && Files.exists(former) ? read(former) : HandSelection.none();
  }

  /**
   * Writes the decisions beside what became of each kick.
   *
   * @param calibration the kicks
   * @param selection the decisions it was made with
   * @param epoch of the kicks' times
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void write(Calibration calibration, HandSelection selection, Epoch epoch, Path file)
      throws IOException {
    ObjectNode root = JsonNodeFactory.instance.objectNode();
    root.put("schema", SCHEMA);
    root.put(
        "help",
        "decision: auto = the rules decide, drop = never used, keep = used whatever the rules say;"
            + " two_sigma_rounds: how often the 2σ rule is applied, null = until nothing more is"
            + " excluded");
    OptionalInt rounds = selection.twoSigmaRounds();
    root.put(ROUNDS, rounds.isPresent() ? rounds.getAsInt() : null);
    ArrayNode kicks = root.putArray("kicks");
    Map<String, String> strangers = new LinkedHashMap<>(selection.dropped());
    selection.kept().forEach(key -> strangers.put(key, null));
    for (CalibratedKick kick : calibration.kicks()) {
      String key = HandSelection.key(epoch.unixSeconds(kick.fit().kick().time()));
      ObjectNode entry = kicks.addObject();
      entry.put("key", key);
      entry.put("id", kick.fit().kick().id());
      entry.put("kind", kick.fit().kind().id());
      entry.put("used", kick.selected());
      entry.put(
          "decision",
          selection.isKept(key)
              ? "keep"
              : selection.droppedBecause(key).isPresent() ? "drop" : "auto");
      selection
          .droppedBecause(key)
          .or(() -> kick.rejected().map(ParameterWords::spelledOut))
          .ifPresent(reason -> entry.put("reason", reason));
      strangers.keySet().removeIf(other -> HandSelection.same(other, key));
    }
    strangers.forEach(
        (key, reason) -> {
          ObjectNode entry = kicks.addObject();
          entry.put("key", key);
          entry.put("decision", reason == null ? "keep" : "drop");
          if (reason != null) {
            entry.put("reason", reason);
          }
        });
    JsonFiles.write(root, file);
  }
}
