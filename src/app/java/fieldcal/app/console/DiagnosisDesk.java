package fieldcal.app.console;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.console.SessionNotes.Acceptance;
import fieldcal.app.console.SessionNotes.CauseNote;
import fieldcal.app.console.SessionNotes.DiagnosisNote;
import fieldcal.app.diagnose.CalibrationBeside;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.app.diagnose.ExtendedModelFile;
import fieldcal.app.diagnose.FormerDiagnosis;
import fieldcal.app.wording.CauseText;
import fieldcal.app.wording.CauseWords;
import fieldcal.app.wording.NextKicks;
import fieldcal.app.wording.VerdictText;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.Verdict;
import fieldcal.effect.ExtendedModel;
import fieldcal.fit.FitSettings;
import fieldcal.verdict.Finding;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/** The diagnosis of a session, and what the operator makes of it. Thread-safe. */
final class DiagnosisDesk {
  private static final String DIAGNOSING = "Diagnosing";

  /** The clock of {@code extended_model.json}. */
  private static final Epoch UNIX = new Epoch(0);

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final NotesDesk notes;
  private final Work work;
  private final Runnable changed;
  private final FitSettings settings;
  private volatile Optional<String> failure = Optional.empty();

  DiagnosisDesk(
      SessionDirectory directory,
      ConsoleSettings settings,
      KickDesk kicks,
      NotesDesk notes,
      Work work,
      Runnable changed) {
    this.directory = directory;
    this.kicks = kicks;
    this.notes = notes;
    this.work = work;
    this.changed = changed;
    this.settings = FitSettings.defaults().withSeed(settings.seed());
  }

  /** Why the last diagnosis did not come to an end. */
  Optional<String> failure() {
    return failure;
  }

  /** Whether the kicks or the recordings are others than those that were diagnosed. */
  boolean outdated(KickDesk.View view) {
    return view.outcome()
        .flatMap(
            now ->
                noted()
                    .filter(
                        d -> !d.isOf(view.selection().dropped().keySet(), now.data().recordings())))
        .isPresent();
  }

  /** What the last diagnosis found, here or on the terminal, as long as it is one of these kicks. */
  Optional<Finding> finding(CalibrationOutcome now) {
    return FormerDiagnosis.read(directory.path()).or(this::noted).flatMap(d -> d.about(now));
  }

  /** The diagnosis that is shown. */
  private Optional<FormerDiagnosis> noted() {
    return Optional.ofNullable(notes.now().diagnosis())
        .flatMap(
            note ->
                Verdict.ofId(note.verdict())
                    .map(
                        v -> new Finding(v, note.causes().stream().map(CauseNote::effect).toList()))
                    .map(f -> new FormerDiagnosis(f, note.dropped(), note.recordings())));
  }

  /** Diagnoses the kicks that are not dropped by hand. */
  void run() {
    kicks.calibrated();
    work.ask(DIAGNOSING, this::run);
  }

  private void run(Work.Progress progress) {
    failure = Optional.empty();
    try {
      CalibrationOutcome calibration = simple(kicks.calibrated(), progress);
      DiagnosisSession session =
          new DiagnosisSession(settings, DiagnosisProblem.DEFAULT_MAX_CAUSES);
      DiagnosisOutcome outcome = session.diagnose(calibration, progress::diagnosing);
      progress.diagnosing("writing the report");
      DiagnosisSession.writeAll(outcome, directory.path());
      CalibrationBeside.judgeAgain(outcome, directory.path());
      notes.change(n -> n.withDiagnosis(note(outcome)));
      kicks.under(Optional.empty());
      kicks.circumstancesChanged();
    } catch (CancellationException e) {
      failure = Optional.of("The diagnosis was cancelled.");
      throw e;
    } catch (IOException | RuntimeException | Error e) {
      failure = Optional.of(Failures.words(e));
    } finally {
      changed.run();
    }
  }

  /** A diagnosis is of the simple model, with every number that depends on the decisions up to date. */
  private CalibrationOutcome simple(CalibrationOutcome now, Work.Progress progress)
      throws IOException {
    if (now.extended().isEmpty() && kicks.view().settled()) {
      return now;
    }
    CalibrationRequest request =
        new CalibrationRequest(
            now.logs(),
            Optional.empty(),
            kicks.initial(),
            Optional.empty(),
            now.selection(),
            now.commands());
    return new CalibrationSession(settings).calibrate(now.data(), request, progress);
  }

  private static DiagnosisNote note(DiagnosisOutcome outcome) {
    VerdictText words = VerdictText.of(outcome.diagnosis());
    CauseWords causes =
        new CauseWords(outcome.diagnosis(), outcome.calibration().data().observers());
    return new DiagnosisNote(
        outcome.diagnosis().verdict().id(),
        words.first(),
        words.lines(),
        outcome.diagnosis().causes().stream().map(c -> note(c, causes.of(c))).toList(),
        outcome.calibration().selection().dropped().keySet(),
        FormerDiagnosis.identities(outcome.calibration().data().recordings()));
  }

  private static CauseNote note(Cause cause, CauseText text) {
    return new CauseNote(
        cause.effect().id(),
        text.name(),
        text.what(),
        text.advice(),
        text.strength(),
        cause.indistinguishableFrom(),
        NextKicks.toTellApart(cause.effect().id(), cause.indistinguishableFrom()));
  }

  /**
   * Accepts or refuses the model with the causes.
   *
   * @throws ApiException when there is none, or it cannot be read any more
   */
  void decide(Acceptance acceptance) {
    DiagnosisNote note = notes.now().diagnosis();
    boolean partly = note != null && note.verdict().equals(Verdict.PARTLY_EXPLAINED.id());
    if (note == null || note.causes().isEmpty() && !partly) {
      throw ApiException.conflict("there is no extended model: no cause was found");
    }
    Optional<ExtendedModel> model =
        acceptance == Acceptance.ACCEPTED ? Optional.of(extended()) : Optional.empty();
    notes.change(n -> n.with(acceptance));
    kicks.under(model);
    changed.run();
  }

  /** The extended model that an earlier run accepted. */
  Optional<ExtendedModel> accepted() {
    return notes.now().acceptance() == Acceptance.ACCEPTED
        ? Optional.of(extended())
        : Optional.empty();
  }

  private ExtendedModel extended() {
    try {
      return ExtendedModelFile.read(directory.resolve(SessionDirectory.EXTENDED_MODEL), UNIX);
    } catch (IOException e) {
      throw ApiException.conflict("the extended model cannot be read: " + Failures.words(e));
    }
  }
}
