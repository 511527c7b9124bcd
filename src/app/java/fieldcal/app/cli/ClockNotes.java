package fieldcal.app.cli;

import fieldcal.app.wording.ClockWords;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.ClockComparison;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** What {@code info} says of clocks that differ: cameras of which the same is to be said share a line. */
final class ClockNotes {
  private static final double DAY = 86_400;
  private static final double YEAR = 365.25 * DAY;

  private final List<CameraStatistics> cameras;

  ClockNotes(List<CameraStatistics> cameras) {
    this.cameras = cameras;
  }

  /** One sentence for each thing; empty when all clocks agree. */
  List<String> lines() {
    Map<String, List<Integer>> notes = new LinkedHashMap<>();
    for (CameraStatistics camera : cameras) {
      for (String note : notes(camera)) {
        notes.computeIfAbsent(note, n -> new ArrayList<>()).add(camera.id());
      }
    }
    List<String> lines = new ArrayList<>();
    notes.forEach(
        (note, ids) ->
            lines.add(
                (ids.size() == 1 ? "camera " : "cameras ")
                    + ids.stream().map(String::valueOf).collect(Collectors.joining(", "))
                    + ": "
                    + note));
    return lines;
  }

  private static List<String> notes(CameraStatistics camera) {
    List<String> notes = new ArrayList<>();
    double difference = camera.clockDifference();
    if (camera.clocksDiffer()) {
      notes.add(
          "the clock is "
              + amount(Math.abs(difference))
              + (difference > 0 ? " behind" : " ahead of")
              + " the recorder's, so the latency is not known");
    }
    if (Math.abs(camera.clockRate() - 1) > ClockComparison.NOTABLE_RATE) {
      notes.add(
          "the clock "
              + ClockWords.rate(camera.clockRate())
              + "; if the camera's clock is wrong, all speeds are wrong, too");
    }
    return notes;
  }

  private static String amount(double seconds) {
    if (seconds >= YEAR) {
      return String.format(Locale.ROOT, "%.1f years", seconds / YEAR);
    }
    if (seconds >= DAY) {
      return String.format(Locale.ROOT, "%.1f days", seconds / DAY);
    }
    return seconds >= 1
        ? String.format(Locale.ROOT, "%.1f s", seconds)
        : String.format(Locale.ROOT, "%.0f ms", 1000 * seconds);
  }
}
