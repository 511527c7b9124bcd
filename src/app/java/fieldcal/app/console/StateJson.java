package fieldcal.app.console;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.ReportBuilder;
import fieldcal.app.history.History;
import fieldcal.app.recording.RecordingChoice;
import fieldcal.app.report.CalibrationReport;
import fieldcal.app.report.CalibrationReportWriter;
import fieldcal.app.wording.EffectName;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.HandSelection;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.LongSupplier;

/** What a page needs to know, as JSON. What is costly is kept as long as nothing changes. Thread-safe. */
final class StateJson {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final DiagnosisDesk diagnosis;
  private final VisionDesk vision;
  private final MatchDesk match;
  private final PlayDesk play;
  private final RecordDesk record;
  private final PublishDesk publish;
  private final NotesDesk notes;
  private final History history;
  private final Work work;
  private final long run;
  private final LongSupplier changes;
  private final Object workOrder = new Object();
  private long workNumber;
  private long calibrationVersion = -1;
  private final KickTexts texts = new KickTexts();
  private ObjectNode calibration;

  /**
   * Of these desks.
   *
   * @param run another number for each start of a console, so that a page sees that its server is a new one
   * @param changes how many there were
   */
  StateJson(
      SessionDirectory directory,
      KickDesk kicks,
      DiagnosisDesk diagnosis,
      VisionDesk vision,
      MatchDesk match,
      PlayDesk play,
      RecordDesk record,
      PublishDesk publish,
      NotesDesk notes,
      History history,
      Work work,
      long run,
      LongSupplier changes) {
    this.directory = directory;
    this.kicks = kicks;
    this.diagnosis = diagnosis;
    this.vision = vision;
    this.match = match;
    this.play = play;
    this.record = record;
    this.publish = publish;
    this.notes = notes;
    this.history = history;
    this.work = work;
    this.run = run;
    this.changes = changes;
  }

  /** Everything, but of the kicks only those that a page does not have as they are. */
  String state(Having having) throws IOException {
    ObjectNode root = NODES.objectNode();
    root.put("run", run);
    // Asked for first: what changes meanwhile is told with a higher one.
    root.put("version", changes.getAsLong());
    // So is what is being done: who sees it ended sees what came of it.
    ObjectNode working = workNode();
    KickDesk.View view = kicks.view();
    root.put("fits", view.fits());
    root.put("decisions", view.decisions());
    root.put("directory", directory.path().toString());
    root.set("recordings", names(view.logs()));
    root.set("choice", choice(view));
    root.set("record", record.state());
    root.set("sending", publish.state());
    files(root, view);
    ArrayNode leftOut = root.putArray("leftOut");
    view.leftOut().values().stream().sorted().forEach(leftOut::add);
    root.put("settled", view.settled());
    root.put("failure", view.failure().orElse(null));
    ArrayNode unsaved = root.putArray("unsaved");
    view.unsaved().ifPresent(unsaved::add);
    notes.unsaved().ifPresent(unsaved::add);
    root.set("work", working);
    if (view.outcome().isPresent()) {
      root.setAll(calibration(view, having.run() == run ? having.calibration() : -1));
    }
    root.set("diagnosis", diagnosis(view));
    root.set("vision", vision.state(view.outcome().flatMap(o -> o.data().geometry())));
    root.set("match", match.state());
    ArrayNode watchable = root.putArray("watchable");
    directory.watchable().keySet().forEach(watchable::add);
    root.set("play", play.state());
    root.set("published", MAPPER.valueToTree(notes.now().published()));
    root.set("targets", ExportDesk.targets());
    root.set("history", history());
    return MAPPER.writeValueAsString(root);
  }

  /** What left the session, the latest first. */
  private ArrayNode history() throws IOException {
    ArrayNode all = NODES.arrayNode();
    history.entries().forEach(entry -> all.insert(0, MAPPER.valueToTree(entry)));
    return all;
  }

  /** The progress alone. */
  String work() throws IOException {
    return MAPPER.writeValueAsString(workNode());
  }

  /** Numbered in the order of what it shows: an answer and an event may overtake each other. */
  private ObjectNode workNode() {
    synchronized (workOrder) {
      ObjectNode node = NODES.objectNode();
      node.put("run", run).put("number", ++workNumber);
      work.status()
          .ifPresent(
              s ->
                  node.put("title", s.title())
                      .put("text", s.text())
                      .put("done", s.done())
                      .put("total", s.total())
                      .put("asked", s.asked()));
      return node;
    }
  }

  /** Recordings that came into the directory, or were written again, since it was read. */
  private void files(ObjectNode root, KickDesk.View view) {
    ArrayNode added = root.putArray("unread");
    ArrayNode changed = root.putArray("changed");
    try {
      directory
          .files()
          .forEach(
              (log, now) -> {
                FileStamp read = view.files().get(log);
                if (!now.equals(read)) {
                  (read == null ? added : changed).add(log.getFileName().toString());
                }
              });
    } catch (IOException e) {
      // The directory went away: the page keeps what was read.
    }
  }

  /** Every recording that can be read, whether it is used, and why not. */
  private static ArrayNode choice(KickDesk.View view) {
    ArrayNode all = NODES.arrayNode();
    for (RecordingChoice.Entry entry : view.choice().entries()) {
      ObjectNode one = all.addObject();
      one.put("name", entry.name()).put("used", entry.used());
      one.put("byHand", entry.byHand()).put("why", entry.words());
      one.put("start", entry.facts().startUnixNanos() / 1e9);
      long kicks =
          view.outcome().stream()
              .flatMap(o -> o.data().sources().values().stream())
              .filter(source -> source.equals(entry.facts().log().toString()))
              .count();
      one.put("kicks", entry.used() ? kicks : null);
    }
    return all;
  }

  private static ArrayNode names(List<Path> logs) {
    ArrayNode names = NODES.arrayNode();
    logs.forEach(log -> names.add(log.getFileName().toString()));
    return names;
  }

  private synchronized ObjectNode calibration(KickDesk.View view, long known) throws IOException {
    // Somebody who asked a moment before may come later.
    if (calibrationVersion < view.version()) {
      CalibrationOutcome outcome = view.outcome().orElseThrow();
      ObjectNode node = NODES.objectNode();
      CalibrationReport report = new ReportBuilder(outcome).overview();
      texts.update(report.kicks(), view.version());
      node.set("calibration", MAPPER.readTree(CalibrationReportWriter.jsonWithoutKicks(report)));
      node.set("selection", selection(view, outcome));
      node.set("model", model(outcome));
      calibration = node;
      calibrationVersion = view.version();
    }
    ObjectNode told = calibration.deepCopy();
    ObjectNode of = (ObjectNode) told.path("calibration");
    of.put("version", calibrationVersion);
    of.put("since", texts.knows(known) ? known : null);
    ArrayNode changed = ((ObjectNode) of.path("report")).putArray("kicks");
    texts.after(known).forEach(json -> changed.addRawValue(new RawValue(json)));
    return told;
  }

  private static ObjectNode selection(KickDesk.View view, CalibrationOutcome outcome) {
    ObjectNode node = NODES.objectNode();
    HandSelection selection = view.selection();
    OptionalInt rounds = selection.twoSigmaRounds();
    node.put("rounds", rounds.isPresent() ? rounds.getAsInt() : null);
    node.put("leftOut", KickDesk.leftOut(outcome));
    node.put("wouldLeave", KickDesk.wouldLeave(outcome));
    node.put("undo", view.undo().orElse(null));
    node.put("redo", view.redo().orElse(null));
    ObjectNode byHand = node.putObject("byHand");
    for (CalibratedKick kick : outcome.calibration().kicks()) {
      String key = outcome.key(kick.fit().kick());
      String id = Integer.toString(kick.fit().kick().id());
      if (selection.droppedBecause(key).isPresent()) {
        byHand.put(id, "drop");
      } else if (selection.isKept(key)) {
        byHand.put(id, "keep");
      }
    }
    return node;
  }

  private ObjectNode model(CalibrationOutcome outcome) {
    BallModels models = outcome.models();
    ObjectNode node = Snippets.of(models);
    node.put("flat", models.flat().isPresent());
    node.put("chip", models.chip().isPresent());
    node.put("geometry", outcome.data().geometry().isPresent());
    node.put("compared", kicks.initial().isPresent() ? "file" : "recordings");
    ArrayNode effects = node.putArray("effects");
    outcome
        .extended()
        .ifPresent(e -> e.model().effects().forEach(effect -> effects.add(EffectName.of(effect))));
    return node;
  }

  private ObjectNode diagnosis(KickDesk.View view) {
    ObjectNode node = NODES.objectNode();
    SessionNotes now = notes.now();
    node.set("note", MAPPER.valueToTree(now.diagnosis()));
    node.set(
        "next",
        MAPPER.valueToTree(
            now.diagnosis() == null ? List.of() : KicksToRecord.of(now.diagnosis())));
    node.put("acceptance", Requests.name(now.acceptance()));
    node.put("outdated", view.outcome().isPresent() && diagnosis.outdated(view));
    node.put("report", reportStamp());
    node.put("failure", diagnosis.failure().orElse(null));
    return node;
  }

  /** When the diagnosis report was written; null when there is none. */
  private Long reportStamp() {
    try {
      return Files.getLastModifiedTime(directory.served("diagnosis.html")).toMillis();
    } catch (IOException | ApiException e) {
      return null;
    }
  }

  /** All of one kick. */
  String kick(int id) throws IOException {
    CalibrationReport.Kick kick =
        new ReportBuilder(kicks.calibrated())
            .kick(id)
            .orElseThrow(() -> ApiException.notFound("there is no kick " + id));
    return CalibrationReportWriter.json(kick);
  }
}
