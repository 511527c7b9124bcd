package fieldcal.app.console;

import java.io.IOException;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** The notes of a session, in memory and on the disk. Thread-safe. */
final class NotesDesk {
  private final SessionDirectory directory;
  private SessionNotes notes;
  private Optional<String> unsaved = Optional.empty();

  NotesDesk(SessionDirectory directory) throws IOException {
    this.directory = directory;
    notes = SessionNotes.read(directory.path());
  }

  synchronized SessionNotes now() {
    return notes;
  }

  /** Why the notes are not on the disk. */
  synchronized Optional<String> unsaved() {
    return unsaved;
  }

  /** Changes the notes; a full disk loses none, and the page says that they are not saved. */
  synchronized void change(UnaryOperator<SessionNotes> how) {
    notes = how.apply(notes);
    save();
  }

  /** Tries again to save. */
  synchronized void save() {
    try {
      notes.write(directory.path());
      unsaved = Optional.empty();
    } catch (IOException e) {
      unsaved = Optional.of("The notes on the session are not saved: " + Failures.words(e));
    }
  }
}
