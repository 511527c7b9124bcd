package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A command that is run again on the same recording writes and prints the same, byte by byte. */
class RepeatedRunTest {
  @TempDir private static Path folder;

  private static Path log;

  @BeforeAll
  static void simulate() throws IOException {
    log = folder.resolve("kicks.log.gz");
    Told.by("simulate", "--scenario=mixed", "--kicks=6", "--seed=3", "--out=" + log);
  }

  /** Each file as text, which shows where two differ; bytes of no text stay distinct in this charset. */
  private static Map<String, String> files(Path directory) throws IOException {
    List<Path> all;
    try (Stream<Path> found = Files.walk(directory)) {
      all = found.filter(Files::isRegularFile).toList();
    }
    Map<String, String> content = new TreeMap<>();
    for (Path file : all) {
      String name = directory.relativize(file).toString();
      content.put(name, Files.readString(file, StandardCharsets.ISO_8859_1));
    }
    return content;
  }

  private static Map<String, String> resultsOf(String command) throws IOException {
    // Results name their own place, so it is the same each time.
    Path out = folder.resolve("results");
    String said =
        Told.by(command, "" + log, "--out", "" + out, "--json", "" + folder.resolve("j.json"));
    Map<String, String> all = files(out);
    all.put("--json", Files.readString(folder.resolve("j.json")));
    all.put("standard output", said);
    Files.move(out, folder.resolve(command + all.hashCode() + System.nanoTime()));
    return all;
  }

  @Test
  void calibrateWritesTheSameAgain() throws IOException {
    Map<String, String> first = resultsOf("calibrate");
    assertThat(first).containsKeys("calibration.json", "report.html", "geometry_models.pb");
    assertThat(resultsOf("calibrate")).isEqualTo(first);
  }

  @Test
  void diagnoseWritesTheSameAgain() throws IOException {
    Map<String, String> first = resultsOf("diagnose");
    assertThat(first).containsKey("diagnosis.json");
    assertThat(resultsOf("diagnose")).isEqualTo(first);
  }
}
