package fieldcal.archive;

import fieldcal.app.archive.ArchiveEngine;
import fieldcal.app.archive.ArchiveOutcome;
import fieldcal.app.archive.ArchiveRequest;
import fieldcal.app.calibrate.InputException;
import fieldcal.archive.match.MatchTables;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Table;
import fieldcal.archive.table.Tables;
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
      if (log.log() != null && !folder.isDone(log)) {
        open.add(log);
      }
    }
    if (!open.isEmpty()) {
      engine.read(open, folder, progress);
    }
    return finish(folder, logs, logs.size() - open.size(), findings);
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
        findings.add(file.path() + ": is the same as " + before.path() + "; read once");
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
              + ": holds "
              + others.size()
              + " logs that are not among those named, the first with the content "
              + others.get(0)
              + "; name all of them, or another directory");
    }
  }

  private static ArchiveOutcome finish(
      ArchiveFolder folder, List<LogFile> logs, int skipped, List<String> findings)
      throws IOException {
    int broken = 0;
    double play = 0;
    long kicks = 0;
    for (LogFile log : logs) {
      if (log.log() == null) {
        Row row = MatchTables.broken(null, Path.of(log.path()), log.unreadable());
        ArchiveFolder.replace(Tables.PROBLEMS, List.of(row), folder.file(Tables.PROBLEMS, log));
      }
      Optional<Row> match = log.log() == null ? Optional.empty() : folder.match(log);
      if (match.isEmpty()) {
        broken++;
        continue;
      }
      play += match.get().number("duration");
      kicks += match.get().whole("kicks");
      ArchiveFolder.replace(Tables.MATCHES, List.of(match.get()), folder.file(Tables.MATCHES, log));
    }
    for (Table table : Tables.ALL) {
      folder.keepOnly(table, logs);
    }
    return new ArchiveOutcome(logs.size(), skipped, broken, play, kicks, findings);
  }
}
