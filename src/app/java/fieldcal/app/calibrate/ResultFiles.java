package fieldcal.app.calibrate;

import fieldcal.app.wording.WordList;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The files that a command writes to the directory of its results. */
public enum ResultFiles {
  /** Those of a calibration. */
  CALIBRATION(
      "calibrate",
      List.of("calibration.json", "report.html", "geometry_models.pb", "geometry_models.txt")),
  /** Those of a diagnosis. */
  DIAGNOSIS("diagnose", List.of("diagnosis.json", "diagnosis.html", "extended_model.json"));

  private final String command;
  private final List<String> names;

  ResultFiles(String command, List<String> names) {
    this.command = command;
    this.names = names;
  }

  /**
   * That the files in a directory are of other recordings than what was written beside them: nobody is to send the one for the other.
   *
   * @param directory of the results; null when nothing was written
   * @param now what was written
   * @return a sentence; empty when there are none, or not known to be of others
   */
  public Optional<String> ofOthers(Path directory, MadeFrom now) {
    if (directory == null) {
      return Optional.empty();
    }
    List<String> there =
        names.stream().filter(name -> Files.isRegularFile(directory.resolve(name))).toList();
    return there.stream()
        .filter(name -> name.endsWith(".json"))
        .flatMap(name -> MadeFrom.read(directory.resolve(name)).unlike(now).stream())
        .findFirst()
        .map(
            others ->
                WordList.of(there)
                    + " in "
                    + directory
                    + (there.size() == 1 ? " is of " : " are of ")
                    + others
                    + "; "
                    + command
                    + (there.size() == 1 ? " replaces it." : " replaces them."));
  }
}
