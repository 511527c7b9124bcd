package fieldcal.app.history;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A model that left the session.
 *
 * @param schema of the line
 * @param id counts from 1 in the order of the file
 * @param unix when, Unix time in s
 * @param action what was done
 * @param target who got it, as {@code export --to} takes it, or {@code packet} for one that was sent
 * @param place the file, address or URL
 * @param verdict what the calibration said of itself; null when it said nothing
 * @param sources the recordings
 * @param kicks numbers of the kicks that were used
 * @param model parameters by the names of {@code calibration.json}, SI; limits of robots with {@code yellow.} or {@code blue.} before them
 * @param text the model as protobuf's text; null when there is no ball model
 * @param before file in {@code history/} that holds what was there before; null when there was nothing
 * @param undoes id of the entry that this one put back; null when it did not
 */
@JsonIgnoreProperties(ignoreUnknown = true)
@JsonInclude(JsonInclude.Include.NON_NULL)
public record HistoryEntry(
    String schema,
    int id,
    double unix,
    Action action,
    String target,
    String place,
    String verdict,
    List<String> sources,
    List<Integer> kicks,
    Map<String, Double> model,
    String text,
    String before,
    Integer undoes) {

  /** Name and version of a line. */
  public static final String SCHEMA = "fieldcal.history/1";

  /** What was done. */
  public enum Action {
    /** Sent as a packet. */
    PUBLISHED,
    /** Written into a file. */
    EXPORTED,
    /** Written into a running program. */
    APPLIED,
    /** What was there before was put back. */
    ROLLED_BACK
  }

  /** Fills in what a line lacks. {@inheritDoc} */
  public HistoryEntry {
    sources = sources == null ? List.of() : List.copyOf(sources);
    kicks = kicks == null ? List.of() : List.copyOf(kicks);
    // By name: each line of the file has them in the same order.
    model = model == null ? Map.of() : Collections.unmodifiableMap(new TreeMap<>(model));
  }

  /**
   * The entry that says that this one was undone.
   *
   * @param when Unix time, s
   * @return an entry without a number
   */
  public HistoryEntry undone(double when) {
    return new HistoryEntry(
        SCHEMA,
        0,
        when,
        Action.ROLLED_BACK,
        target,
        place,
        null,
        List.of(),
        List.of(),
        Map.of(),
        null,
        null,
        id);
  }

  /**
   * The entry that says that this one's model was sent again.
   *
   * @param when Unix time, s
   * @return an entry without a number
   */
  public HistoryEntry again(double when) {
    return new HistoryEntry(
        SCHEMA,
        0,
        when,
        Action.PUBLISHED,
        target,
        place,
        verdict,
        sources,
        kicks,
        model,
        text,
        null,
        null);
  }

  HistoryEntry numbered(int number) {
    return new HistoryEntry(
        schema, number, unix, action, target, place, verdict, sources, kicks, model, text, before,
        undoes);
  }
}
