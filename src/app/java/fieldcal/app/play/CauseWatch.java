package fieldcal.app.play;

import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.Verdict;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executor;

/** Diagnoses what a session's directory holds while the play goes on, and knows which causes are undecided. All methods are for the play's thread; a diagnosis runs where the executor has it run. */
final class CauseWatch {
  /** The more kicks there are, the longer a diagnosis takes and the less one kick more changes: it waits for this share of new ones. */
  private static final double NEWS = 0.15;

  /** Fewer kicks leave everything undecided: with them none can be held out of a fit of both the model and a cause. */
  private static final int FEWEST_KICKS = 4;

  private final Optional<Path> directory;
  private final Executor executor;
  private volatile boolean busy;
  private volatile UndecidedCauses latest = UndecidedCauses.NONE;
  private int lookedAt;

  /**
   * @param directory with the recordings of earlier sessions, and of this one; empty to watch nothing
   * @param executor for diagnoses, which take seconds
   */
  CauseWatch(Optional<Path> directory, Executor executor) {
    this.directory = directory;
    this.executor = executor;
  }

  /** Whether there are enough kicks, and enough new ones, for another diagnosis. */
  boolean isDue(int good) {
    boolean news = good >= FEWEST_KICKS && good - lookedAt >= Math.max(1, NEWS * good);
    return directory.isPresent() && !busy && news;
  }

  /** Begins a diagnosis of what earlier sessions recorded. */
  void recall() {
    if (directory.isPresent()) {
      look(0);
    }
  }

  /** Begins a diagnosis of what is recorded, when it {@link #isDue}. */
  void look(int good) {
    lookedAt = good;
    busy = true;
    executor.execute(this::diagnose);
  }

  private void diagnose() {
    try {
      DiagnosisOutcome outcome =
          new DiagnosisSession(FitSettings.defaults(), DiagnosisProblem.DEFAULT_MAX_CAUSES)
              .diagnose(
                  PlayRun.calibrate(directory.orElseThrow(), CalibrationSession.Progress.UNSEEN),
                  said -> {});
      // What a part of it is explained by is known and may be undecided; a diagnosis that explains
      // nothing decides nothing either: often a single kick of a new sort does that.
      if (outcome.diagnosis().verdict() != Verdict.UNEXPLAINED_STRUCTURE) {
        latest = UndecidedCauses.of(outcome);
      }
    } catch (IOException | IllegalArgumentException e) {
      // Too few kicks as yet: nothing is known to be undecided.
      latest = UndecidedCauses.NONE;
    } finally {
      busy = false;
    }
  }

  /** Whether a diagnosis is under way. */
  boolean isBusy() {
    return busy;
  }

  /** What the last diagnosis left open. */
  UndecidedCauses undecided() {
    return latest;
  }
}
