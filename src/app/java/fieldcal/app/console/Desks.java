package fieldcal.app.console;

import fieldcal.app.history.History;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Clock;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;

/** All that a console consists of behind its web server, wired together. */
final class Desks {
  private final SessionDirectory directory;
  private final AtomicLong changes = new AtomicLong();
  private final EventHub events = new EventHub();
  private final Work work;
  private final NotesDesk notes;
  private final KickDesk kicks;
  private final DiagnosisDesk diagnosis;
  private final VisionDesk vision;
  private final History history;
  private final PublishDesk publish;
  private final ExportDesk export;
  private final MatchDesk match;
  private final PlayDesk play;
  private final RecordDesk record;
  private final DirectoryWatch watch;
  private final StateJson json;

  Desks(ConsoleSettings settings, Clock clock) throws IOException {
    directory = SessionDirectory.open(settings.directory());
    work = new Work(this::tellWork);
    notes = new NotesDesk(directory);
    kicks = new KickDesk(directory, settings, work, this::tellState);
    diagnosis = new DiagnosisDesk(directory, settings, kicks, notes, work, this::tellState);
    vision = new VisionDesk(clock, kicks::circumstancesChanged);
    kicks.circumstances(
        o -> o.knowing(diagnosis.finding(o), vision.heard().flatMap(VisionDesk.Heard::geometry)));
    history = new History(directory.path());
    publish = new PublishDesk(directory, kicks, notes, vision, history, clock, this::tellState);
    export = new ExportDesk(directory, kicks, diagnosis, publish, history, clock, this::tellState);
    match = new MatchDesk(directory, settings.opener(), kicks, events, this::tellState);
    play = new PlayDesk(directory, kicks, events, this::tellState);
    record = new RecordDesk(directory, kicks, clock, events, this::tellState);
    watch = new DirectoryWatch(directory, this::tellState);
    json =
        new StateJson(
            directory,
            kicks,
            diagnosis,
            vision,
            match,
            play,
            record,
            publish,
            notes,
            history,
            work,
            clock.millis(),
            changes::get);
  }

  /** Begins with what is in the directory. */
  void start() {
    try {
      kicks.under(diagnosis.accepted());
    } catch (ApiException e) {
      // Without its file the model cannot be accepted any more; the page shows the simple one.
      notes.change(n -> n.with(SessionNotes.Acceptance.OPEN));
      kicks.under(Optional.empty());
    }
    work.start();
    kicks.read();
    watch.start();
  }

  void stop() {
    watch.close();
    vision.close();
    match.close();
    play.close();
    record.close();
    publish.close();
    work.close();
    kicks.close();
    events.close();
  }

  /** Tries again to save what could not be saved. */
  void save() {
    notes.change(n -> n);
    kicks.saveAgain();
  }

  private void tellState() {
    events.tell("state", Long.toString(changes.incrementAndGet()));
  }

  private void tellWork() {
    try {
      events.tell("work", json.work());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  SessionDirectory directory() {
    return directory;
  }

  EventHub events() {
    return events;
  }

  Work work() {
    return work;
  }

  KickDesk kicks() {
    return kicks;
  }

  DiagnosisDesk diagnosis() {
    return diagnosis;
  }

  VisionDesk vision() {
    return vision;
  }

  PublishDesk publish() {
    return publish;
  }

  ExportDesk export() {
    return export;
  }

  MatchDesk match() {
    return match;
  }

  PlayDesk play() {
    return play;
  }

  RecordDesk record() {
    return record;
  }

  StateJson json() {
    return json;
  }
}
