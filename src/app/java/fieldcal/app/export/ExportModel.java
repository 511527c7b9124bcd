package fieldcal.app.export;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.calibrate.InitialModels;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.calibrate.ResultFiles;
import fieldcal.app.diagnose.ExtendedModelFile;
import fieldcal.app.diagnose.FormerDiagnosis;
import fieldcal.app.history.HistoryEntry;
import fieldcal.app.history.HistoryEntry.Action;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectFields;
import fieldcal.effect.ExtendedModel;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.StreamSupport;

/**
 * A model that is to be exported, from any of the files that this program writes.
 *
 * @param file where it comes from
 * @param models the ball's parameters; may hold none
 * @param extended the ball with what the parameters leave out: the parameters themselves when nothing is known to be left out
 * @param beside whether {@code extended} stood beside the model, whose parameters were then calibrated without it
 * @param quantities what targets can take
 * @param kicks what it was made from, for which costs are stated; may be empty
 * @param limits of the robots; may be empty
 * @param provenance what the history remembers of it
 * @param remarks what must be known of it, whatever its target
 */
public record ExportModel(
    Path file,
    BallModels models,
    Optional<ExtendedModel> extended,
    boolean beside,
    Quantities quantities,
    List<ReferenceKick> kicks,
    List<RobotLimits> limits,
    Provenance provenance,
    List<String> remarks) {
  private static final Epoch UNIX = new Epoch(0);
  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** Copies the lists. {@inheritDoc} */
  public ExportModel {
    kicks = List.copyOf(kicks);
    limits = List.copyOf(limits);
    remarks = List.copyOf(remarks);
  }

  /**
   * Limits of a team with what one number per limit leaves out.
   *
   * @param team "yellow" or "blue"
   * @param values by the names of {@code limits.json}, SI; lacks what is not known
   * @param unreached names of limits at which the robots were never seen
   * @param effects coefficient of each effect by its id
   */
  public record RobotLimits(
      String team,
      Map<String, Double> values,
      List<String> unreached,
      Map<String, Double> effects) {
    /** Copies the collections. {@inheritDoc} */
    public RobotLimits {
      values = Collections.unmodifiableMap(new TreeMap<>(values));
      unreached = List.copyOf(unreached);
      effects = Collections.unmodifiableMap(new TreeMap<>(effects));
    }
  }

  /**
   * From what a model was made.
   *
   * @param from the recordings
   * @param kicks numbers of the kicks that were used
   * @param verdict the calibration's own verdict, or that of a diagnosis beside it; empty when there is none
   */
  public record Provenance(MadeFrom from, List<Integer> kicks, Optional<ModelVerdict> verdict) {
    /** Copies the list. {@inheritDoc} */
    public Provenance {
      kicks = List.copyOf(kicks);
    }

    /** Nothing known but the recordings. */
    static Provenance of(MadeFrom from) {
      return new Provenance(from, List.of(), Optional.empty());
    }
  }

  /**
   * The verdict in {@code calibration.json}.
   *
   * @param decision {@code publish}, {@code record_more}, {@code check_first} or {@code do_not_publish}
   * @param headline one sentence
   * @param because the reasons, a sentence each
   */
  public record ModelVerdict(String decision, String headline, List<String> because) {
    /** Copies the list. {@inheritDoc} */
    public ModelVerdict {
      because = List.copyOf(because);
    }

    /**
     * Whether somebody who used the model would predict worse with it.
     *
     * @return true when it must not be exported unless somebody insists
     */
    public boolean forbids() {
      return decision.equals("do_not_publish");
    }

    /**
     * Whether the model may be published without a word.
     *
     * @return true when the decision is "publish"
     */
    public boolean allows() {
      return decision.equals("publish");
    }

    static Optional<ModelVerdict> of(JsonNode node) {
      if (!node.path("decision").isTextual()) {
        return Optional.empty();
      }
      List<String> because = new ArrayList<>();
      node.path("because").forEach(reason -> because.add(reason.asText()));
      return Optional.of(
          new ModelVerdict(node.get("decision").asText(), node.path("headline").asText(), because));
    }
  }

  /**
   * Reads a model.
   *
   * @param file {@code calibration.json}, {@code extended_model.json}, {@code limits.json}, {@code twin.json} (its cameras), or {@code SSL_GeometryModels} in binary or text form
   * @return the model
   * @throws InputException when it is none of these, with file and place
   * @throws IOException when it cannot be read
   */
  public static ExportModel read(Path file) throws IOException {
    if (!isJson(file)) {
      return published(file, InitialModels.read(file));
    }
    JsonNode root = JsonFiles.read(file);
    String schema = root.path("schema").asText();
    return switch (schema) {
      case "fieldcal.calibration/1" -> calibration(file, root);
      case "fieldcal.extended_model/1" -> {
        ExtendedModel extended = ExtendedModelFile.read(file, UNIX);
        BallModels models = new BallModels(extended.flat(), extended.chip());
        MadeFrom from = MadeFrom.of(root);
        Optional<String> others =
            ResultFiles.CALIBRATION.ofOthers(file.toAbsolutePath().getParent(), from);
        yield ofBall(
            file, models, Optional.of(extended), Provenance.of(from), others.stream().toList());
      }
      case "fieldcal.limits/1" -> LimitsReader.read(file, root);
      case "fieldcal.twin/1" -> TwinReader.read(file);
      default ->
          throw new InputException(
              file
                  + ": schema is '"
                  + schema
                  + "'; give calibration.json, extended_model.json, limits.json, twin.json"
                  + " or geometry_models.pb");
    };
  }

  private static boolean isJson(Path file) throws IOException {
    return new String(JsonFiles.bytes(file), StandardCharsets.UTF_8).stripLeading().startsWith("{");
  }

  /**
   * A model of which nothing but its parameters is known.
   *
   * @param name stands for the file in messages
   * @param models the parameters
   * @return the model
   */
  public static ExportModel of(Path name, BallModels models) {
    return unknown(name, models);
  }

  /** Fields of a file that are not about the ball: a twin's cameras, or the limits of robots. */
  static ExportModel withoutBall(
      Path file, Quantities quantities, List<RobotLimits> limits, List<String> sources) {
    return new ExportModel(
        file,
        BallModels.NONE,
        Optional.empty(),
        false,
        quantities,
        List.of(),
        limits,
        Provenance.of(new MadeFrom(sources, List.of())),
        List.of());
  }

  /** The numbers for SSL-Vision. What is known of them stands in the calibration beside them, if it is theirs. */
  private static ExportModel published(Path file, BallModels models) throws IOException {
    Path beside = file.resolveSibling("calibration.json");
    // Published numbers under that name, even this very file, know nothing more.
    if (Files.isRegularFile(beside) && isJson(beside)) {
      ExportModel calibrated = read(beside);
      if (calibrated.models().equals(models)) {
        return calibrated;
      }
    }
    return unknown(file, models);
  }

  private static ExportModel unknown(Path file, BallModels models) {
    return ofBall(file, models, Optional.empty(), Provenance.of(MadeFrom.UNKNOWN), List.of());
  }

  private static ExportModel ofBall(
      Path file,
      BallModels models,
      Optional<ExtendedModel> extended,
      Provenance provenance,
      List<String> remarks) {
    Quantities quantities = Quantities.none();
    if (models.flat().isPresent()) {
      quantities = quantities.with(models.flat().get()).with("roll_slope", rollSlope(extended));
    }
    if (models.chip().isPresent()) {
      quantities = quantities.with(models.chip().get());
    }
    return new ExportModel(
        file, models, extended, false, quantities, List.of(), List.of(), provenance, remarks);
  }

  private static double rollSlope(Optional<ExtendedModel> extended) {
    return extended.stream()
        .flatMap(m -> m.effects().stream())
        .filter(e -> e.id().equals("speed_dependent_roll"))
        .mapToDouble(e -> e.value("slope"))
        .sum();
  }

  private static ExportModel calibration(Path file, JsonNode root) throws IOException {
    BallModels models = InitialModels.read(file);
    List<ReferenceKick> kicks = new ArrayList<>();
    List<Integer> used = new ArrayList<>();
    for (JsonNode kick : root.path("kicks")) {
      if (kick.path("selected").asBoolean()) {
        used.add(kick.path("id").asInt());
        ReferenceKick.of(kick).ifPresent(kicks::add);
      }
    }
    Provenance provenance = new Provenance(MadeFrom.of(root), used, verdict(file, root));
    ExportModel ball = ofBall(file, models, effects(file, root, models), provenance, List.of());
    return new ExportModel(
        file,
        models,
        ball.extended(),
        false,
        cameras(ball.quantities(), root.path("cameras")),
        kicks,
        List.of(),
        provenance,
        ball.remarks());
  }

  /** The verdict of the calibration, or that of a diagnosis of the same kicks that came after it. */
  private static Optional<ModelVerdict> verdict(Path file, JsonNode root) {
    return ModelVerdict.of(
        FormerDiagnosis.verdictOn(file.toAbsolutePath().getParent(), root)
            .orElse(root.path("verdict")));
  }

  /** What the parameters hold together with, when they were calibrated under an extended model. */
  private static Optional<ExtendedModel> effects(Path file, JsonNode root, BallModels models)
      throws InputException {
    JsonNode list = root.path("extended_model").path("effects");
    if (list.isEmpty()) {
      return Optional.empty();
    }
    List<Effect> effects = new ArrayList<>();
    for (JsonNode node : list) {
      try {
        effects.add(
            EffectFields.read(
                node.path("effect").asText(),
                MAPPER.convertValue(node.path("parameters"), Map.class)));
      } catch (IllegalArgumentException e) {
        throw new InputException(
            file + ", extended_model.effects[" + effects.size() + "]: " + e.getMessage());
      }
    }
    return Optional.of(
        new ExtendedModel(models.flat(), models.chip(), effects, sessionStart(root)));
  }

  /** Unix time from which the effects count, s; of an older file, which does not say it, that of the earliest kick. */
  private static double sessionStart(JsonNode root) {
    JsonNode start = root.path("extended_model").path("session_start_unix");
    return start.isNumber()
        ? start.asDouble()
        : StreamSupport.stream(root.path("kicks").spliterator(), false)
            .mapToDouble(kick -> kick.path("t").asDouble())
            .min()
            .orElse(0);
  }

  /** Root mean squares over the cameras that saw kicks. */
  private static Quantities cameras(Quantities quantities, JsonNode cameras) {
    double noise = 0;
    double offset = 0;
    int seen = 0;
    int placed = 0;
    for (JsonNode camera : cameras) {
      if (!camera.path("noise_assumed").asBoolean()) {
        double mm = camera.path("noise_mm").asDouble();
        noise += mm * mm;
        seen++;
      }
      JsonNode shift = camera.path("offset_mm");
      if (shift.size() == 2) {
        double x = shift.get(0).asDouble();
        double y = shift.get(1).asDouble();
        offset += x * x + y * y;
        placed++;
      }
    }
    return quantities
        .with("ball_noise", Math.sqrt(noise / seen) / 1000)
        .with("camera_offset", Math.sqrt(offset / placed) / 1000);
  }

  /**
   * What the history says of the model when it leaves the session.
   *
   * @param action what was done
   * @param target who got it
   * @param place the file, address or URL
   * @param unix when, Unix time in s
   * @return an entry without a number
   */
  public HistoryEntry departure(Action action, String target, String place, double unix) {
    Map<String, Double> values = new TreeMap<>();
    for (String name : Quantities.OF_MODEL) {
      quantities.of(name).ifPresent(value -> values.put(name, value));
    }
    limits.forEach(l -> l.values().forEach((name, v) -> values.put(l.team() + "." + name, v)));
    return new HistoryEntry(
        HistoryEntry.SCHEMA,
        0,
        unix,
        action,
        target,
        place,
        provenance.verdict().map(ModelVerdict::decision).orElse(null),
        provenance.from().sources(),
        provenance.kicks(),
        values,
        models.equals(BallModels.NONE) ? null : models.toText(),
        null,
        null);
  }

  /**
   * The same model with what is known beside it. An extended model of other recordings may be one of the same field, so it is not refused, but its remark says so.
   *
   * @param with limits of robots, or an extended model; its own quantities are kept where both have one
   * @return the changed copy
   */
  public ExportModel beside(ExportModel with) {
    List<String> all = new ArrayList<>(remarks);
    if (with.extended.isPresent()) {
      with.provenance
          .from()
          .unlike(provenance.from())
          .ifPresent(
              others ->
                  all.add(
                      with.file
                          + " is of "
                          + others
                          + " than "
                          + file
                          + ": what it says of this model is right only if the field was the"
                          + " same."));
    }
    return new ExportModel(
        file,
        models,
        with.extended.or(() -> extended),
        beside || with.extended.isPresent(),
        quantities.and(with.limits.isEmpty() ? Quantities.none() : with.quantities),
        kicks,
        limits.isEmpty() ? with.limits : limits,
        provenance,
        all);
  }

  /**
   * The same model with the limits of one team.
   *
   * @param team "yellow" or "blue"
   * @return with the limits under their bare names; unchanged when they are not known
   */
  public ExportModel ofTeam(String team) {
    Quantities more = quantities;
    for (RobotLimits one : limits) {
      if (one.team().equals(team)) {
        for (Map.Entry<String, Double> e : one.values().entrySet()) {
          more = more.with(e.getKey(), e.getValue());
        }
      }
    }
    return new ExportModel(
        file, models, extended, beside, more, kicks, limits, provenance, remarks);
  }
}
