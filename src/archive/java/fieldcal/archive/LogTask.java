package fieldcal.archive;

import fieldcal.app.recording.LogOpener;
import fieldcal.archive.match.Fingerprint;
import fieldcal.archive.match.MatchData;
import fieldcal.archive.match.MatchReader;
import fieldcal.archive.match.MatchTables;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** What a task does with its log. Whatever the log holds costs that log alone; only an archive that cannot be written fails the task. */
final class LogTask {
  private LogTask() {}

  /** Finds out which log a file is. */
  static LogFile identify(LogFile file) {
    try {
      return file.withLog(Fingerprint.of(Path.of(file.path())));
    } catch (FileSystemException e) {
      return file.withFailure(
          "cannot be opened: "
              + (e.getReason() == null ? e.getClass().getSimpleName() : e.getReason()));
    } catch (IOException e) {
      return file.withFailure("cannot be read: " + e.getMessage());
    }
  }

  /**
   * Reads a log and writes its rows.
   *
   * @return time between its first and last message, s; 0 when it cannot be read
   */
  static double run(LogFile log, ArchiveFolder folder, LogOpener opener, String attempt)
      throws IOException {
    Path path = Path.of(log.path());
    MatchData match;
    String why;
    try {
      match = MatchReader.read(path, opener);
      why = null;
    } catch (IOException e) {
      match = null;
      why = e.getMessage();
    } catch (RuntimeException | StackOverflowError e) {
      match = null;
      why = "this is a defect, please report it: " + e + at(e);
    }
    if (match == null) {
      List<Row> rows = List.of(MatchTables.broken(log.log(), path, why));
      folder.commit(log, Map.of(Tables.PROBLEMS, rows), attempt);
      return 0;
    }
    folder.commit(log, MatchTables.of(log.log(), match), attempt);
    return match.data().duration();
  }

  private static String at(Throwable e) {
    StackTraceElement[] trace = e.getStackTrace();
    return trace.length == 0 ? "" : " at " + trace[0];
  }
}
