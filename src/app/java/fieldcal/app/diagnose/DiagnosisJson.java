package fieldcal.app.diagnose;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.calibrate.VerdictJson;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.wording.CauseText;
import fieldcal.app.wording.CauseWords;
import fieldcal.app.wording.LearnedWords;
import fieldcal.app.wording.NextKicks;
import fieldcal.diagnosis.Candidate;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.StructureProfile;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.diagnosis.Unexplained;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectFields;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.SimpleFormula;
import fieldcal.fit.CameraView;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Builds {@code diagnosis.json}. SI units unless the name says otherwise; what is not known is null; never NaN. {@code prediction_error_mm} is the root mean square of all predictions, {@code typical_prediction_error_mm} what headline and tables say: the
 * same of a usual kick, see {@link Quality#typicalErrorMm}.
 */
final class DiagnosisJson {
  static final String SCHEMA = "fieldcal.diagnosis/1";

  /** Horizons that are always named, s: scripts shall not have to ask whether a recording was long enough. */
  private static final double[] HORIZONS = {0.5, 1.0, 2.0};

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final DiagnosisOutcome outcome;
  private final Diagnosis diagnosis;
  private final CauseWords words;
  private final JsonNodeFactory nodes = JsonNodeFactory.instance;

  DiagnosisJson(DiagnosisOutcome outcome) {
    this.outcome = outcome;
    diagnosis = outcome.diagnosis();
    words = new CauseWords(diagnosis, outcome.problem().observers());
  }

  ObjectNode build() {
    ObjectNode root = nodes.objectNode();
    root.put("schema", SCHEMA);
    root.put("verdict", diagnosis.verdict().id());
    root.set("model_verdict", VerdictJson.of(outcome.judged().verdict()));
    MadeFrom.of(outcome.calibration()).writeTo(root);
    root.put("seed", diagnosis.seed());
    root.set("cameras", cameras());
    ObjectNode base = quality(diagnosis.base());
    put(base, "noise_mm", diagnosis.base().noiseMm());
    root.set("base", base);
    ArrayNode causes = root.putArray("causes");
    diagnosis.causes().forEach(cause -> causes.add(cause(cause)));
    ArrayNode learned = root.putArray("learned");
    diagnosis.learned().forEach(finding -> learned.add(learned(finding)));
    root.set("extended", quality(diagnosis.extended()));
    root.set("unexplained", unexplained(diagnosis.unexplained()));
    ArrayNode candidates = root.putArray("candidates");
    diagnosis.candidates().forEach(candidate -> candidates.add(candidate(candidate)));
    ObjectNode structure = root.putObject("structure");
    structure.set("before", profiles(diagnosis.structureBefore()));
    structure.set("after", profiles(diagnosis.structureAfter()));
    root.set("kicks", kicks());
    ArrayNode trace = root.putArray("trace");
    for (SearchStep step : diagnosis.trace()) {
      ObjectNode one = trace.addObject().put("what", step.what());
      one.put("action", step.action().name().toLowerCase(Locale.ROOT));
      put(one, "expected_gain", step.expected());
      put(one, "gain", step.gained());
    }
    ArrayNode failures = root.putArray("failures");
    diagnosis.problems().forEach(failures::add);
    ArrayNode problems = root.putArray("problems");
    for (DataProblem p : outcome.calibration().data().problems()) {
      problems.addObject().put("where", p.where()).put("what", p.what()).put("count", p.count());
    }
    return root;
  }

  private ArrayNode cameras() {
    ArrayNode cameras = nodes.arrayNode();
    for (CameraView view : outcome.problem().cameras().all()) {
      ObjectNode node = cameras.addObject().put("id", view.id());
      boolean seen = outcome.calibration().sawKicks(view.id());
      put(node, "noise_mm", seen ? 1000 * view.noise() : Double.NaN);
      view.camera().ifPresent(c -> node.put("note", c.consistency()));
    }
    return cameras;
  }

  private ObjectNode quality(Quality quality) {
    ObjectNode node = nodes.objectNode();
    put(node, "rms_mm", quality.rmsMm());
    put(node, "holdout_rms_mm", quality.holdoutRmsMm());
    byHorizon(node.putObject("prediction_error_mm"), quality.predictionErrorMm());
    byHorizon(node.putObject("typical_prediction_error_mm"), quality.typicalErrorMm());
    return node;
  }

  private static void byHorizon(ObjectNode node, Map<Double, Double> known) {
    Map<Double, Double> errors = new TreeMap<>(known);
    for (double horizon : HORIZONS) {
      errors.putIfAbsent(horizon, Double.NaN);
    }
    errors.forEach((horizon, error) -> put(node, Double.toString(horizon), error));
  }

  private ObjectNode cause(Cause cause) {
    ObjectNode node = effect(cause.effect());
    if (cause.scatter() > 0) {
      ((ObjectNode) node.get("parameters")).put("scatter", cause.scatter());
    }
    ObjectNode errors = node.putObject("standard_errors");
    cause.standardErrors().forEach((name, error) -> put(errors, name, error));
    put(node, "evidence", cause.evidence());
    put(node, "holdout_gain_mm", cause.gain().mm());
    put(node, "holdout_gain_percent", cause.gain().percent());
    bounds(node, cause.gain());
    ArrayNode rivals = node.putArray("indistinguishable_from");
    cause.indistinguishableFrom().forEach(rivals::add);
    node.put(
        "discriminating_kicks",
        NextKicks.toTellApart(cause.effect().id(), cause.indistinguishableFrom()));
    node.put("sentence", cause.effect().sentence());
    return node;
  }

  private static void bounds(ObjectNode node, Gain gain) {
    ArrayNode bounds = node.putArray("holdout_gain_bounds_mm");
    add(bounds, gain.lowMm());
    add(bounds, gain.highMm());
  }

  private ObjectNode learned(LearnedFinding finding) {
    ObjectNode node = nodes.objectNode().put("acts_on", finding.actsOn());
    ArrayNode variables = node.putArray("depends_on");
    finding.dependsOn().forEach(variables::add);
    if (finding.camera().isPresent()) {
      node.put("camera", finding.camera().getAsInt());
    } else {
      node.putNull("camera");
    }
    Optional<LearnedCurve> main = strongest(finding.curves());
    node.put(
        "formula", main.map(c -> SimpleFormula.of(c).text()).orElse(finding.effect().sentence()));
    node.set("points", main.map(this::points).orElseGet(nodes::arrayNode));
    if (!Double.isNaN(finding.scatter())) {
      node.put("scatter", finding.scatter());
    }
    put(node, "holdout_gain_mm", finding.gain().mm());
    put(node, "holdout_gain_percent", finding.gain().percent());
    bounds(node, finding.gain());
    CauseText text = words.of(finding);
    node.put("name", text.name());
    node.put("sentence", text.what());
    ArrayNode curves = node.putArray("curves");
    for (LearnedCurve curve : finding.curves()) {
      ObjectNode one = curves.addObject().put("of", LearnedWords.quantity(curve));
      one.put("unit", curve.family().quantity().unit());
      one.put("formula", SimpleFormula.of(curve).text());
      one.set("points", points(curve));
    }
    node.set("term", effect(finding.effect()));
    return node;
  }

  /** Of the two components of a shift, the one that changes more. */
  private static Optional<LearnedCurve> strongest(List<LearnedCurve> curves) {
    return curves.stream()
        .max(Comparator.comparingDouble(c -> c.highest().value() - c.lowest().value()));
  }

  private ArrayNode points(LearnedCurve curve) {
    ArrayNode points = nodes.arrayNode();
    for (LearnedCurve.Point point : curve.points()) {
      ArrayNode one = points.addArray();
      add(one, point.x());
      if (curve.isTable()) {
        add(one, point.y());
      }
      add(one, point.value());
      add(one, point.error());
    }
    return points;
  }

  private ObjectNode effect(Effect effect) {
    ObjectNode node = nodes.objectNode().put("effect", effect.id());
    node.set("parameters", MAPPER.valueToTree(EffectFields.of(effect)));
    return node;
  }

  private ObjectNode unexplained(Unexplained unexplained) {
    ObjectNode node = nodes.objectNode().put("significant", unexplained.significant());
    ArrayNode variables = node.putArray("depends_on");
    unexplained.dependsOn().stream().map(StructureVariable::id).forEach(variables::add);
    put(node, "systematic_mm", unexplained.systematicMm());
    put(node, "deviation", unexplained.deviation());
    return node;
  }

  private ObjectNode candidate(Candidate candidate) {
    ObjectNode node = effect(candidate.effect());
    put(node, "score_gain", candidate.scoreGain());
    node.put("named", candidate.named());
    return node;
  }

  private ArrayNode profiles(List<StructureProfile> profiles) {
    ArrayNode list = nodes.arrayNode();
    for (StructureProfile profile : profiles) {
      ObjectNode node = list.addObject().put("variable", profile.variable().id());
      node.put("unit", profile.variable().unit());
      put(node, "share", profile.share());
      put(node, "deviation", profile.deviation());
      ArrayNode bins = node.putArray("bins");
      for (StructureProfile.Bin bin : profile.bins()) {
        ObjectNode one = bins.addObject();
        put(one, "at", bin.at());
        put(one, "along_mm", bin.alongMm());
        put(one, "across_mm", bin.acrossMm());
        put(one, "error_mm", bin.errorMm());
        one.put("count", bin.count());
      }
    }
    return list;
  }

  private ObjectNode kicks() {
    ObjectNode node = nodes.objectNode();
    node.put("found", outcome.calibration().data().kicks().size());
    node.put("used", diagnosis.kicks().size());
    ArrayNode each = node.putArray("each");
    for (KickResiduals kick : diagnosis.kicks()) {
      ObjectNode one = each.addObject().put("id", kick.kick().id()).put("kind", kick.kind().id());
      one.put("t", outcome.calibration().data().epoch().unixSeconds(kick.before().kickTime()));
      one.put("source", outcome.calibration().data().sources().get(kick.kick().id()));
      put(one, "rms_before_mm", kick.rmsBeforeMm());
      put(one, "rms_after_mm", kick.rmsAfterMm());
    }
    ArrayNode dropped = node.putArray("dropped");
    outcome.calibration().selection().dropped().keySet().forEach(dropped::add);
    ArrayNode leftOut = node.putArray("left_out");
    for (LeftOutKick kick : LeftOutKick.of(outcome)) {
      ObjectNode one = leftOut.addObject().put("id", kick.kick().id());
      one.put("t", outcome.calibration().data().epoch().unixSeconds(kick.kick().time()));
      one.put("source", kick.source()).put("reason", kick.reason());
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

  private static void add(ArrayNode array, double value) {
    if (Double.isFinite(value)) {
      array.add(value);
    } else {
      array.addNull();
    }
  }
}
