package fieldcal.archive;

import fieldcal.app.archive.ArchiveEngine;
import fieldcal.app.archive.ArchiveOutcome;
import fieldcal.app.archive.ArchiveRequest;
import fieldcal.app.calibrate.InputException;
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
    List<LogFile> open = new ArrayList<>();
    for (LogFile log : logs) {
      if (log.log() != null && !folder.isDone(log, request.opener())) {
        open.add(log);
      }
    }
    if (!open.isEmpty()) {
      Map<String, LogFile> read = new HashMap<>();
      engine
          .read(open, folder, request.opener(), progress)
          .forEach(log -> read.put(log.path(), log));
      logs.replaceAll(log -> read.getOrDefault(log.path(), log));
    }
    for (LogFile log : logs) {
      if (log.log() == null) {
        Row row = MatchTables.broken(null, Path.of(log.path()), log.unreadable());
        ArchiveFolder.replace(Tables.PROBLEMS, List.of(row), folder.file(Tables.PROBLEMS, log));
      }
    }
    Conclusions conclusions = engine.conclude(logs, folder);
    write(folder, logs, conclusions);
    Atlas.write(conclusions, folder);
    return outcome(conclusions, logs.size() - open.size(), findings);
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

  /** Tables of fewer logs than the archive has would silently lose what is there. */
  private static void requireAllOf(ArchiveFolder folder, List<LogFile> logs, Path out)
      throws IOException {
    Set<String> named = new HashSet<>();
    logs.forEach(log -> named.add(log.log()));
    List<String> others = folder.done().stream().filter(log -> !named.contains(log)).toList();
    if (!others.isEmpty()) {
      throw new InputException(
          out
              + ": contains "
              + (others.size() == 1 ? "1 log that is" : others.size() + " logs that are")
              + " not among those named, the first with the content "
              + others.get(0)
              + "; name all of them, or another directory");
    }
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
