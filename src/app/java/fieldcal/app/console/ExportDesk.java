package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.export.Export;
import fieldcal.app.export.ExportModel;
import fieldcal.app.export.ExportModel.ModelVerdict;
import fieldcal.app.export.Exporter;
import fieldcal.app.export.ProcessorHost;
import fieldcal.app.export.Target;
import fieldcal.app.export.Target.Key;
import fieldcal.app.export.Target.TargetFile;
import fieldcal.app.export.format.BaseFile;
import fieldcal.app.export.format.Editor.Change;
import fieldcal.app.history.History;
import fieldcal.app.history.HistoryEntry;
import fieldcal.app.history.HistoryEntry.Action;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.util.Base64;
import java.util.List;
import java.util.Optional;

/** Gives the model away in the form of other programs, and puts back what was there. The session's history keeps all of it. Thread-safe. */
final class ExportDesk {
  private static final String PROCESSOR = "ssl-vision-processor";
  private static final int LONGEST_NAME = 200;
  private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final DiagnosisDesk diagnosis;
  private final PublishDesk publish;
  private final History history;
  private final Clock clock;
  private final Runnable changed;

  ExportDesk(
      SessionDirectory directory,
      KickDesk kicks,
      DiagnosisDesk diagnosis,
      PublishDesk publish,
      History history,
      Clock clock,
      Runnable changed) {
    this.directory = directory;
    this.kicks = kicks;
    this.diagnosis = diagnosis;
    this.publish = publish;
    this.history = history;
    this.clock = clock;
    this.changed = changed;
  }

  /** The targets that take something of a calibration, with what each needs to know. */
  static ArrayNode targets() {
    ArrayNode targets = NODES.arrayNode();
    for (String name : Target.names()) {
      Target target = Target.of(name);
      // Limits of robots are measured by another command; here is the model of the ball.
      List<TargetFile> files =
          target.files().stream().filter(f -> !f.keys().stream().allMatch(Key::ofRobots)).toList();
      if (files.isEmpty()) {
        continue;
      }
      ObjectNode node = targets.addObject().put("name", name).put("title", target.title());
      node.put("file", files.get(0).file());
      files.stream()
          .filter(f -> f.entryMeans() != null)
          .findFirst()
          .ifPresent(f -> node.put("entry", f.entryMeans()));
      node.put("live", name.equals(PROCESSOR));
    }
    return targets;
  }

  /**
   * The file of a target.
   *
   * @return its bytes in base 64, the values before and after, and the notes
   */
  ObjectNode export(JsonNode body) throws IOException {
    try {
      ExportModel model = model(body);
      Exporter exporter = exporter(body, model);
      String base = Requests.text(body, "base", Requests.LARGEST_BODY);
      String name = Requests.text(body, "baseName", LONGEST_NAME);
      Export export =
          base.isEmpty()
              ? exporter.fresh()
              : exporter.into(BaseFile.of(name, Base64.getDecoder().decode(base)));
      ObjectNode answer = explained(export.changes(), export.notes(), model);
      answer.put("file", name.isEmpty() ? export.file().file() : name);
      answer.put("bytes", Base64.getEncoder().encodeToString(export.bytes()));
      String place = "browser: " + answer.get("file").asText();
      history.add(
          model.departure(Action.EXPORTED, export.target().name(), place, now()), Optional.empty());
      changed.run();
      return answer;
    } catch (InputException e) {
      throw ApiException.badRequest(e.getMessage());
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest("the base is not a file: " + e.getMessage());
    }
  }

  private static ObjectNode explained(
      List<Change> changes, List<String> sentences, ExportModel model) {
    ObjectNode answer = NODES.objectNode();
    ArrayNode words = answer.putArray("changes");
    changes.forEach(c -> words.add(ProcessorHost.words(c)));
    ArrayNode notes = answer.putArray("notes");
    sentences.forEach(notes::add);
    // What may be published needs no word here.
    answer.put(
        "verdict",
        model
            .provenance()
            .verdict()
            .filter(v -> !v.allows())
            .map(ModelVerdict::headline)
            .orElse(null));
    return answer;
  }

  private Exporter exporter(JsonNode body, ExportModel model) throws InputException {
    model
        .provenance()
        .verdict()
        .filter(v -> v.forbids() && !body.path("force").asBoolean())
        .ifPresent(
            v -> {
              throw ApiException.conflict(v.headline());
            });
    return new Exporter(
        target(body), model, given(body, "team").filter(t -> !t.isBlank()), given(body, "entry"));
  }

  private static Target target(JsonNode body) {
    String name = Requests.text(body, "target", LONGEST_NAME);
    if (!Target.names().contains(name)) {
      throw ApiException.badRequest("there is no target '" + name + "'");
    }
    return Target.of(name);
  }

  private static Optional<String> given(JsonNode body, String field) {
    String text = Requests.text(body, field, LONGEST_NAME);
    return text.isEmpty() ? Optional.empty() : Optional.of(text);
  }

  /** The current model with what the session knows beside it, or an earlier one from the history. */
  private ExportModel model(JsonNode body) throws IOException {
    if (Requests.number(body, "from").isPresent()) {
      HistoryEntry entry = entry(body, "from");
      return ExportModel.of(directory.resolve("export " + entry.id()), models(entry));
    }
    publish.write();
    ExportModel model = ExportModel.read(directory.resolve("calibration.json"));
    Path extended = directory.resolve(SessionDirectory.EXTENDED_MODEL);
    boolean holds = !diagnosis.outdated(kicks.view()) && model.extended().isEmpty();
    if (Files.exists(extended) && holds) {
      model = model.beside(ExportModel.read(extended));
    }
    Path limits = directory.resolve("limits.json");
    return Files.exists(limits) ? model.beside(ExportModel.read(limits)) : model;
  }

  private static BallModels models(HistoryEntry entry) {
    if (entry.text() == null) {
      throw ApiException.conflict("entry " + entry.id() + " of the history has no ball model");
    }
    return BallModels.fromFile(entry.text().getBytes(StandardCharsets.UTF_8));
  }

  private HistoryEntry entry(JsonNode body, String field) throws IOException {
    long id = Requests.number(body, field).orElse(-1);
    return history.entries().stream()
        .filter(e -> e.id() == id)
        .findFirst()
        .orElseThrow(() -> ApiException.notFound("the history has no entry " + id));
  }

  private double now() {
    return clock.millis() / 1000.0;
  }

  /** What would change in a running vision. */
  ObjectNode difference(JsonNode body) throws IOException {
    try {
      ExportModel model = model(body);
      Exporter exporter = exporter(body, model);
      return explained(host(body).difference(exporter.settings()), exporter.notes(), model);
    } catch (InputException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }

  /** Writes into a running vision. */
  void apply(JsonNode body) throws IOException {
    try {
      ExportModel model = model(body);
      HistoryEntry entry = model.departure(Action.APPLIED, PROCESSOR, url(body), now());
      host(body)
          .apply(
              exporter(body, model).settings(),
              changes -> {
                // The page has shown them and asked.
              },
              before -> {
                history.add(entry, Optional.of(before));
                changed.run();
              });
    } catch (InputException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }

  private static String url(JsonNode body) {
    return ProcessorHost.address(Requests.text(body, "url", LONGEST_NAME));
  }

  private static ProcessorHost host(JsonNode body) throws InputException {
    return new ProcessorHost(url(body));
  }

  /** Puts back what was in a running vision before an entry, or sends the model of an entry again. */
  void rollBack(JsonNode body) throws IOException {
    HistoryEntry entry = entry(body, "id");
    if (entry.action() == Action.PUBLISHED) {
      publish.again(entry, models(entry));
      return;
    }
    if (entry.action() != Action.APPLIED || entry.before() == null) {
      throw ApiException.conflict(
          "There is nothing to put back: export the model of this entry again instead.");
    }
    try {
      byte[] present = new ProcessorHost(entry.place()).restore(history.before(entry));
      history.add(entry.undone(now()), Optional.of(present));
      changed.run();
    } catch (InputException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }
}
