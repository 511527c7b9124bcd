package fieldcal.archive;

import fieldcal.app.calibrate.InputException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** From what was named to the game logs, in an order that does not depend on how they were named. */
final class LogFinder {
  private LogFinder() {}

  static List<LogFile> find(List<Path> paths) throws IOException {
    Map<Path, LogFile> found = new TreeMap<>();
    for (Path path : paths) {
      if (!Files.exists(path)) {
        throw new InputException(path + ": no such file or folder");
      }
      List<Path> logs = Files.isDirectory(path) ? inFolder(path) : List.of(path);
      if (logs.isEmpty()) {
        throw new InputException(path + ": there is no game log (*.log, *.log.gz) in this folder");
      }
      for (Path log : logs) {
        // A link is called as whoever made it calls it; what it leads to is read once.
        LogFile file = file(log.toAbsolutePath().normalize());
        found.merge(log.toRealPath(), file, (a, b) -> a.path().compareTo(b.path()) <= 0 ? a : b);
      }
    }
    List<LogFile> sorted = new ArrayList<>(found.values());
    sorted.sort(
        Comparator.comparing(LogFile::tournament)
            .thenComparing(LogFile::name)
            .thenComparing(LogFile::path));
    return sorted;
  }

  private static LogFile file(Path log) throws IOException {
    Path folder = log.getParent().getFileName();
    String tournament = LogFile.safe(folder == null ? "" : folder.toString());
    String name = log.getFileName().toString();
    return new LogFile(log.toString(), name, tournament, Files.size(log), 0, null, null);
  }

  private static List<Path> inFolder(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder, FileVisitOption.FOLLOW_LINKS)) {
      return files
          .filter(file -> file.getFileName().toString().matches(".*\\.log(\\.gz)?"))
          .filter(Files::isRegularFile)
          .toList();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }
}
