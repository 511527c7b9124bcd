package fieldcal.app.console;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.limits.LimitWords;
import fieldcal.app.monitor.CameraFaultText;
import fieldcal.app.monitor.MatchStatus;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.RefereeWords;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.CameraHealth;
import fieldcal.live.KickCounts;
import fieldcal.live.LiveKick;
import fieldcal.live.LiveSnapshot;
import fieldcal.live.MedianPoint;
import fieldcal.live.MovementSnapshot;
import fieldcal.live.ParameterEstimate;
import fieldcal.live.SampleTree;
import fieldcal.movement.Envelope;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.List;

/** A watched match as a page draws it; what is not known is null. */
final class MatchJson {
  private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

  /** More kicks nobody reads at a glance. */
  private static final int KICKS = 12;

  private MatchJson() {}

  static ObjectNode of(MatchStatus status) {
    LiveSnapshot s = status.snapshot();
    ObjectNode root = NODES.objectNode();
    root.put("title", status.feed().title());
    ArrayNode notes = root.putArray("notes");
    status.feed().notes().forEach(notes::add);
    put(root, "time", s.time());
    root.put("counts", s.phase().counts());
    root.set("referee", status.referee().map(MatchJson::referee).orElse(null));
    ArrayNode warnings = root.putArray("warnings");
    s.ball()
        .warnings()
        .forEach(w -> warnings.add(ParameterWords.spelledOut(w.text()) + ". " + w.advice()));
    s.movement().warnings().forEach(w -> warnings.add(w.text() + ". " + w.advice()));
    root.put("enough", SampleTree.ENOUGH);
    ArrayNode parameters = root.putArray("parameters");
    s.ball().parameters().forEach(p -> parameters.add(parameter(p)));
    root.set("kicks", kicks(s.ball().kicks()));
    root.set("kickCounts", counts(s.ball().counts()));
    root.set("teams", teams(s.movement()));
    ArrayNode cameras = root.putArray("cameras");
    s.cameras().forEach(c -> cameras.add(camera(c)));
    ArrayNode faults = root.putArray("cameraFaults");
    CameraFaultText.lines(s.cameraFaults()).forEach(faults::add);
    root.put("strayFrames", s.strayFrames());
    root.put("clockJumps", s.clockJumps());
    return root;
  }

  private static ObjectNode referee(RefereeState r) {
    ObjectNode node = NODES.objectNode();
    node.put("stage", RefereeWords.of(r.stage()));
    node.put("command", RefereeWords.of(r.command()));
    node.put("yellow", r.yellow().name()).put("yellowScore", r.yellow().score());
    node.put("blue", r.blue().name()).put("blueScore", r.blue().score());
    return node;
  }

  private static ObjectNode parameter(ParameterEstimate e) {
    ObjectNode node = NODES.objectNode();
    node.put("name", ParameterWords.inFiles(e.parameter().modelName()));
    node.put("words", ParameterWords.of(e.parameter().modelName()));
    node.put("unit", e.parameter().unit());
    node.put("kind", e.parameter().kind().id());
    put(node, "median", e.median());
    put(node, "lower", e.lowerQuartile());
    put(node, "upper", e.upperQuartile());
    node.put("samples", e.samples()).put("enough", e.enough()).put("warning", e.warning());
    put(node, "published", e.published().orElse(Double.NaN));
    put(node, "percent", 100 * e.deviation());
    ArrayNode history = node.putArray("history");
    for (MedianPoint point : e.history()) {
      history.addArray().add(point.time()).add(point.median()).add(point.samples());
    }
    return node;
  }

  private static ArrayNode kicks(List<LiveKick> all) {
    ArrayNode kicks = NODES.arrayNode();
    for (LiveKick k : all.subList(Math.max(0, all.size() - KICKS), all.size())) {
      ObjectNode node = kicks.addObject();
      node.put("id", k.id());
      put(node, "time", k.time());
      node.put("kind", k.kind().map(kind -> kind.id()).orElse("?"));
      put(node, "speed", k.speed());
      node.put("robot", k.robot().map(Object::toString).orElse("unknown"));
      node.put("end", k.end().id());
      node.put("spin", k.possiblySpinning());
      put(node, "rmsMm", k.rmsMm());
      node.put("unused", k.unused().orElse(null));
      ArrayNode says = node.putArray("says");
      k.samples().keySet().forEach(p -> says.add(ParameterWords.words(p.modelName())));
    }
    return kicks;
  }

  private static ObjectNode counts(KickCounts c) {
    return NODES
        .objectNode()
        .put("found", c.found())
        .put("used", c.used())
        .put("unused", c.unused())
        .put("waiting", c.waiting())
        .put("outsidePlay", c.outsidePlay());
  }

  private static ArrayNode teams(MovementSnapshot movement) {
    ArrayNode teams = NODES.arrayNode();
    for (Team team : Team.values()) {
      TeamLimits now = movement.limits().get(team);
      TeamLimits before = movement.beforeBreak().get(team);
      TeamLimits shown = now != null && now.acceleration().known() || before == null ? now : before;
      ObjectNode node = teams.addObject().put("team", team.label());
      node.put("beforeBreak", shown != null && shown == before);
      if (shown != null) {
        node.set("velocity", limit(shown.velocity(), shown.leagueVelocity()));
        node.set("acceleration", limit(shown.acceleration(), shown.leagueAcceleration()));
        node.set("braking", limit(shown.braking(), shown.leagueBraking()));
        ArrayNode deviations = node.putArray("deviations");
        shown.deviations().forEach(d -> deviations.add(d.effect().sentence()));
        node.set("turning", limit(shown.turning().velocity()));
        node.set("turningFaster", limit(shown.turning().acceleration()));
        node.set("turningSlower", limit(shown.turning().braking()));
        shown.envelopes().stream()
            .filter(Envelope::shaped)
            .forEach(e -> deviations.add(LimitWords.sentence(e)));
        shown.robots().forEach(r -> deviations.add(LimitWords.sentence(r)));
      }
    }
    return teams;
  }

  private static ObjectNode limit(LimitEstimate own, LimitEstimate league) {
    ObjectNode node = limit(own);
    put(node, "league", league.value());
    return node;
  }

  private static ObjectNode limit(LimitEstimate own) {
    ObjectNode node = NODES.objectNode();
    put(node, "value", own.value());
    put(node, "error", own.standardError());
    return node.put("reached", own.reached());
  }

  private static ObjectNode camera(CameraHealth c) {
    ObjectNode node = NODES.objectNode().put("id", c.id());
    put(node, "rateHz", c.rateHz());
    put(node, "silentFor", c.silentFor());
    put(node, "noiseMm", c.noiseMm());
    put(node, "offsetXMm", c.offsetXMm());
    put(node, "offsetYMm", c.offsetYMm());
    put(node, "apartMm", c.apartMm());
    node.put("apartFrom", c.apartFrom().isPresent() ? c.apartFrom().getAsInt() : null);
    node.put("disagrees", c.disagrees());
    node.put("gaps", c.gaps());
    put(node, "longestGap", c.longestGap());
    node.put("calibrated", c.calibrated());
    return node;
  }

  private static void put(ObjectNode node, String name, double value) {
    if (Double.isFinite(value)) {
      node.put(name, value);
    } else {
      node.putNull(name);
    }
  }
}
