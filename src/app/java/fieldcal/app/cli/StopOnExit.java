package fieldcal.app.cli;

import fieldcal.app.play.PlaySession;
import fieldcal.play.PlayState;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/** Robots must not drive on when somebody presses Ctrl-C: the session is aborted, and the program ends when they stand and the ball of the last kick rests. A second Ctrl-C ends it at once. */
final class StopOnExit implements AutoCloseable {
  /** Who waits for longer wants to know what for, ms. */
  private static final long AT_ONCE = 1000;

  private final PlaySession session;
  private final Optional<Path> directory;
  private final Runnable cleanUp;
  private final PrintWriter err;
  private final Thread hook = new Thread(this::stop, "stop on exit");
  private volatile boolean happened;

  /** From now on; the directory is that of the recording, if it is kept. Cleaning up comes last. */
  StopOnExit(PlaySession session, Optional<Path> directory, Runnable cleanUp, PrintWriter err) {
    this.session = session;
    this.directory = directory;
    this.cleanUp = cleanUp;
    this.err = err;
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Whether the program is about to end; then nothing more needs to be said. */
  boolean happened() {
    return happened;
  }

  private void stop() {
    happened = true;
    session.abort("interrupted");
    NextInterrupt.then(session::endNow);
    boolean ended = false;
    try {
      ended = session.awaitEnd(AT_ONCE);
      if (!ended) {
        err.println(
            "\nfieldcal: Both robots stop. The last kick is still recorded and judged. This takes "
                + PlaySession.LONGEST_END / 1000
                + " s at most. Press Ctrl-C again to end at once.");
        err.flush();
        ended = session.awaitEnd(PlaySession.LONGEST_END);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    err.println("\nfieldcal: " + text(ended));
    err.flush();
    cleanUp.run();
  }

  private String text(boolean ended) {
    // What else it may wait for are fits, and the recording is complete by then.
    if (!ended && !session.robotsStand()) {
      return String.format(
          Locale.ROOT,
          "The play was interrupted. The robots were not seen to stop within %d s: check that they"
              + " stand still.",
          PlaySession.LONGEST_END / 1000);
    }
    if (session.snapshot().isEmpty()) {
      return "The play was interrupted before it began.";
    }
    PlayState state = session.snapshot().get().state();
    String stand =
        String.format(
            Locale.ROOT,
            "The play was interrupted. %s %d kick%s made.",
            session.robotsStand()
                ? "Both robots stand still."
                : "The robots were not seen to stop: check that they stand still.",
            state.made(),
            state.made() == 1 ? " was" : "s were");
    return stand + toCalibrate(state.made(), directory);
  }

  /** How to calibrate a session that ended early; empty when no kick was recorded. */
  static String toCalibrate(int kicks, Optional<Path> directory) {
    return kicks == 0
        ? ""
        : directory
            .map(
                d ->
                    String.format(
                        " To calibrate: fieldcal calibrate %1$s/session-*.log --out %1$s", d))
            .orElse("");
  }

  @Override
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The machine is going down already; that is what the hook was for.
      return;
    }
  }
}
