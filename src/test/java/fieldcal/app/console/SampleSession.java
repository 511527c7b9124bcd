package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.cli.Main;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import picocli.CommandLine;

/** A session to work on: fourteen simulated flat kicks on a field whose air the model does not know, so that kicks differ and a diagnosis finds something. */
final class SampleSession {
  static final int KICKS = 14;

  private static final String LOG = "practice.log.gz";

  private SampleSession() {}

  /** Makes the recording once; tests copy it. */
  static Path record(Path directory) {
    Path log = directory.resolve(LOG);
    simulate(
        "--scenario=flat",
        "--physics=contact",
        "--kicks=" + KICKS,
        "--seed=1",
        "--effect=air_drag:cd=0.45",
        "--out=" + log);
    return log;
  }

  private static void simulate(String... options) {
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(new StringWriter()));
    commands.setErr(new PrintWriter(err));
    int exit =
        commands.execute(
            Stream.concat(Stream.of("simulate"), Stream.of(options)).toArray(String[]::new));
    assertThat(exit).as(err.toString()).isZero();
  }

  /** A short match, which is watched, not calibrated. */
  static void recordMatch(Path session) throws IOException {
    Path log = Files.createDirectories(session.resolve("matches")).resolve("match.log.gz");
    simulate("--scenario=match", "--minutes=1", "--seed=3", "--out=" + log);
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
