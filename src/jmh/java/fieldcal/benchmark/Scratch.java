package fieldcal.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** A directory that is gone with all that is in it when the work is done. */
public final class Scratch implements AutoCloseable {
  private final Path path;

  /**
   * A new, empty directory where the machine keeps such.
   *
   * @param name how its name begins
   * @throws IOException when there can be none
   */
  public Scratch(String name) throws IOException {
    path = Files.createTempDirectory(name);
  }

  /**
   * Where it is.
   *
   * @return the directory
   */
  public Path path() {
    return path;
  }

  @Override
  public void close() throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(path)) {
      files = all.sorted(Comparator.reverseOrder()).toList();
    }
    for (Path file : files) {
      Files.delete(file);
    }
  }
}
