package fieldcal.app.sslsim;

import fieldcal.proto.SimulatorError;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What a simulator or a bridge says is wrong: so much of it, and in such a length, as an operator reads. Not thread-safe. */
final class Complaints {
  /** What is wrong in more ways than that needs no longer list. */
  static final int MOST = 20;

  /** Characters: two lines of a terminal; a packet could hold 65,000. */
  static final int LONGEST = 200;

  private final String from;
  private final Map<String, Integer> counts = new LinkedHashMap<>();

  /** Of "simulator" or "bridge". */
  Complaints(String from) {
    this.from = from;
  }

  void add(List<SimulatorError> errors) {
    for (SimulatorError error : errors) {
      String text = text(error);
      if (counts.containsKey(text) || counts.size() < MOST) {
        counts.merge(text, 1, Integer::sum);
      }
    }
  }

  static String text(SimulatorError error) {
    String code = error.getCode().isEmpty() ? "" : " (" + error.getCode() + ")";
    String text = error.getMessage() + code;
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "…";
  }

  /** Each with how often it was said. */
  List<String> counted() {
    List<String> lines = new ArrayList<>();
    counts.forEach((text, n) -> lines.add(from + ": " + text + (n > 1 ? ", " + n + " times" : "")));
    return lines;
  }

  /** Each in the same words every time. */
  List<String> all() {
    return counts.keySet().stream().map(text -> from + ": " + text).toList();
  }
}
