package fieldcal.archive;

import fieldcal.archive.match.Fingerprint;
import java.io.Serializable;

/**
 * A game log that was named, or found in a folder.
 *
 * @param path of the file
 * @param name of the file alone
 * @param tournament name of the folder it lies in
 * @param bytes size of the file
 * @param modified when the file was last written before it was identified, ms of Unix time; 0 as long as it is not known
 * @param log fingerprint of its content; null as long as it is not known
 * @param unreadable why the file cannot be opened; null when it can
 */
record LogFile(
    String path,
    String name,
    String tournament,
    long bytes,
    long modified,
    String log,
    String unreadable)
    implements Serializable {

  LogFile withLog(String fingerprint, long written) {
    return new LogFile(path, name, tournament, bytes, written, fingerprint, null);
  }

  LogFile withFailure(String why) {
    return new LogFile(path, name, tournament, bytes, modified, null, why);
  }

  /** Its partition: the file's name, for people, and the content, so that no two logs share one; where the content is not known, the path. */
  String match() {
    String stem = safe(name.replaceFirst("\\.log(\\.gz)?$", ""));
    return stem
        + "-"
        + (log == null
            ? "unreadable-" + Fingerprint.of(path).substring(0, 8)
            : log.substring(0, 8));
  }

  /** What every file system, every query engine and a URL take as a folder's name. */
  static String safe(String text) {
    String plain = text.replaceAll("[^\\p{IsAlphabetic}\\p{IsDigit}._-]", "_");
    return plain.isEmpty() ? "_" : plain;
  }
}
