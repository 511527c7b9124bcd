package fieldcal.archive;

import fieldcal.app.recording.LogOpener;
import fieldcal.archive.match.Fingerprint;
import fieldcal.archive.match.MatchData;
import fieldcal.archive.match.MatchReader;
import fieldcal.archive.match.MatchTables;
import fieldcal.gamelog.GameLogException;
import java.io.EOFException;
import java.io.IOException;
import java.io.Serializable;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipException;

/** What a task does with its log. Whatever the log holds costs that log alone; only an archive that cannot be written fails the task. */
final class LogTask {
  private static final String CHANGED =
      "changed while it was read: is it still being recorded? --resume reads it when it is"
          + " complete";

  /**
   * What became of a log.
   *
   * @param log the same as before; without fingerprint when it changed while it was read, or the disk failed
   * @param play time between its first and last message, s; 0 when it cannot be read
   */
  record Done(LogFile log, double play) implements Serializable {}

  private LogTask() {}

  /** Finds out which log a file is. */
  static LogFile identify(LogFile file) {
    try {
      Path path = Path.of(file.path());
      long written = Files.getLastModifiedTime(path).toMillis();
      return file.withLog(Fingerprint.of(path), written);
    } catch (FileSystemException e) {
      return file.withFailure(
          "cannot be opened: "
              + (e.getReason() == null ? e.getClass().getSimpleName() : e.getReason()));
    } catch (IOException e) {
      return file.withFailure("cannot be read: " + e.getMessage());
    }
  }

  /**
   * Reads a log and writes its rows; none of a log that was written meanwhile: what was read is not what was identified.
   *
   * @return the log, and the time between its first and last message
   */
  static Done run(LogFile log, ArchiveFolder folder, LogOpener opener, String attempt)
      throws IOException {
    Path path = Path.of(log.path());
    MatchData match;
    String why;
    try {
      match = MatchReader.read(path, opener);
      why = null;
    } catch (IOException e) {
      if (!isOfTheContent(e)) {
        return new Done(log.withFailure(e.getMessage() + "; --resume tries again"), 0);
      }
      match = null;
      why = e.getMessage();
    } catch (RuntimeException | StackOverflowError e) {
      match = null;
      why = "this is a defect, please report it: " + e + at(e);
    }
    if (changed(log)) {
      return new Done(log.withFailure(CHANGED), 0);
    }
    if (match == null) {
      folder.commitUnread(log, MatchTables.broken(log.log(), path, why), opener, attempt);
      return new Done(log, 0);
    }
    folder.commit(log, MatchTables.of(log.log(), match), match.data().recordings().get(0), attempt);
    return new Done(log, match.data().duration());
  }

  /** Whether a log is as it is for ever; else the disk or the network failed, which may be over by the next time. */
  static boolean isOfTheContent(IOException e) {
    Throwable cause = e.getCause();
    return e instanceof GameLogException
        && (cause == null || cause instanceof EOFException || cause instanceof ZipException);
  }

  /** A file that was written since is read again, to be sure; that it is gone shows when it is read. */
  private static boolean changed(LogFile log) throws IOException {
    Path path = Path.of(log.path());
    try {
      return Files.getLastModifiedTime(path).toMillis() != log.modified()
          && !Fingerprint.of(path).equals(log.log());
    } catch (FileSystemException gone) {
      return true;
    }
  }

  private static String at(Throwable e) {
    StackTraceElement[] trace = e.getStackTrace();
    return trace.length == 0 ? "" : " at " + trace[0];
  }
}
