package fieldcal.app.cli;

import fieldcal.app.calibrate.InputException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Whether results can be written where they are wanted: better told before the work than after it. */
final class OutputPlaces {
  private OutputPlaces() {}

  /**
   * Checks {@code --out} and {@code --json}.
   *
   * @param out null when not given
   * @param json null when not given
   * @throws InputException when a file is where a directory is wanted, or the other way round
   */
  static void check(Path out, Path json) throws InputException {
    if (out != null && Files.exists(out) && !Files.isDirectory(out)) {
      throw new InputException(out + ": is a file; --out needs a directory");
    }
    if (json != null && Files.isDirectory(json)) {
      throw new InputException(json + ": is a directory; --json needs a file");
    }
  }
}
