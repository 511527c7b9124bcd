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
    checkDirectory("--out", out);
    checkFile("--json", json);
  }

  /**
   * Checks an option that names a directory.
   *
   * @param option as it is typed
   * @param directory null when not given
   * @throws InputException when it is a file
   */
  static void checkDirectory(String option, Path directory) throws InputException {
    if (directory != null && Files.exists(directory) && !Files.isDirectory(directory)) {
      throw new InputException(directory + ": is a file; " + option + " needs a directory");
    }
  }

  /**
   * Checks an option that names a file.
   *
   * @param option as it is typed
   * @param file null when not given
   * @throws InputException when it is a directory
   */
  static void checkFile(String option, Path file) throws InputException {
    if (file != null && Files.isDirectory(file)) {
      throw new InputException(file + ": is a directory; " + option + " needs a file");
    }
  }
}
