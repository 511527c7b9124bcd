package fieldcal.app.compare;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.compare.FieldComparison.Named;
import fieldcal.app.statistics.Comparison;
import fieldcal.diagnosis.Cause;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;

/** {@code compare.json}; {@code docs/compare.md} describes it. */
final class CompareJson {
  private CompareJson() {}

  static void write(CompareSession.Outcome outcome, Path file) throws IOException {
    FieldComparison c = outcome.comparison();
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("schema", "fieldcal.compare/1");
    side(outcome.real(), root.putObject("real"));
    side(outcome.sim(), root.putObject("sim"));
    root.put("verdict", c.verdict());
    ObjectNode pass = root.putObject("pass");
    pass.put("speed", Cost.PASS);
    number(pass, "real_distance", c.passReal());
    number(pass, "sim_distance", c.passSim());
    ObjectNode prediction = root.putObject("prediction_error_mm");
    c.predictionError()
        .forEach((h, e) -> prediction.put(String.format(Locale.ROOT, "%.1f", h), 1000 * e));
    ArrayNode differences = root.putArray("differences");
    for (Named n : c.differences()) {
      ObjectNode node = differences.addObject();
      node.put("id", n.id());
      node.put("words", n.words());
      node.put("unit", n.unit());
      number(node, "real", n.real());
      number(node, "real_standard_error", n.realError());
      number(node, "sim", n.sim());
      number(node, "sim_standard_error", n.simError());
      number(node, "share_of_prediction_error", n.shareOfError());
      number(node, "share_of_pass", n.shareOfPass());
    }
    ArrayNode parameters = root.putArray("parameters");
    c.parameters().forEach(row -> row(row, parameters.addObject()));
    ArrayNode cameras = root.putArray("cameras");
    for (Comparison k : c.cameras()) {
      ObjectNode node = cameras.addObject();
      node.put("id", k.statistic().id());
      node.put("words", k.statistic().words());
      node.put("unit", k.statistic().unit());
      number(node, "real", k.first());
      number(node, "sim", k.second());
      number(node, "difference", k.difference());
      number(node, "standard_error", k.error());
      number(node, "p_holm", k.pHolm());
      node.put("differs", k.differs(FieldComparison.ALPHA));
    }
    ArrayNode others = root.putArray("others");
    c.others().forEach(row -> row(row, others.addObject()));
    JsonFiles.write(root, file);
  }

  private static void side(Side side, ObjectNode node) {
    ArrayNode sources = node.putArray("sources");
    side.diagnosis().calibration().logs().forEach(p -> sources.add(p.toString()));
    node.put("kicks", side.diagnosis().diagnosis().kicks().size());
    node.put("verdict", side.diagnosis().diagnosis().verdict().name().toLowerCase(Locale.ROOT));
    ArrayNode causes = node.putArray("causes");
    side.diagnosis().diagnosis().causes().stream()
        .map(Cause::effect)
        .forEach(e -> causes.add(e.id()));
  }

  private static void row(Row row, ObjectNode node) {
    node.put("id", row.id());
    node.put("words", row.words());
    node.put("unit", row.unit());
    number(node, "real", row.real());
    number(node, "real_standard_error", row.realError());
    number(node, "sim", row.sim());
    number(node, "sim_standard_error", row.simError());
    node.put("differs", row.differs());
  }

  /** JSON has no NaN: what is not known is null. */
  private static void number(ObjectNode node, String name, double value) {
    if (Double.isFinite(value)) {
      node.put(name, value);
    } else {
      node.putNull(name);
    }
  }
}
