package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.cli.Main;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import picocli.CommandLine;

/** Recordings to work on, which are made once for all tests. */
final class SampleSession {
  /** Kicks of the recording that a diagnosis finds something in. */
  static final int KICKS = 14;

  /** Kicks of the recording that is for everything else, of which seven are found. */
  private static final int FEW_KICKS = 8;

  private static final String LOG = "practice.log.gz";

  private SampleSession() {}

  /** Made when the first test asks for it. */
  private static final class Full {
    private static final Path LOG = recorded(KICKS);
  }

  /** Likewise. */
  private static final class Few {
    private static final Path LOG = recorded(FEW_KICKS);
  }

  /** Simulated flat kicks on a field whose air the model does not know, so that kicks differ and a diagnosis finds something; tests copy it. */
  static Path full() {
    return Full.LOG;
  }

  /** As many kicks as a model needs, which are calibrated in a second. */
  static Path small() {
    return Few.LOG;
  }

  private static Path recorded(int kicks) {
    try {
      Path directory = Files.createTempDirectory("fieldcal-kicks");
      Path log = directory.resolve(LOG);
      simulate(
          "--scenario=flat",
          "--physics=contact",
          "--kicks=" + kicks,
          "--seed=1",
          "--effect=air_drag:cd=0.45",
          "--out=" + log);
      directory.toFile().deleteOnExit();
      try (Stream<Path> files = Files.list(directory)) {
        files.forEach(file -> file.toFile().deleteOnExit());
      }
      return log;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void simulate(String... options) {
    run(Stream.concat(Stream.of("simulate"), Stream.of(options)).toArray(String[]::new));
  }

  /** Runs a command, which has to succeed. */
  static void run(String... args) {
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(new StringWriter()));
    commands.setErr(new PrintWriter(err));
    int exit = commands.execute(args);
    assertThat(exit).as(err.toString()).isZero();
  }

  /** A short match, which is watched, not calibrated. One of its four cameras is 22 mm off from the others. */
  static void recordMatch(Path session) throws IOException {
    Path log = Files.createDirectories(session.resolve("matches")).resolve("match.log.gz");
    simulate(
        "--scenario=match",
        "--minutes=1",
        "--seed=3",
        "--effect=camera_offset:x_mm=16.5,camera=1",
        "--out=" + log);
  }

  /** Kicks of both kinds and a match that is long enough for estimates. */
  static void recordForPictures(Path session) throws IOException {
    simulate(
        "--scenario=mixed",
        "--physics=contact",
        "--kicks=18",
        "--seed=8",
        "--effect=air_drag:cd=0.45",
        "--out=" + session.resolve("practice.log.gz"));
    Path log = Files.createDirectories(session.resolve("matches")).resolve("final.log.gz");
    simulate("--scenario=match", "--minutes=5", "--seed=3", "--out=" + log);
  }

  static Path copy(Path log, Path directory) throws IOException {
    Files.createDirectories(directory);
    return Files.copy(log, directory.resolve(LOG));
  }
}
