package fieldcal.app.calibrate;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.recording.CameraStream;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.wording.ParameterWords;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.ExtendedCalibration;
import fieldcal.calibration.Sample;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectFields;
import fieldcal.fit.CameraView;
import fieldcal.fit.Estimate;
import fieldcal.fit.JointFit;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.vision.RobotId;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Builds {@code calibration.json}. SI units; of what is not known the contract's fields are null, others left out; never NaN. */
final class CalibrationJson {
  static final String SCHEMA = "fieldcal.calibration/1";

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final CalibrationOutcome outcome;
  private final JsonNodeFactory nodes = JsonNodeFactory.instance;

  CalibrationJson(CalibrationOutcome outcome) {
    this.outcome = outcome;
  }

  ObjectNode build() {
    Calibration calibration = outcome.calibration();
    ObjectNode root = nodes.objectNode();
    root.put("schema", SCHEMA);
    MadeFrom.of(outcome).writeTo(root);
    ArrayNode dropped = root.putArray("dropped_by_hand");
    outcome.selection().dropped().keySet().stream().sorted().forEach(dropped::add);
    outcome.forced().ifPresent(kind -> root.put("forced_kind", kind.id()));
    root.put("seed", calibration.seed());
    root.set("verdict", VerdictJson.of(outcome.verdict()));
    ArrayNode cameras = root.putArray("cameras");
    calibration.cameras().all().forEach(view -> cameras.add(camera(view)));
    ArrayNode kicks = root.putArray("kicks");
    calibration.kicks().forEach(kick -> kicks.add(kick(kick)));
    root.set("flat", averages(KickKind.FLAT, calibration.flat()));
    root.set("chip", averages(KickKind.CHIP, calibration.chip()));
    root.set("joint", joint(calibration.joint()));
    root.set("published", published());
    outcome.extended().ifPresent(e -> root.set("extended_model", extended(e)));
    ArrayNode warnings = root.putArray("warnings");
    new CalibrationWarnings(outcome).list().forEach(warnings::add);
    ArrayNode problems = root.putArray("problems");
    for (DataProblem p : outcome.data().problems()) {
      problems.addObject().put("where", p.where()).put("what", p.what()).put("count", p.count());
    }
    return root;
  }

  private ObjectNode camera(CameraView view) {
    ObjectNode node = nodes.objectNode();
    node.put("id", view.id());
    put(node, "noise_mm", 1000 * view.noise());
    if (!outcome.sawKicks(view.id())) {
      // The contract has a number here; scripts that do arithmetic with it shall not break on a
      // camera that saw nothing.
      node.put("noise_assumed", true);
    }
    CameraStream stream = outcome.data().streams().get(view.id());
    put(node, "rate_hz", stream == null ? Double.NaN : stream.rateHz());
    JointFit.Offset offset =
        outcome.calibration().joint().map(j -> j.offsets().get(view.id())).orElse(null);
    if (offset != null && Double.isFinite(offset.errorX())) {
      node.set("offset_mm", pair(1000 * offset.x(), 1000 * offset.y()));
      node.set("offset_standard_error_mm", pair(1000 * offset.errorX(), 1000 * offset.errorY()));
    }
    view.camera().ifPresent(c -> node.put("note", c.consistency()));
    return node;
  }

  private ArrayNode pair(double... values) {
    ArrayNode array = nodes.arrayNode();
    for (double v : values) {
      array.add(v);
    }
    return array;
  }

  private ObjectNode kick(CalibratedKick calibrated) {
    KickFit fit = calibrated.fit();
    Kick kick = fit.kick();
    boolean fitted = fit.failure().isEmpty();
    ObjectNode node = nodes.objectNode();
    node.put("id", kick.id());
    node.put("kind", fit.kind().id());
    node.put("t", outcome.kickTime(fit));
    node.put("team", kick.robot().map(r -> r.team().name().toLowerCase(Locale.ROOT)).orElse(null));
    node.put("robot", kick.robot().map(RobotId::number).orElse(null));
    node.put("end", kick.end().id());
    node.put("source", outcome.data().sources().get(kick.id()));
    node.put("observations", kick.observations().size());
    if (fitted) {
      fitted(node, fit);
    } else {
      node.putNull("rms_mm");
      node.set("kick_position", pair(kick.x(), kick.y()));
      node.set("kick_velocity", pair(kick.vx(), kick.vy(), 0));
      node.set("parameters", nodes.objectNode());
      node.set("standard_errors", nodes.objectNode());
    }
    node.put("selected", calibrated.selected());
    node.put(
        "rejected_because", calibrated.rejected().map(ParameterWords::spelledOut).orElse(null));
    ObjectNode dropped = nodes.objectNode();
    for (Sample s : calibrated.samples()) {
      s.dropped()
          .map(ParameterWords::spelledOut)
          .ifPresent(reason -> dropped.put(ParameterWords.inFiles(s.parameter()), reason));
    }
    node.set("dropped_parameters", dropped);
    outcome.command(kick).ifPresent(c -> node.set("commanded", commanded(c)));
    return node;
  }

  private ObjectNode commanded(CommandFile.Command c) {
    ObjectNode node = nodes.objectNode();
    node.put("t", c.unixTime());
    node.put("kind", c.kind());
    node.put("speed", c.speed());
    node.put("direction", c.direction());
    node.put("elevation", c.elevation());
    return node;
  }

  private void fitted(ObjectNode node, KickFit fit) {
    node.put("rejected_observations", fit.statistics().observations() - fit.statistics().used());
    node.put("unexplained_observations", fit.statistics().lackOfFit());
    put(node, "rms_mm", fit.rmsMm());
    node.set("kick_position", pair(fit.estimate("x").value(), fit.estimate("y").value()));
    double vz = fit.kind() == KickKind.CHIP ? fit.estimate("vz").value() : 0;
    node.set("kick_velocity", pair(fit.estimate("vx").value(), fit.estimate("vy").value(), vz));
    put(node, "t_standard_error", fit.estimate("t0").standardError());
    if (fit.kind() == KickKind.CHIP) {
      node.put("flights", fit.statistics().flights());
    }
    ObjectNode parameters = node.putObject("parameters");
    ObjectNode errors = node.putObject("standard_errors");
    ObjectNode undetermined = nodes.objectNode();
    for (Estimate e : fit.modelEstimates()) {
      String name = ParameterWords.inFiles(e.name());
      if (e.usable()) {
        parameters.put(name, e.value());
        errors.put(name, e.standardError());
      } else if (e.parameter().estimated()) {
        undetermined.put(name, e.undetermined().orElse("the estimate reached its bound"));
      }
    }
    node.set("undetermined", undetermined);
  }

  /** Nothing for a kind without kicks; a parameter that no kick determines has a mean of null. */
  private ObjectNode averages(KickKind kind, Map<String, Average> averages) {
    ObjectNode node = nodes.objectNode();
    if (outcome.calibration().kicks(kind).isEmpty()) {
      return node;
    }
    averages.forEach(
        (name, a) -> {
          ObjectNode one = node.putObject(ParameterWords.inFiles(name));
          one.put("mean", a.n() > 0 ? a.mean() : null);
          one.put("standard_error", a.n() > 0 ? a.standardError() : null);
          one.put("n", a.n());
          one.put("scatter", a.n() > 0 ? a.scatter() : null);
        });
    return node;
  }

  private ObjectNode joint(Optional<JointFit> joint) {
    ObjectNode node = nodes.objectNode();
    node.set("flat", joint.map(j -> estimates(KickKind.FLAT, j.flat())).orElse(nodes.objectNode()));
    node.set("chip", joint.map(j -> estimates(KickKind.CHIP, j.chip())).orElse(nodes.objectNode()));
    joint.ifPresent(
        j -> {
          put(node, "rms_mm", j.rmsMm());
          put(node, "rms_flat_mm", j.rmsFlatMm());
          put(node, "rms_chip_mm", j.rmsChipMm());
          node.put("observations", j.used());
          node.put("rejected_observations", j.rejected());
          put(node, "reduced_chi_square", j.reducedChiSquare());
          put(node, "one_model_rms_mm", j.oneModel().rmsMm());
          put(node, "one_model_reduced_chi_square", j.oneModel().reducedChiSquare());
          node.put("converged", j.converged());
        });
    return node;
  }

  private ObjectNode estimates(KickKind kind, List<Estimate> estimates) {
    ObjectNode node = nodes.objectNode();
    for (Estimate e : estimates) {
      ObjectNode one = node.putObject(ParameterWords.inFiles(e.name()));
      if (!e.parameter().estimated()) {
        one.put("mean", e.value()).put("fixed", true);
      } else if (outcome.calibration().joint(kind, e.name()).isEmpty()) {
        one.put("undetermined", "it needs two kicks");
      } else if (e.usable()) {
        one.put("mean", e.value()).put("standard_error", e.standardError());
      } else {
        one.put("undetermined", e.undetermined().orElse("the estimate reached its bound"));
      }
    }
    return node;
  }

  /** With what the parameters hold together, and what of it the league's message has no field for. */
  private ObjectNode extended(ExtendedCalibration extended) {
    ObjectNode node = nodes.objectNode();
    double start = outcome.data().epoch().unixSeconds(outcome.data().sessionStart());
    node.put("session_start_unix", start);
    ArrayNode effects = node.putArray("effects");
    ArrayNode absent = nodes.arrayNode();
    for (Effect effect : extended.model().effects()) {
      ObjectNode one = effects.addObject().put("effect", effect.id());
      one.set("parameters", MAPPER.valueToTree(EffectFields.of(effect)));
      absent.add(effect.id());
    }
    node.set("not_in_message", absent);
    node.put("rounds", extended.rounds());
    put(node, "last_move_mm", extended.lastMoveMm());
    node.put("settled", extended.settled());
    return node;
  }

  private ObjectNode published() {
    ObjectNode node = nodes.objectNode();
    outcome
        .initial()
        .flat()
        .ifPresent(
            m ->
                m.parameters().forEach(p -> node.put(ParameterWords.inFiles(p.name()), p.value())));
    outcome
        .initial()
        .chip()
        .ifPresent(
            m ->
                m.parameters()
                    .subList(0, 3)
                    .forEach(p -> node.put(ParameterWords.inFiles(p.name()), p.value())));
    return node;
  }

  private static void put(ObjectNode node, String name, double value) {
    if (Double.isFinite(value)) {
      node.put(name, value);
    }
  }
}
