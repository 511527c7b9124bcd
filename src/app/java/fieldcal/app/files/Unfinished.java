package fieldcal.app.files;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Files that are being written: {@code NAME.PROCESS.part} beside what they will be. A program that is told to end removes its own; what one that was killed left behind, the next that writes into the directory
 * removes.
 */
final class Unfinished {
  private static final Pattern NAME = Pattern.compile(".+\\.(\\d+)\\.part");

  /** Another machine or container that writes into the same directory has process numbers of its own, but writes more often than that. */
  private static final Duration STILL = Duration.ofMinutes(10);

  private static final Set<Path> OWN = ConcurrentHashMap.newKeySet();

  static {
    Runtime.getRuntime()
        .addShutdownHook(new Thread(() -> OWN.forEach(Unfinished::delete), "fieldcal-unfinished"));
  }

  private Unfinished() {}

  /** Where to write what shall become a file. */
  static Path of(Path target) {
    String name = target.getFileName() + "." + ProcessHandle.current().pid() + ".part";
    Path unfinished = target.resolveSibling(name);
    OWN.add(unfinished);
    return unfinished;
  }

  /** It was moved, or is of no use. */
  static void remove(Path unfinished) {
    delete(unfinished);
    OWN.remove(unfinished);
  }

  /** Deletes what programs that are no more were writing. */
  static void removeLeftBehind(Path directory) {
    try (DirectoryStream<Path> parts = Files.newDirectoryStream(directory, "*.part")) {
      for (Path part : parts) {
        Matcher name = NAME.matcher(part.getFileName().toString());
        if (name.matches() && !isAlive(name.group(1)) && isStill(part)) {
          delete(part);
        }
      }
    } catch (IOException e) {
      // A directory that cannot be listed can perhaps be written to; that will be seen.
    }
  }

  private static boolean isAlive(String process) {
    try {
      return ProcessHandle.of(Long.parseLong(process)).isPresent();
    } catch (NumberFormatException e) {
      return true; // none of ours
    }
  }

  private static boolean isStill(Path part) throws IOException {
    return Files.isRegularFile(part)
        && Files.getLastModifiedTime(part).toInstant().isBefore(Instant.now().minus(STILL));
  }

  /** What went wrong before is what the operator must hear of, not that there is nothing to clean up. */
  private static void delete(Path unfinished) {
    try {
      Files.deleteIfExists(unfinished);
    } catch (IOException e) {
      // Tried again by the next program that writes here.
    }
  }
}
