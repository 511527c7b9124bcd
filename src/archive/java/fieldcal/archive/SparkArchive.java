package fieldcal.archive;

import fieldcal.app.archive.ArchiveEngine;
import fieldcal.app.archive.ArchiveOutcome;
import fieldcal.app.archive.ArchiveRequest;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.recording.DifferentRecordings;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.archive.match.MatchTables;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Table;
import fieldcal.archive.table.Tables;
import fieldcal.archive.venue.Carpet;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** {@code archive}: finds the logs, has them read, and writes what follows from all of them. */
public final class SparkArchive implements ArchiveEngine {

  /** Made by the service loader. */
  public SparkArchive() {}

  @Override
  public ArchiveOutcome run(ArchiveRequest request, Progress progress) throws IOException {
    List<LogFile> files = LogFinder.find(request.paths());
    Path root = request.out().toAbsolutePath().normalize();
    ArchiveFolder folder = new ArchiveFolder(root.toString());
    folder.requireOwnFolders(request.out(), files);
    ArchiveLock lock = ArchiveLock.take(root);
    try {
      if (folder.begun() && !request.resume()) {
        throw new InputException(
            request.out() + ": there is an archive already; --resume continues it");
      }
      SparkMessages.into(root.resolve("spark-messages.txt"));
      try (Engine engine = Engine.start(request.master())) {
        return run(request, files, folder, engine, progress);
      }
    } finally {
      lock.close();
    }
  }

  private static ArchiveOutcome run(
      ArchiveRequest request,
      List<LogFile> files,
      ArchiveFolder folder,
      Engine engine,
      Progress progress)
      throws IOException {
    List<String> findings = new ArrayList<>();
    List<LogFile> logs = different(engine.identify(files), findings);
    folder.prepare();
    requireAllOf(folder, logs, request.out());
    Set<String> read = new HashSet<>();
    List<LogFile> open = new ArrayList<>();
    for (LogFile log : logs) {
      if (log.log() != null && !folder.isDone(log, request.opener())) {
        open.add(log);
      }
    }
    do {
      Map<String, LogFile> now = new HashMap<>();
      if (!open.isEmpty()) {
        engine
            .read(open, folder, request.opener(), progress)
            .forEach(log -> now.put(log.path(), log));
      }
      logs.replaceAll(log -> now.getOrDefault(log.path(), log));
      read.addAll(now.keySet());
      open = missing(folder, logs);
    } while (!open.isEmpty());
    leaveOutRepeated(folder, logs, findings);
    for (LogFile log : logs) {
      if (log.log() == null) {
        Row row = MatchTables.broken(null, Path.of(log.path()), log.unreadable());
        ArchiveFolder.replace(Tables.PROBLEMS, List.of(row), folder.file(Tables.PROBLEMS, log));
      }
    }
    Conclusions conclusions = engine.conclude(logs, folder);
    write(folder, logs, conclusions);
    Atlas.write(conclusions, folder);
    long skipped =
        logs.stream().filter(log -> log.log() != null && !read.contains(log.path())).count();
    return outcome(conclusions, (int) skipped, findings);
  }

  /** One log for each content; the order of the files decides under which name. */
  private static List<LogFile> different(List<LogFile> files, List<String> findings) {
    Map<String, LogFile> first = new HashMap<>();
    List<LogFile> logs = new ArrayList<>();
    for (LogFile file : files) {
      LogFile before = file.log() == null ? null : first.putIfAbsent(file.log(), file);
      if (before == null) {
        logs.add(file);
      } else {
        findings.add(
            file.path() + ": has the same content as " + before.path() + "; it is read once");
      }
    }
    return logs;
  }

  /** Which logs hold the same frames; the order of the logs decides between equal ones. */
  private static DifferentRecordings compared(ArchiveFolder folder, List<LogFile> logs)
      throws IOException {
    List<RecordingFacts> all = new ArrayList<>();
    for (LogFile log : logs) {
      if (log.log() != null) {
        folder.facts(log).ifPresent(all::add);
      }
    }
    return DifferentRecordings.among(all);
  }

  /** Logs that were left out for the sake of one that now is left out itself: their rows are not there. */
  private static List<LogFile> missing(ArchiveFolder folder, List<LogFile> logs)
      throws IOException {
    Set<Path> used = new HashSet<>();
    compared(folder, logs).different().forEach(facts -> used.add(facts.log()));
    List<LogFile> missing = new ArrayList<>();
    for (LogFile log : logs) {
      if (log.log() != null && folder.isLeftOut(log) && used.contains(Path.of(log.path()))) {
        folder.forget(log.log());
        missing.add(log);
      }
    }
    return missing;
  }

  /** Frames that are in two logs, packed and unpacked or whole and cut off, would count twice. */
  private static void leaveOutRepeated(
      ArchiveFolder folder, List<LogFile> logs, List<String> findings) throws IOException {
    Map<String, LogFile> byPath = new HashMap<>();
    logs.forEach(log -> byPath.put(log.path(), log));
    for (DifferentRecordings.Repeated repeated : compared(folder, logs).repeated()) {
      LogFile log = byPath.get(repeated.facts().log().toString());
      folder.leaveOut(log);
      logs.remove(log);
      findings.add(
          log.path() + ": " + repeated.words(repeated.original().log().toString()) + "; left out");
    }
  }

  /** Tables of fewer logs than the archive has would silently lose what is there. A log that has grown or was replaced, though, takes the place of the old one. */
  static void requireAllOf(ArchiveFolder folder, List<LogFile> logs, Path out) throws IOException {
    Set<String> named = new HashSet<>();
    logs.forEach(log -> named.add(log.log()));
    List<String> replaced = new ArrayList<>();
    List<String> others = new ArrayList<>();
    for (String log : folder.done()) {
      if (!named.contains(log)) {
        (isReplaced(folder, log, logs) ? replaced : others).add(log);
      }
    }
    if (!others.isEmpty()) {
      String first = others.get(0);
      throw new InputException(
          out
              + ": contains "
              + (others.size() == 1 ? "1 log that is" : others.size() + " logs that are")
              + " not among those named, the first "
              + folder
                  .named(first)
                  .map(log -> log.name() + " of " + log.tournament())
                  .orElse("with the content " + first)
              + "; name all of them, or another directory");
    }
    for (String log : replaced) {
      folder.forget(log);
    }
  }

  /** Whether a log of the same name in the same folder has come that the archive does not have yet. */
  private static boolean isReplaced(ArchiveFolder folder, String log, List<LogFile> logs)
      throws IOException {
    Optional<ArchiveFolder.Named> old = folder.named(log);
    return old.isPresent()
        && logs.stream()
            .anyMatch(
                file ->
                    file.log() != null
                        && !folder.isRecorded(file.log())
                        && old.get()
                            .equals(new ArchiveFolder.Named(file.tournament(), file.name())));
  }

  /** What one log alone does not know: the venue of its match, and the tables of all together. */
  private static void write(ArchiveFolder folder, List<LogFile> logs, Conclusions conclusions)
      throws IOException {
    Map<String, Carpet> carpets = conclusions.carpets();
    for (LogFile log : logs) {
      Optional<Row> match = log.log() == null ? Optional.empty() : folder.match(log);
      if (match.isPresent()) {
        Carpet carpet = carpets.get(log.log());
        Row row =
            match
                .get()
                .set("venue", carpet == null ? null : carpet.venue())
                .set("carpet", carpet == null ? null : carpet.name());
        ArchiveFolder.replace(Tables.MATCHES, List.of(row), folder.file(Tables.MATCHES, log));
      }
    }
    for (Table table : Tables.OF_MATCHES) {
      folder.keepOnly(table, logs);
    }
    folder.replace(Tables.CARPETS, conclusions.carpetRows());
    folder.replace(Tables.CHANGES, conclusions.changeRows());
    folder.replace(Tables.TEAMS, conclusions.teamRows());
  }

  private static ArchiveOutcome outcome(
      Conclusions conclusions, int skipped, List<String> findings) {
    int broken = 0;
    double play = 0;
    long kicks = 0;
    for (MatchSummary summary : conclusions.summaries()) {
      if (summary.facts() == null) {
        broken++;
      } else {
        play += 1e-6 * (summary.facts().end() - summary.facts().start());
        kicks += summary.kicks();
      }
    }
    List<String> all = new ArrayList<>(findings);
    all.addAll(FindingWords.of(conclusions));
    return new ArchiveOutcome(conclusions.summaries().size(), skipped, broken, play, kicks, all);
  }
}
