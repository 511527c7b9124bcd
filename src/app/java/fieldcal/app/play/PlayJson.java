package fieldcal.app.play;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.play.PlayState;
import fieldcal.vision.RobotId;
import java.util.Locale;

/** {@code play.json}: what was played, and what the robots make of their kick commands. */
final class PlayJson {
  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private final PlayRun.Result result;
  private final SessionRequest request;

  PlayJson(PlayRun.Result result, SessionRequest request) {
    this.result = result;
    this.request = request;
  }

  ObjectNode build() {
    SessionSnapshot last = result.session().last();
    PlayState state = last.state();
    ObjectNode root = JSON.objectNode();
    root.put("schema", "fieldcal.play/1");
    root.put("kind", request.kind().id());
    root.put("complete", result.session().complete());
    root.put("reason", result.session().complete() ? null : state.waiting().orElse(""));
    root.put("field_time_s", rounded(last.time()));
    root.put("wanted", state.wanted());
    root.put("good", state.good());
    root.put("adaptive", request.adaptive());
    root.put("seed", request.seed());
    result.session().log().ifPresent(f -> root.put("log", f.getFileName().toString()));
    result.session().commands().ifPresent(f -> root.put("commands", f.getFileName().toString()));
    ArrayNode kicks = root.putArray("kicks");
    last.kicks().forEach(k -> kicks.add(kick(k)));
    ArrayNode undecided = root.putArray("undecided");
    last.undecided().causes().forEach(undecided::add);
    ArrayNode strengths = root.putArray("kick_strength");
    result.strengths().forEach(s -> strengths.add(strength(s)));
    return root;
  }

  private static ObjectNode kick(KickResult kick) {
    ObjectNode node = JSON.objectNode();
    node.put("number", kick.played().number());
    robot(node, kick.played().robot());
    node.put("end", kick.played().end().name().toLowerCase(Locale.ROOT));
    node.put("good", kick.good());
    node.put("used", kick.used());
    node.put("reason", kick.reason().isEmpty() ? null : kick.reason());
    put(node, "rms_mm", kick.rmsMm());
    ObjectNode told = node.putObject("commanded");
    put(told, "speed", kick.played().planned().speed());
    put(told, "direction", Math.IEEEremainder(kick.played().direction(), 2 * Math.PI));
    put(told, "elevation", kick.played().planned().elevation());
    ObjectNode measured = node.putObject("measured");
    put(measured, "speed", kick.speed());
    put(measured, "direction", kick.direction());
    put(measured, "elevation", kick.elevation());
    return node;
  }

  private static ObjectNode strength(KickStrength s) {
    ObjectNode node = JSON.objectNode();
    robot(node, s.robot());
    node.put("kind", s.kind().id());
    node.put("kicks", s.kicks());
    put(node, "gain", s.gain());
    put(node, "gain_error", s.gainError());
    put(node, "offset", s.offset());
    put(node, "offset_error", s.offsetError());
    put(node, "speed_scatter", s.speedScatter());
    put(node, "yaw", s.yaw());
    put(node, "yaw_error", s.yawError());
    put(node, "yaw_scatter", s.yawScatter());
    put(node, "elevation", s.elevation());
    put(node, "elevation_error", s.elevationError());
    put(node, "elevation_scatter", s.elevationScatter());
    return node;
  }

  private static void robot(ObjectNode node, RobotId robot) {
    node.put("team", robot.team().label());
    node.put("robot", robot.number());
  }

  private static void put(ObjectNode node, String name, double value) {
    if (Double.isFinite(value)) {
      node.put(name, rounded(value));
    } else {
      node.putNull(name);
    }
  }

  private static double rounded(double value) {
    return Math.round(value * 1e6) / 1e6;
  }
}
