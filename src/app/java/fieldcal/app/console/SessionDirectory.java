package fieldcal.app.console;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.RecordingFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;

/** The directory of a session: which recordings are in it, and which of its files a page may have. Thread-safe. */
final class SessionDirectory {
  static final String SELECTION = "selection.json";
  static final String EXTENDED_MODEL = "extended_model.json";

  /** Recordings of matches are watched, not calibrated. */
  private static final String MATCHES = "matches";

  /** All that is ever served of the directory, with its type. */
  private static final Map<String, String> SERVED =
      Map.of(
          "report.html",
          "text/html; charset=utf-8",
          "calibration.json",
          "application/json",
          "geometry_models.pb",
          "application/octet-stream",
          "geometry_models.txt",
          "text/plain; charset=utf-8",
          SELECTION,
          "application/json",
          "diagnosis.html",
          "text/html; charset=utf-8",
          "diagnosis.json",
          "application/json",
          EXTENDED_MODEL,
          "application/json");

  private final Path path;
  private volatile Predicate<Path> growing = file -> false;
  private final Set<Path> beingRecorded = ConcurrentHashMap.newKeySet();

  private SessionDirectory(Path path) {
    this.path = path;
  }

  /** Opens the directory. It is not made: a name that is mistyped would be an empty session. */
  static SessionDirectory open(Path path) throws IOException {
    if (Files.exists(path) && !Files.isDirectory(path)) {
      throw new InputException(path + ": is a file; the console needs a directory");
    }
    if (!Files.exists(path)) {
      throw new InputException(
          path + ": no such directory; for a new session, make an empty one first");
    }
    if (!Files.isReadable(path) || !Files.isExecutable(path)) {
      throw new InputException(path + ": is not a directory that can be read");
    }
    return new SessionDirectory(path);
  }

  Path path() {
    return path;
  }

  Path resolve(String name) {
    return path.resolve(name);
  }

  /**
   * Says which recordings are being written, and are no recordings of the session yet.
   *
   * @param which those
   */
  void growing(Predicate<Path> which) {
    growing = which;
  }

  /**
   * Says which recording is being written at the moment from the network.
   *
   * @param log no recording of the session yet
   */
  void recording(Path log) {
    beingRecorded.add(log);
  }

  /**
   * Says that it is complete.
   *
   * @param log a recording of the session from now on
   */
  void recorded(Path log) {
    beingRecorded.remove(log);
  }

  /** The recordings that are complete, by name. */
  List<Path> logs() throws IOException {
    return RecordingFolder.logs(path).stream()
        .filter(Predicate.not(growing))
        .filter(log -> !beingRecorded.contains(log))
        .toList();
  }

  /** The same as they are at the moment; one that vanishes meanwhile is none of them. */
  Map<Path, FileStamp> files() throws IOException {
    Map<Path, FileStamp> all = new LinkedHashMap<>();
    for (Path log : logs()) {
      try {
        all.put(log, FileStamp.of(log));
      } catch (NoSuchFileException e) {
        continue;
      }
    }
    return all;
  }

  /** What can be watched: the recordings, and those of matches, which nobody wants to calibrate; by name. */
  Map<String, Path> watchable() throws IOException {
    Map<String, Path> all = new LinkedHashMap<>();
    Path matches = path.resolve(MATCHES);
    if (Files.isDirectory(matches)) {
      new SessionDirectory(matches)
          .logs()
          .forEach(log -> all.put(path.relativize(log).toString(), log));
    }
    logs().forEach(log -> all.put(log.getFileName().toString(), log));
    return all;
  }

  /** What the robots were commanded, of all recordings. */
  List<CommandFile.Command> commands() throws IOException {
    return RecordingFolder.commands(path);
  }

  /** The type of a file that may be served; empty for everything else, whatever is in the directory. */
  static Optional<String> typeOf(String name) {
    return Optional.ofNullable(SERVED.get(name));
  }

  /**
   * A file that may be served.
   *
   * @throws ApiException when the name is none of those, there is no such file, or it is a link that leads out of the directory
   */
  Path served(String name) throws IOException {
    Path file = resolve(name);
    if (typeOf(name).isEmpty()
        || !Files.isRegularFile(file)
        || !file.toRealPath().startsWith(path.toRealPath())) {
      throw ApiException.notFound("the session has no file of that name to show");
    }
    return file;
  }
}
