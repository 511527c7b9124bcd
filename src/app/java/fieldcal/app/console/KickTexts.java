package fieldcal.app.console;

import fieldcal.app.report.CalibrationReport;
import fieldcal.app.report.CalibrationReportWriter;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The kicks as the pages have them, and since when each is as it is: a decision changes few of many. Not thread-safe. */
final class KickTexts {
  private Map<Integer, Text> texts = Map.of();

  /** Before that version there were other kicks. */
  private long others;

  /** One kick as JSON. */
  private record Text(String json, long since) {}

  /**
   * Takes note of the kicks as they are now.
   *
   * @param kicks all of them
   * @param version of the calibration, higher than before
   */
  void update(List<CalibrationReport.Kick> kicks, long version) throws IOException {
    Map<Integer, Text> next = new LinkedHashMap<>();
    for (CalibrationReport.Kick kick : kicks) {
      String json = CalibrationReportWriter.json(kick);
      Text before = texts.get(kick.id());
      next.put(
          kick.id(), before != null && before.json.equals(json) ? before : new Text(json, version));
    }
    if (!List.copyOf(next.keySet()).equals(List.copyOf(texts.keySet()))) {
      others = version;
    }
    texts = next;
  }

  /** Whether a page that has this version needs only what changed. */
  boolean knows(long version) {
    return version >= others;
  }

  /** Those that changed after a version, as JSON; all after one that is not known. */
  List<String> after(long version) {
    List<String> changed = new ArrayList<>();
    boolean all = !knows(version);
    for (Text text : texts.values()) {
      if (all || text.since > version) {
        changed.add(text.json);
      }
    }
    return changed;
  }
}
