package fieldcal.app.twin;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.statistics.Comparison;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;

/** {@code twin_check.json}: every statistic of the recording and of its twin, with its test. */
final class TwinCheckJson {
  private TwinCheckJson() {}

  static void write(TwinOutcome outcome, Path file) throws IOException {
    TwinCheck check = outcome.check();
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("schema", "fieldcal.twin_check/1");
    ArrayNode sources = root.putArray("sources");
    outcome.twin().sources().forEach(sources::add);
    ArrayNode recordings = root.putArray("recordings");
    outcome.recordings().forEach(p -> recordings.add(p.getFileName().toString()));
    root.put("kicks", check.kicks());
    root.put("kicks_found_again", check.found());
    root.put("correction", "Holm");
    root.put("alpha", Comparison.ALPHA);
    root.put("share_within_bounds", check.share());
    ArrayNode words = root.putArray("not_reproduced");
    check.sentences().forEach(words::add);
    ArrayNode parameters = root.putArray("parameters");
    for (TwinCheck.Parameter p : check.parameters()) {
      parameters
          .addObject()
          .put("name", p.name())
          .put("recorded", p.recorded())
          .put("recorded_standard_error", p.recordedError())
          .put("twin", p.twin())
          .put("twin_standard_error", p.twinError())
          .put("sigmas", p.sigmas());
    }
    ArrayNode statistics = root.putArray("statistics");
    for (Comparison c : check.comparisons()) {
      statistics.add(statistic(c, "recorded", "twin"));
    }
    JsonFiles.write(root, file);
  }

  private static ObjectNode statistic(Comparison c, String first, String second) {
    ObjectNode node = new ObjectMapper().createObjectNode();
    node.put("id", c.statistic().id());
    node.put("words", c.statistic().words());
    node.put("unit", c.statistic().unit());
    node.put("test", c.statistic().comparison().name().toLowerCase(Locale.ROOT));
    node.put("samples", c.samples());
    node.put(first, c.first());
    node.put(second, c.second());
    node.put("difference", c.difference());
    node.put("standard_error", c.error());
    node.put("p", c.p());
    node.put("p_holm", c.pHolm());
    node.put("differs", c.differs());
    return node;
  }
}
