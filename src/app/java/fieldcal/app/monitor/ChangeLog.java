package fieldcal.app.monitor;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.files.NamedOutput;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.CameraHealth;
import fieldcal.live.KickCounts;
import fieldcal.live.LimitWarning;
import fieldcal.live.LiveKick;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveSnapshot;
import fieldcal.live.LiveWarning;
import fieldcal.live.ParameterEstimate;
import fieldcal.movement.Envelope;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.PlayPhase;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;

/**
 * A file with one line of JSON per change, written as it happens: {@code event} and {@code t} (Unix time, s) in each, SI units, null for what is not known. Events: {@code start}, {@code referee}, {@code referee_lost}, {@code kick},
 * {@code estimate}, {@code warning}, {@code warning_cleared}, {@code limits}, {@code limit_warning}, {@code limit_warning_cleared}, {@code vision_lost}, {@code
 * vision_back}, {@code summary}.
 */
public final class ChangeLog implements LiveListener, AutoCloseable {
  private static final String SCHEMA = "fieldcal.monitor/1";

  private final ObjectMapper mapper = new ObjectMapper();
  private final Writer out;
  private double time = Double.NaN;
  private boolean seen = true;

  /** Estimates are told right after the kick that changed them, by the same thread. */
  private double kickTime = Double.NaN;

  private IOException failure;

  /**
   * Begins a file.
   *
   * @param file an existing one is replaced
   * @param title where frames come from
   * @throws IOException when it cannot be written
   */
  public ChangeLog(Path file, String title) throws IOException {
    out =
        new BufferedWriter(new OutputStreamWriter(NamedOutput.open(file), StandardCharsets.UTF_8));
    write(event("start", Double.NaN).put("schema", SCHEMA).put("source", title));
  }

  private static ObjectNode event(String name, double t) {
    ObjectNode node = JsonNodeFactory.instance.objectNode().put("event", name);
    return number(node, "t", t);
  }

  private static ObjectNode number(ObjectNode node, String name, double value) {
    return Double.isFinite(value) ? node.put(name, value) : node.putNull(name);
  }

  private synchronized void write(ObjectNode line) {
    try {
      // In one piece, so that a reader never sees half a line.
      out.write(mapper.writeValueAsString(line) + "\n");
      out.flush();
    } catch (IOException e) {
      failure = failure == null ? e : failure;
    }
  }

  /**
   * The newest frame's time, for what has no time of its own.
   *
   * @param now Unix time, s
   */
  synchronized void time(double now) {
    time = now;
  }

  private synchronized double time() {
    return time;
  }

  /** The referee changed stage or command. */
  void referee(RefereeState state, double t, PlayPhase phase) {
    write(
        event("referee", t)
            .put("stage", state.stage().name())
            .put("command", state.command().name())
            .put("counts", phase.counts()));
  }

  /** The referee fell silent: everything counts. */
  void refereeLost() {
    write(event("referee_lost", time()));
  }

  /** Whether frames come; only a change is written. */
  void vision(boolean sees) {
    if (sees != seen) {
      seen = sees;
      write(event(sees ? "vision_back" : "vision_lost", time()));
    }
  }

  @Override
  public void kick(LiveKick kick) {
    kickTime = kick.time();
    ObjectNode node = event("kick", kick.time()).put("id", kick.id());
    node.put("kind", kick.kind().map(k -> k.id()).orElse(null));
    node.put("team", kick.robot().map(r -> r.team().label()).orElse(null));
    node.put("robot", kick.robot().map(r -> r.number()).orElse(null));
    node.putArray("position").add(kick.x()).add(kick.y());
    node.putArray("velocity").add(kick.vx()).add(kick.vy());
    node.put("end", kick.end().id());
    node.put("possibly_spinning", kick.possiblySpinning());
    number(node, "rms_mm", kick.rmsMm());
    ObjectNode samples = node.putObject("samples");
    kick.samples()
        .forEach(
            (parameter, sample) -> {
              ObjectNode one = samples.putObject(parameter.id());
              one.put("value", sample.value()).put("standard_error", sample.standardError());
              if (parameter.speedSensitive()) {
                number(one, "speed", sample.speed());
              }
            });
    node.put("unused_because", kick.unused().orElse(null));
    write(node);
  }

  @Override
  public void estimate(ParameterEstimate e) {
    ObjectNode node = event("estimate", kickTime).put("parameter", e.parameter().id());
    write(put(node, e));
  }

  private static ObjectNode put(ObjectNode node, ParameterEstimate e) {
    number(node, "median", e.median());
    node.put("samples", e.samples()).put("enough", e.enough());
    node.put("maybe_spun", e.maybeSpun());
    node.put("published", e.published().orElse(null));
    number(node, "deviation", e.deviation());
    return node.put("warning", e.warning());
  }

  @Override
  public void warningRaised(LiveWarning warning) {
    warning("warning", warning);
  }

  @Override
  public void warningCleared(LiveWarning warning) {
    warning("warning_cleared", warning);
  }

  private void warning(String name, LiveWarning w) {
    ObjectNode node = event(name, w.time()).put("parameter", w.parameter().id());
    number(node, "median", w.median());
    number(node, "published", w.published());
    number(node, "deviation", w.deviation());
    write(node.put("samples", w.samples()).put("text", w.text()).put("advice", w.advice()));
  }

  @Override
  public void limitWarningRaised(LimitWarning warning) {
    limitWarning("limit_warning", warning);
  }

  @Override
  public void limitWarningCleared(LimitWarning warning) {
    limitWarning("limit_warning_cleared", warning);
  }

  private void limitWarning(String name, LimitWarning w) {
    ObjectNode node = event(name, w.time()).put("team", w.team().label());
    node.put("limit", w.limit().label() + "_max");
    number(node, "value", w.estimate().value());
    number(node, "configured", w.configured());
    number(node, "deviation", w.deviation());
    write(node.put("text", w.text()).put("advice", w.advice()));
  }

  @Override
  public void limits(Team team, TeamLimits limits) {
    ObjectNode node = event("limits", time()).put("team", team.label());
    write(put(node, limits));
  }

  private static ObjectNode put(ObjectNode node, TeamLimits limits) {
    put(node, "velocity_max", limits.velocity(), limits.leagueVelocity());
    put(node, "acceleration_max", limits.acceleration(), limits.leagueAcceleration());
    put(node, "braking_max", limits.braking(), limits.leagueBraking());
    ObjectNode effects = node.putObject("effects");
    limits
        .deviations()
        .forEach(
            d ->
                effects.put(
                    d.effect().id() + "_in_" + d.seenIn().toLowerCase(Locale.ROOT),
                    d.coefficient()));
    put(node, "angular_velocity_max", limits.turning().velocity());
    put(node, "angular_acceleration_max", limits.turning().acceleration());
    put(node, "angular_braking_max", limits.turning().braking());
    ArrayNode envelopes = node.putArray("envelopes");
    for (Envelope e : limits.envelopes()) {
      ObjectNode one = envelopes.addObject().put("seen_in", e.seenIn()).put("shaped", e.shaped());
      ArrayNode points = one.putArray("points");
      for (Envelope.Point p : e.points()) {
        points.addArray().add(p.angle()).add(p.value()).add(p.standardError());
      }
    }
    ArrayNode robots = node.putArray("robots");
    for (RobotDifference r : limits.robots()) {
      ObjectNode one = robots.addObject().put("robot", r.robot()).put("limit", r.quantity());
      number(one, "value", r.value());
      number(one, "standard_error", r.standardError());
      number(one, "of_others", r.ofOthers());
    }
    return node;
  }

  private static void put(ObjectNode node, String name, LimitEstimate own, LimitEstimate league) {
    number(put(node, name, own), "league", league.value());
  }

  private static ObjectNode put(ObjectNode node, String name, LimitEstimate own) {
    ObjectNode one = node.putObject(name);
    number(one, "value", own.value());
    number(one, "standard_error", own.standardError());
    return one.put("samples", own.samples()).put("reached", own.reached());
  }

  /** The last line. */
  void summary(LiveSnapshot s) {
    ObjectNode node = event("summary", s.time());
    KickCounts c = s.ball().counts();
    node.putObject("kicks")
        .put("found", c.found())
        .put("used", c.used())
        .put("unused", c.unused())
        .put("outside_play", c.outsidePlay())
        .put("dropped", c.dropped())
        .put("possibly_spinning", c.possiblySpinning());
    ObjectNode parameters = node.putObject("parameters");
    s.ball().parameters().forEach(e -> put(parameters.putObject(e.parameter().id()), e));
    ObjectNode teams = node.putObject("teams");
    s.movement().limits().forEach((team, limits) -> put(teams.putObject(team.label()), limits));
    for (CameraHealth camera : s.cameras()) {
      ObjectNode one = node.withArray("/cameras").addObject().put("id", camera.id());
      one.put("frames", camera.frames()).put("gaps", camera.gaps());
      number(one, "rate_hz", camera.rateHz());
      number(one, "noise_mm", camera.noiseMm());
      number(one, "offset_x_mm", camera.offsetXMm());
      number(one, "offset_y_mm", camera.offsetYMm());
      number(one, "apart_mm", camera.apartMm());
      camera.apartFrom().ifPresent(other -> one.put("apart_from", other));
    }
    ArrayNode faults = node.putArray("camera_faults");
    s.cameraFaults()
        .forEach(f -> faults.addObject().put("camera", f.camera()).put("reason", f.reason()));
    write(node.put("frames", s.frames()).put("stray_frames", s.strayFrames()));
  }

  /**
   * Ends the file.
   *
   * @throws IOException when something could not be written
   */
  @Override
  public synchronized void close() throws IOException {
    try {
      out.close();
    } catch (IOException e) {
      failure = failure == null ? e : failure;
    }
    if (failure != null) {
      throw failure;
    }
  }
}
