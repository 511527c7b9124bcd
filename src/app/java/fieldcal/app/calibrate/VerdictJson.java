package fieldcal.app.calibrate;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.PropertyNamingStrategies;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.PublishWords;
import fieldcal.kick.KickKind;
import fieldcal.verdict.PublishVerdict;
import fieldcal.verdict.Reason;
import java.util.List;
import java.util.Map;

/** The verdict in {@code calibration.json} and {@code diagnosis.json}: typed reasons with their numbers for scripts, and the same in words. */
public final class VerdictJson {
  private static final ObjectMapper MAPPER =
      new ObjectMapper().setPropertyNamingStrategy(PropertyNamingStrategies.SNAKE_CASE);
  private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

  private VerdictJson() {}

  /**
   * Builds it.
   *
   * @param verdict of the library
   * @return decision, reasons, and the same in words
   */
  public static ObjectNode of(PublishVerdict verdict) {
    ObjectNode node = NODES.objectNode();
    PublishWords words = PublishWords.of(verdict);
    node.put("decision", verdict.decision().id());
    node.put("headline", words.headline());
    node.put("run_diagnose", verdict.diagnose());
    ObjectNode models = node.putObject("models");
    for (KickKind kind : KickKind.values()) {
      verdict.decision(kind).ifPresent(d -> models.put(kind.id(), d.id()));
    }
    ArrayNode reasons = node.putArray("reasons");
    verdict.reasons().forEach(r -> reasons.add(reason(r)));
    strings(node.putArray("because"), words.reasons());
    strings(node.putArray("notes"), words.notes());
    strings(node.putArray("to_do"), words.toDo());
    return node;
  }

  private static void strings(ArrayNode to, List<String> all) {
    all.forEach(to::add);
  }

  private static ObjectNode reason(Reason reason) {
    ObjectNode node = NODES.objectNode();
    node.put("reason", reason.id());
    node.put("decision", reason.decision().id());
    reason.model().ifPresent(kind -> node.put("model", kind.id()));
    JsonNode numbers = MAPPER.valueToTree(reason);
    for (Map.Entry<String, JsonNode> one : numbers.properties()) {
      boolean known = !one.getValue().isDouble() || Double.isFinite(one.getValue().asDouble());
      if (one.getKey().equals("parameter")) {
        node.put("parameter", ParameterWords.inFiles(one.getValue().asText()));
      } else if (known && !one.getKey().equals("kind") && !node.has(one.getKey())) {
        node.set(one.getKey(), one.getValue());
      }
    }
    if (node.path("verdict").isTextual()) {
      node.put("verdict", ((Reason.Diagnosed) reason).verdict().id());
    }
    return node;
  }
}
