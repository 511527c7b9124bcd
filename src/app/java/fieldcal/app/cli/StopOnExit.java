package fieldcal.app.cli;

import fieldcal.app.play.PlaySession;
import fieldcal.play.PlayState;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/** Robots must not drive on when somebody presses Ctrl-C: the session is aborted, and the program ends when they stand. */
final class StopOnExit implements AutoCloseable {
  /** Longest that robots take to be told, and to brake, ms. */
  private static final long PATIENCE = 3000;

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
    boolean ended = false;
    try {
      ended = session.awaitEnd(PATIENCE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    err.println("\nfieldcal: " + text(ended));
    err.flush();
    cleanUp.run();
  }

  private String text(boolean ended) {
    if (!ended) {
      return String.format(
          Locale.ROOT,
          "interrupted, but the robots were not seen to stop within %d s: check that they stand"
              + " still",
          PATIENCE / 1000);
    }
    if (session.snapshot().isEmpty()) {
      return "interrupted before the play began";
    }
    PlayState state = session.snapshot().get().state();
    String stand =
        String.format(
            Locale.ROOT,
            "interrupted; both robots stand still; %d kick%s made",
            state.made(),
            state.made() == 1 ? " was" : "s were");
    if (state.made() == 0 || directory.isEmpty()) {
      return stand;
    }
    return stand
        + String.format(
            "; to calibrate: fieldcal calibrate %1$s/session-*.log --out %1$s", directory.get());
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
