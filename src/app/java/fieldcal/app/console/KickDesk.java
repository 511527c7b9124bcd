package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.RecordingFolder;
import fieldcal.app.calibrate.SelectionFile;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.ReadableRecordings;
import fieldcal.app.recording.RecordingChoice;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.HandSelection;
import fieldcal.calibration.Sample;
import fieldcal.effect.ExtendedModel;
import fieldcal.fit.FitSettings;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ForkJoinPool;
import java.util.function.UnaryOperator;

/**
 * The calibration of a session and the decisions about its kicks. A decision changes selection and averages at once; what needs fits (offsets of the cameras, joint fit)
 * follows by itself, so that the numbers are those that {@code calibrate} gives for the same decisions. Thread-safe.
 */
final class KickDesk {
  private static final String READING = "Reading and calibrating";
  private static final String REFINING = "Refining the joint fit";

  /** Nobody waits for the joint fit while kicks are still being dropped, ms. */
  private static final long REFINE_AFTER_MS = 800;

  private static final int LONGEST_NAME = 255;

  private final SessionDirectory directory;

  /** Fits beside the operator's clicks: one core stays free for these. */
  private final ForkJoinPool beside =
      new ForkJoinPool(Math.max(1, Runtime.getRuntime().availableProcessors() - 1));

  private final Work work;
  private final Runnable changed;
  private final Optional<BallModels> initial;
  private final LogOpener opener;
  private final CalibrationSession session;
  private final SelectionHistory history = new SelectionHistory();

  private Optional<CalibrationOutcome> outcome = Optional.empty();
  private List<Path> logs = List.of();
  private RecordingChoice choice = new RecordingChoice(List.of());
  private Map<Path, String> leftOut = Map.of();
  private Map<Path, FileStamp> files = Map.of();
  private Optional<ExtendedModel> model = Optional.empty();
  private Optional<String> failure = Optional.empty();
  private Optional<String> unsaved = Optional.empty();
  private UnaryOperator<CalibrationOutcome> circumstances = UnaryOperator.identity();
  private boolean settled;
  private long version;
  private long fits;
  private long decisions;

  /**
   * What the desk holds at one moment.
   *
   * @param version grows with every change
   * @param fits grows when kicks are fitted again
   * @param decisions how many were made
   * @param outcome what is calibrated; empty before the first time
   * @param selection the decisions
   * @param undo what would be taken back
   * @param redo what would be done again
   * @param logs the recordings in it
   * @param choice all recordings of the directory, and which of them are used
   * @param leftOut recordings of the directory that cannot be read, and why
   * @param files all recordings of the directory as they were when they were read
   * @param failure why there is no calibration, or why the last one failed
   * @param unsaved why the decisions are not on the disk
   * @param settled whether the joint fit is that of the present decisions
   */
  record View(
      long version,
      long fits,
      long decisions,
      Optional<CalibrationOutcome> outcome,
      HandSelection selection,
      Optional<String> undo,
      Optional<String> redo,
      List<Path> logs,
      RecordingChoice choice,
      Map<Path, String> leftOut,
      Map<Path, FileStamp> files,
      Optional<String> failure,
      Optional<String> unsaved,
      boolean settled) {
    private View with(CalibrationOutcome known) {
      return new View(
          version,
          fits,
          decisions,
          Optional.of(known),
          selection,
          undo,
          redo,
          logs,
          choice,
          leftOut,
          files,
          failure,
          unsaved,
          settled);
    }
  }

  KickDesk(SessionDirectory directory, ConsoleSettings settings, Work work, Runnable changed) {
    this.directory = directory;
    this.work = work;
    this.changed = changed;
    initial = settings.initial();
    opener = settings.opener();
    session = new CalibrationSession(FitSettings.defaults().withSeed(settings.seed()), opener);
  }

  /**
   * Says what else is known of a calibration at the moment: what a diagnosis found, what vision publishes.
   *
   * @param how adds it
   */
  synchronized void circumstances(UnaryOperator<CalibrationOutcome> how) {
    circumstances = how;
  }

  /** Something of the circumstances changed, so the verdict may be another one. */
  void circumstancesChanged() {
    synchronized (this) {
      version++;
    }
    changed.run();
  }

  View view() {
    View plain = plainView();
    return plain.outcome().isEmpty()
        ? plain
        : plain.with(circumstances.apply(plain.outcome().get()));
  }

  private synchronized View plainView() {
    return new View(
        version,
        fits,
        decisions,
        outcome,
        history.now(),
        history.undoLabel(),
        history.redoLabel(),
        logs,
        choice,
        leftOut,
        files,
        failure,
        unsaved,
        settled);
  }

  /** The calibration as it is now. */
  CalibrationOutcome calibrated() {
    return view().outcome().orElseThrow(() -> ApiException.conflict("nothing is calibrated yet"));
  }

  /** Reads the recordings of the directory and calibrates them. */
  void read() {
    work.ask(READING, this::read);
  }

  /** Reads them on the console's own account: a recording came in. */
  void readAgain() {
    work.again(READING, this::read);
  }

  private void read(Work.Progress progress) {
    try {
      // Before they are read: what grows meanwhile has changed.
      Map<Path, FileStamp> present = directory.files();
      ReadableRecordings readable = ReadableRecordings.of(List.copyOf(present.keySet()), opener);
      RecordingChoice chosen = RecordingFolder.choice(readable, directory.path());
      List<Path> found = used(chosen);
      HandSelection selection = decided();
      if (found.isEmpty()) {
        install(present, chosen, readable.broken(), Optional.empty(), selection);
        return;
      }
      progress.reading(found);
      CollectedKicks data =
          new KickCollector(progress, opener)
              .collect(found)
              .withProblems(readable.problems())
              .withProblems(chosen.copies());
      CalibrationRequest request = request(found, selection);
      CalibrationOutcome calibrated = session.calibrate(data, request, progress);
      install(present, chosen, readable.broken(), Optional.of(calibrated), selection);
    } catch (CancellationException e) {
      fail("Reading was cancelled.");
      throw e;
    } catch (IOException | RuntimeException | Error e) {
      fail(Failures.words(e));
    }
  }

  private static List<Path> used(RecordingChoice chosen) {
    return chosen.entries().stream()
        .filter(RecordingChoice.Entry::used)
        .map(entry -> entry.facts().log())
        .toList();
  }

  /**
   * Uses a recording, leaves it out, or leaves that to the rule again; then calibrates what is used now.
   *
   * @throws ApiException when there is no such recording
   * @throws IOException when the decision cannot be saved; then it does not hold
   */
  void choose(JsonNode body) throws IOException {
    String name = Requests.text(body, "name", LONGEST_NAME);
    JsonNode use = body.path("use");
    if (!use.isBoolean() && !use.isNull()) {
      throw ApiException.badRequest("use must be true, false or null");
    }
    synchronized (this) {
      if (choice.entries().stream().noneMatch(entry -> entry.name().equals(name))) {
        throw ApiException.notFound("the session has no recording of that name");
      }
      Map<String, Boolean> decided = RecordingFolder.decisions(directory.path());
      if (use.isNull()) {
        decided.remove(name);
      } else {
        decided.put(name, use.asBoolean());
      }
      RecordingFolder.decide(directory.path(), decided);
    }
    read();
  }

  /** Those of this run, or else what a run before left. */
  private HandSelection decided() throws IOException {
    synchronized (this) {
      if (outcome.isPresent()) {
        return history.now();
      }
    }
    return SelectionFile.readOrFormer(null, directory.path());
  }

  Optional<BallModels> initial() {
    return initial;
  }

  private CalibrationRequest request(List<Path> recordings, HandSelection selection)
      throws IOException {
    return new CalibrationRequest(
        recordings, Optional.empty(), initial, model(), selection, directory.commands());
  }

  private synchronized Optional<ExtendedModel> model() {
    return model;
  }

  private void install(
      Map<Path, FileStamp> present,
      RecordingChoice chosen,
      Map<Path, String> broken,
      Optional<CalibrationOutcome> calibrated,
      HandSelection selection) {
    boolean refine;
    synchronized (this) {
      if (outcome.isEmpty()) {
        history.restart(selection);
      }
      // What was decided while the recordings were read holds.
      refine = !sameKicks(selection, history.now());
      logs = used(chosen);
      choice = chosen;
      leftOut = Map.copyOf(broken);
      files = Map.copyOf(present);
      outcome = calibrated.map(o -> o.reselected(history.now()));
      failure = Optional.empty();
      settled = !refine;
      version++;
      fits++;
    }
    changed.run();
    if (refine) {
      refine();
    }
  }

  private void fail(String words) {
    synchronized (this) {
      failure = Optional.of(words);
      version++;
    }
    changed.run();
  }

  /**
   * Carries out a decision, saves it, and brings everything that follows from it up to date.
   *
   * @throws ApiException when it cannot be done, or another window decided in the meantime
   */
  void decide(Decision decision) {
    boolean refine;
    synchronized (this) {
      CalibrationOutcome now = calibrated();
      decision.seen().ifPresent(this::requireSeen);
      HandSelection before = history.now();
      decision.apply(now, history);
      HandSelection after = history.now();
      refine = !sameKicks(before, after);
      outcome = Optional.of(now.reselected(after));
      settled &= !refine;
      version++;
      decisions++;
      save();
    }
    changed.run();
    if (refine) {
      refine();
    }
  }

  private void requireSeen(long seen) {
    if (seen != decisions) {
      throw ApiException.conflict(
          "A decision was made in another window in the meantime. Look again, then repeat it.");
    }
  }

  /** The 2σ rule judges single values; the joint fit takes every kick that nobody dropped or kept. */
  private static boolean sameKicks(HandSelection a, HandSelection b) {
    return a.dropped().keySet().equals(b.dropped().keySet()) && a.kept().equals(b.kept());
  }

  /** A disk that is full must not stop the operator: the decision holds, and the page says that it is not saved. */
  private void save() {
    CalibrationOutcome now = outcome.orElseThrow();
    try {
      SelectionFile.write(
          now.calibration(),
          now.selection(),
          now.data().epoch(),
          directory.resolve(SessionDirectory.SELECTION));
      unsaved = Optional.empty();
    } catch (IOException e) {
      unsaved = Optional.of("The decisions are not saved: " + Failures.words(e));
    }
  }

  /** Tries again to save the decisions. */
  void saveAgain() {
    synchronized (this) {
      calibrated();
      save();
      version++;
    }
    changed.run();
  }

  private void refine() {
    work.again(REFINING, this::refine);
  }

  private void refine(Work.Progress progress) {
    try {
      // Most decisions come in a row.
      progress.pause(REFINE_AFTER_MS);
      CalibrationOutcome before = calibrated();
      CalibrationRequest request = request(before.logs(), before.selection());
      CalibrationOutcome refined =
          beside.submit(() -> session.calibrate(before.data(), request, progress)).join();
      progress.check();
      synchronized (this) {
        // What was decided while it was refined holds; another refinement is on its way when
        // needed.
        settled = sameKicks(history.now(), refined.selection());
        outcome = Optional.of(refined.reselected(history.now()));
        failure = Optional.empty();
        version++;
        fits++;
      }
      changed.run();
    } catch (CancellationException e) {
      throw e;
    } catch (IOException | RuntimeException | Error e) {
      fail(Failures.words(e));
    }
  }

  /** Calibrates what was read, under other effects or none. */
  void under(Optional<ExtendedModel> effects) {
    synchronized (this) {
      if (model.equals(effects)) {
        return;
      }
      model = effects;
      if (outcome.isEmpty()) {
        return;
      }
      settled = false;
      version++;
    }
    changed.run();
    refine();
  }

  void close() {
    beside.shutdownNow();
  }

  /** How many values the 2σ rule leaves out now. */
  static long leftOut(CalibrationOutcome outcome) {
    return outcome.calibration().kicks().stream()
        .filter(CalibratedKick::trusted)
        .flatMap(kick -> kick.samples().stream())
        .filter(Sample::leftForItsValue)
        .count();
  }

  /** How many more another round would leave out; 0 when it runs until nothing leaves anyhow. */
  static long wouldLeave(CalibrationOutcome outcome) {
    OptionalInt rounds = outcome.selection().twoSigmaRounds();
    if (rounds.isEmpty()) {
      return 0;
    }
    HandSelection next =
        outcome.selection().withTwoSigmaRounds(OptionalInt.of(rounds.getAsInt() + 1));
    return leftOut(outcome.reselected(next)) - leftOut(outcome);
  }
}
