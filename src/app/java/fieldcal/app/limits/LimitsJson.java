package fieldcal.app.limits;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.recording.DataProblem;
import fieldcal.movement.Envelope;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.MovementStatistics;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.SpeedCap;
import fieldcal.movement.TeamLimits;
import fieldcal.movement.TurnLimits;
import fieldcal.vision.Team;

/** Builds {@code limits.json}. SI units; of what is not known the contract's fields are null; never NaN. */
final class LimitsJson {
  static final String SCHEMA = "fieldcal.limits/1";

  private final LimitsOutcome outcome;
  private final JsonNodeFactory nodes = JsonNodeFactory.instance;

  LimitsJson(LimitsOutcome outcome) {
    this.outcome = outcome;
  }

  ObjectNode build() {
    ObjectNode root = nodes.objectNode();
    root.put("schema", SCHEMA);
    ArrayNode sources = root.putArray("sources");
    outcome.logs().forEach(log -> sources.add(log.toString()));
    put(root, "duration", outcome.duration());
    ObjectNode teams = root.putObject("teams");
    for (Team team : Team.values()) {
      teams.set(team.label(), team(outcome.limits(team)));
    }
    MovementStatistics statistics = outcome.statistics();
    root.put("referee_seen", statistics.refereeSeen());
    put(root, "noise_mm", outcome.noiseMm());
    put(root, "standing_noise_mm", statistics.standingNoiseMm());
    root.put("detections", statistics.detections());
    root.put("counted_detections", statistics.counted());
    root.put("refused_detections", statistics.refused());
    root.put("repeated_frames", statistics.repeatedFrames());
    ArrayNode problems = root.putArray("problems");
    for (DataProblem p : outcome.problems()) {
      problems.addObject().put("where", p.where()).put("what", p.what()).put("count", p.count());
    }
    return root;
  }

  private ObjectNode team(TeamLimits limits) {
    ObjectNode node = estimates(limits.velocity(), limits.acceleration(), limits.braking());
    node.set(
        "league",
        estimates(limits.leagueVelocity(), limits.leagueAcceleration(), limits.leagueBraking()));
    TurnLimits turning = limits.turning();
    node.set("angular", estimates(turning.velocity(), turning.acceleration(), turning.braking()));
    ArrayNode effects = node.putArray("effects");
    limits.deviations().forEach(d -> effects.add(effect(d)));
    ArrayNode envelopes = node.putArray("envelopes");
    limits.envelopes().forEach(e -> envelopes.add(envelope(e)));
    ArrayNode robots = node.putArray("robots");
    for (RobotDifference r : limits.robots()) {
      ObjectNode one = robots.addObject().put("robot", r.robot()).put("limit", r.quantity());
      put(one, "value", r.value());
      put(one, "standard_error", r.standardError());
      put(one, "of_others", r.ofOthers());
      one.put("manoeuvres", r.manoeuvres());
    }
    ArrayNode caps = node.putArray("speed_caps");
    for (SpeedCap cap : limits.speedCaps()) {
      ObjectNode one = caps.addObject().put("robot", cap.robot());
      put(one, "velocity_max", cap.speed());
      put(one, "standard_error", cap.standardError());
      one.put("samples", cap.samples());
    }
    node.put("manoeuvres", limits.manoeuvres());
    node.put("name", outcome.names().get(limits.team()));
    return node;
  }

  private ObjectNode estimates(
      LimitEstimate velocity, LimitEstimate acceleration, LimitEstimate braking) {
    ObjectNode node = nodes.objectNode();
    ObjectNode samples = nodes.objectNode();
    ObjectNode errors = nodes.objectNode();
    ObjectNode reached = nodes.objectNode();
    ObjectNode notes = nodes.objectNode();
    String[] names = {"velocity_max", "acceleration_max", "braking_max"};
    LimitEstimate[] all = {velocity, acceleration, braking};
    for (int i = 0; i < names.length; i++) {
      put(node, names[i], all[i].value());
      samples.put(names[i], all[i].samples());
      put(errors, names[i], all[i].standardError());
      reached.put(names[i], all[i].reached());
      if (!all[i].note().isEmpty()) {
        notes.put(names[i], all[i].note());
      }
    }
    node.set("samples", samples);
    node.set("standard_errors", errors);
    node.set("reached", reached);
    node.set("notes", notes);
    return node;
  }

  private ObjectNode effect(LimitDeviation d) {
    ObjectNode node = nodes.objectNode();
    node.put("effect", d.effect().id());
    put(node.putObject("parameters"), "coefficient", d.coefficient());
    put(node.putObject("standard_errors"), "coefficient", d.standardError());
    node.put("seen_in", d.seenIn());
    put(node, "share_at_limit_without", d.shareBefore());
    put(node, "share_at_limit_with", d.shareAfter());
    return node;
  }

  private ObjectNode envelope(Envelope e) {
    ObjectNode node = nodes.objectNode();
    node.put("seen_in", e.seenIn());
    node.put("shaped", e.shaped());
    put(node, "share_at_limit_without", e.shareWithout());
    put(node, "share_at_limit_with", e.shareWith());
    ArrayNode points = node.putArray("points");
    for (Envelope.Point p : e.points()) {
      ObjectNode one = points.addObject();
      put(one, "angle", p.angle());
      put(one, "value", p.value());
      put(one, "standard_error", p.standardError());
      put(one, "manoeuvres", p.manoeuvres());
    }
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
