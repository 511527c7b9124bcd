package fieldcal.app.recording;

import fieldcal.gamelog.GameLogException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The recordings of a folder that can be read. One that a full disk cut off before its first byte, or that is no recording, must not take all others from the operator.
 *
 * @param facts of those that can be read, in order
 * @param broken why the others cannot be read
 */
public record ReadableRecordings(List<RecordingFacts> facts, Map<Path, String> broken) {

  /** Copies list and map. */
  public ReadableRecordings {
    facts = List.copyOf(facts);
    broken = Collections.unmodifiableMap(new TreeMap<>(broken));
  }

  /**
   * Looks at each.
   *
   * @param logs of a folder
   * @param opener opens them
   * @return those that can be read, and the others
   * @throws GameLogException when there are some and none can be read; the message names file and place
   * @throws IOException when the disk fails
   */
  public static ReadableRecordings of(List<Path> logs, LogOpener opener) throws IOException {
    List<RecordingFacts> good = new ArrayList<>();
    Map<Path, String> broken = new TreeMap<>();
    GameLogException last = null;
    for (Path log : logs) {
      try {
        good.add(RecordingFacts.of(log, opener));
      } catch (GameLogException e) {
        broken.put(log, e.getMessage());
        last = e;
      }
    }
    if (good.isEmpty() && last != null) {
      throw last;
    }
    return new ReadableRecordings(good, broken);
  }

  /**
   * The others as problems of the data: a report that is silent about a recording would pass for one of all of them.
   *
   * @return one for each
   */
  public List<DataProblem> problems() {
    return broken.entrySet().stream()
        .map(
            e ->
                new DataProblem(
                    e.getKey().getFileName().toString(), "cannot be read", 1, e.getValue()))
        .toList();
  }
}
