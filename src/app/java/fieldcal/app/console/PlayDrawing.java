package fieldcal.app.console;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.play.KickResult;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.play.SessionSnapshot;
import fieldcal.app.wording.ParameterWords;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.calibration.Average;
import fieldcal.kick.KickKind;
import fieldcal.play.PlannedKick;
import fieldcal.play.PlayLine;
import fieldcal.play.PlayPlan;
import fieldcal.play.PlayState;
import fieldcal.play.PlayWorld;
import fieldcal.play.PlayedKick;
import fieldcal.play.SpreadKicks;
import fieldcal.play.WaitingFor;
import fieldcal.vision.FieldGeometry;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** A plan and a running play as a page draws them; what is not known is null. */
final class PlayDrawing {
  private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

  private PlayDrawing() {}

  /**
   * What a play would do.
   *
   * @throws ApiException when it does not fit on the field
   */
  static ObjectNode plan(SessionRequest request, FieldGeometry geometry) {
    ObjectNode root = NODES.objectNode();
    root.set("field", field(geometry));
    try {
      PlayPlan plan =
          request.kind() == KickKind.CHIP
              ? PlayPlan.chip(request.first(), request.second(), geometry, request.kicks())
                  .withLines(
                      PlayLine.across(geometry, request.across(), false),
                      PlayLine.across(geometry, request.across(), true))
              : PlayPlan.flat(
                  request.first(), request.second(), geometry, request.half(), request.kicks());
      ArrayNode lines = root.putArray("lines");
      lines.add(line(plan.line()));
      lines.add(line(plan.otherLine()));
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest(e.getMessage());
    }
    SpreadKicks kicks =
        new SpreadKicks(
            request.kicks(),
            request.slowest(),
            request.fastest(),
            request.elevation(),
            request.seed());
    ArrayNode planned = root.putArray("kicks");
    for (int i = 0; i < request.kicks(); i++) {
      PlannedKick kick = kicks.next();
      planned.addObject().put("speed", kick.speed()).put("line", kick.otherLine() ? 1 : 0);
    }
    return root;
  }

  private static ArrayNode line(PlayLine line) {
    return NODES.arrayNode().add(line.x0()).add(line.y0()).add(line.x1()).add(line.y1());
  }

  private static ObjectNode field(FieldGeometry g) {
    return NODES
        .objectNode()
        .put("length", g.length())
        .put("width", g.width())
        .put("boundary", g.boundaryWidth())
        .put("goalWidth", g.goalWidth())
        .put("goalDepth", g.goalDepth())
        .put("centreCircleRadius", 0.5);
  }

  /** The play at one moment. */
  static ObjectNode snapshot(SessionSnapshot s) {
    ObjectNode root = NODES.objectNode();
    PlayState state = s.state();
    put(root, "time", s.time(), 1);
    root.put("phase", state.phase().text()).put("over", state.phase().over());
    root.put("paused", s.paused());
    root.put("waiting", state.waiting().orElse(null));
    root.set("waitingFor", waitingFor(state.waitingFor()));
    root.put("good", state.good()).put("made", state.made()).put("wanted", state.wanted());
    root.put("unjudged", state.unjudged()).put("kicker", state.kicker());
    state.next().ifPresent(next -> put(root, "nextSpeed", next.speed(), 2));
    s.geometry().ifPresent(g -> root.set("field", field(g)));
    root.set("robots", robots(s));
    s.world()
        .ball()
        .ifPresent(
            ball -> {
              ObjectNode node = root.putObject("ball");
              put(node, "x", ball.x(), 3);
              put(node, "y", ball.y(), 3);
              put(node, "speed", ball.speed(), 2);
              put(node, "unseen", s.world().time() - ball.seen(), 1);
            });
    if (s.ballWanted().size() == 2) {
      root.putArray("ballWanted").add(s.ballWanted().get(0)).add(s.ballWanted().get(1));
    }
    ArrayNode kicks = root.putArray("kicks");
    s.kicks().forEach(k -> kicks.add(kick(k)));
    ArrayNode model = root.putArray("model");
    Stream.of(FlatModel.typical().parameters(), ChipModel.typical().parameters().subList(0, 3))
        .flatMap(List::stream)
        .map(Parameter::name)
        .filter(s.model()::containsKey)
        .forEach(
            name -> {
              Average average = s.model().get(name);
              ObjectNode node = model.addObject().put("name", ParameterWords.inFiles(name));
              node.put("words", ParameterWords.withUnit(name)).put("n", average.n());
              put(node, "mean", average.mean(), 6);
              put(node, "error", average.standardError(), 6);
            });
    return root;
  }

  private static ObjectNode waitingFor(WaitingFor object) {
    ObjectNode node = NODES.objectNode();
    object
        .robot()
        .ifPresent(
            id ->
                node.put("team", id.team().name().toLowerCase(Locale.ROOT))
                    .put("number", id.number()));
    object
        .place()
        .ifPresent(
            place -> {
              put(node, "x", place.x(), 3);
              put(node, "y", place.y(), 3);
            });
    return node;
  }

  private static ArrayNode robots(SessionSnapshot s) {
    ArrayNode robots = NODES.arrayNode();
    for (PlayWorld.Robot r : s.world().robots()) {
      ObjectNode node = robots.addObject();
      node.put("team", r.id().team().name().toLowerCase(Locale.ROOT));
      node.put("number", r.id().number());
      put(node, "x", r.x(), 3);
      put(node, "y", r.y(), 3);
      put(node, "orientation", r.orientation(), 3);
      node.put("plays", s.robots().contains(r.id()));
      put(node, "unseen", s.world().time() - r.seen(), 1);
    }
    return robots;
  }

  private static ObjectNode kick(KickResult k) {
    PlayedKick played = k.played();
    ObjectNode node = NODES.objectNode().put("number", played.number());
    node.put("robot", played.robot().toString());
    put(node, "wanted", played.planned().speed(), 2);
    put(node, "speed", k.speed(), 2);
    put(node, "rmsMm", k.rmsMm(), 2);
    node.put("end", played.end().name().toLowerCase(Locale.ROOT).replace('_', ' '));
    node.put("good", k.verdict().orElse(null));
    node.put("reason", k.reason());
    ArrayNode says = node.putArray("says");
    k.parameters().forEach(p -> says.add(ParameterWords.words(p.name())));
    return node;
  }

  private static void put(ObjectNode node, String name, double value, int decimals) {
    double power = Math.pow(10, decimals);
    if (Double.isFinite(value)) {
      node.put(name, Math.rint(value * power) / power);
    } else {
      node.putNull(name);
    }
  }
}
