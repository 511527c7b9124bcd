package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.proto.Referee;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Commands, each as a program of its own, whose input or output is no plain file. */
class OddFilesTest {
  private static final Path LOG =
      Path.of(System.getProperty("fieldcal.projectDir", "."))
          .resolve("test-data/erforce-flat.log.gz");

  private static final long LONGEST_S = 120;

  @TempDir static Path folder;

  private static Path pipe;

  private record Ended(int status, String out, String err) {}

  @BeforeAll
  static void makeAPipe() throws Exception {
    assumeTrue(Files.exists(Path.of("/dev/full")), "no /dev/full here");
    pipe = folder.resolve("pipe.log");
    assumeTrue(
        new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0, "no mkfifo here");
  }

  private static List<String> command(String... args) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp"));
    command.add(System.getProperty("java.class.path"));
    command.add("fieldcal.app.cli.Main");
    command.addAll(List.of(args));
    return command;
  }

  /** Runs a command whose standard output is a given file. */
  private static Ended run(File out, String... args) throws Exception {
    List<String> command = command(args);
    Path err = folder.resolve("err.txt");
    Process process =
        new ProcessBuilder(command).redirectOutput(out).redirectError(err.toFile()).start();
    try {
      assertThat(process.waitFor(LONGEST_S, TimeUnit.SECONDS)).as("%s ends", command).isTrue();
    } finally {
      process.destroyForcibly();
    }
    String said = out.isFile() ? Files.readString(out.toPath()) : "";
    return new Ended(process.exitValue(), said, Files.readString(err));
  }

  private static Ended run(String... args) throws Exception {
    return run(folder.resolve("out.txt").toFile(), args);
  }

  @ParameterizedTest
  @ValueSource(strings = {"info", "calibrate", "limits", "monitor --log"})
  void aRecordingThatIsAPipeIsRefusedWithoutWaiting(String command) throws Exception {
    Ended ended = run((command + " " + pipe).split(" "));
    assertThat(ended.status()).isEqualTo(1);
    assertThat(ended.err())
        .isEqualTo("fieldcal: " + pipe + ": is a pipe or a device; save it as a file first\n");
  }

  @ParameterizedTest
  @ValueSource(strings = {"--initial", "--commands"})
  void aFileBesideTheRecordingThatIsAPipeIsRefusedWithoutWaiting(String option) throws Exception {
    Ended ended = run("calibrate", LOG.toString(), option, pipe.toString());
    assertThat(ended.status()).isEqualTo(1);
    assertThat(ended.err())
        .isEqualTo("fieldcal: " + pipe + ": is a pipe or a device; save it as a file first\n");
  }

  @Test
  void aResultThatIsALinkToItselfIsAnErrorInOneLine() throws Exception {
    Path link = Files.createSymbolicLink(folder.resolve("self.json"), Path.of("self.json"));
    Ended ended = run("calibrate", LOG.toString(), "--json", link.toString());
    assertThat(ended.status()).isEqualTo(1);
    assertThat(ended.err())
        .isEqualTo(
            "fieldcal: " + link + ": is a symbolic link that leads to itself; name a file\n");
    assertThat(link).isSymbolicLink();
  }

  @ParameterizedTest
  @ValueSource(strings = {"info", "monitor --log"})
  void aTeamsNameDoesNotSteerTheTerminal(String command) throws Exception {
    Path log = folder.resolve("named.log");
    try (GameLogReader reader = GameLogReader.open(LOG.resolveSibling("grsim-flat.log.gz"));
        GameLogWriter writer = GameLogWriter.create(log)) {
      boolean told = false;
      while (reader.next()) {
        if (!told) {
          byte[] referee = referee("Team\u001b]0;owned\u0007\u001b[2J\nfieldcal: all is well");
          writer.write(reader.receivedNanos(), MessageType.SSL_REFBOX_2013, referee);
          told = true;
        }
        writer.write(
            reader.receivedNanos(),
            reader.type().code(),
            reader.buffer(),
            reader.payloadOffset(),
            reader.payloadLength());
      }
    }
    Ended ended = run((command + " " + log).split(" "));
    assertThat(ended.status()).as(ended.err()).isZero();
    assertThat(ended.out()).contains("Team␛]0;owned␇␛[2J").doesNotContain("\u001b", "\u0007");
    assertThat(ended.out().lines()).noneMatch(line -> line.startsWith("fieldcal"));
  }

  private static byte[] referee(String name) {
    Referee.TeamInfo team =
        Referee.TeamInfo.newBuilder()
            .setName(name)
            .setScore(0)
            .setRedCards(0)
            .setYellowCards(0)
            .setTimeouts(0)
            .setTimeoutTime(0)
            .setGoalkeeper(0)
            .build();
    return Referee.newBuilder()
        .setPacketTimestamp(1_763_712_345_000_000L)
        .setStage(Referee.Stage.NORMAL_FIRST_HALF)
        .setCommand(Referee.Command.FORCE_START)
        .setCommandCounter(1)
        .setCommandTimestamp(1_763_712_345_000_000L)
        .setYellow(team)
        .setBlue(team)
        .build()
        .toByteArray();
  }

  @Test
  void aRecordingThatIsAnEndlessDeviceIsRefused() throws Exception {
    Ended ended = run("calibrate", "/dev/zero");
    assertThat(ended.status()).isEqualTo(1);
    assertThat(ended.err()).contains("/dev/zero").contains("is a pipe or a device");
  }

  @Test
  void aNameWithALineEndPrintsNoLineOfItsOwn() throws Exception {
    String name = "a\nfieldcal: all is well.log.gz";
    Ended missing = run("info", folder.resolve(name).toString());
    assertThat(missing.err().lines()).hasSize(1);
    Path log = Files.copy(LOG.resolveSibling("grsim-flat.log.gz"), folder.resolve(name));
    assertThat(run("info", log.toString()).out().lines()).noneMatch(l -> l.startsWith("fieldcal"));
    assertThat(run("calibrate", log.toString(), "--out", folder.resolve("o").toString()).out())
        .doesNotContain("\nfieldcal");
  }

  @Test
  void theLanguageOfTheMachineChangesNoNumber() throws Exception {
    // Its first frames come before the geometry, which is told with numbers.
    String log = LOG.resolveSibling("grsim-flat.log.gz").toString();
    String expected = run("info", log).out();
    List<String> command = command("info", log);
    command.addAll(1, List.of("-Duser.language=fa", "-Duser.country=IR"));
    Path out = folder.resolve("persian.txt");
    Process process = new ProcessBuilder(command).redirectOutput(out.toFile()).start();
    try {
      assertThat(process.waitFor(LONGEST_S, TimeUnit.SECONDS)).as("%s ends", command).isTrue();
    } finally {
      process.destroyForcibly();
    }
    assertThat(expected).contains("116 × a frame comes before the first geometry");
    assertThat(Files.readString(out)).isEqualTo(expected);
  }

  @Test
  void jsonGoesToStandardOutputAlsoWhereThatIsAFile() throws Exception {
    Ended ended = run("calibrate", LOG.toString(), "--json", "/dev/stdout");
    assertThat(ended.status()).as(ended.err()).isZero();
    int begin = ended.out().indexOf('{');
    assertThat(new ObjectMapper().readTree(ended.out().substring(begin)).path("schema").asText())
        .isEqualTo("fieldcal.calibration/1");
    assertThat(ended.out().substring(begin)).contains("\n}");
  }

  @Test
  void whatAMonitorWritesAndPrintsDoesNotOverwriteEachOther() throws Exception {
    Ended ended = run("monitor", "--log", LOG.toString(), "--json", "/dev/stdout");
    assertThat(ended.status()).as(ended.err()).isZero();
    List<String> json = ended.out().lines().filter(line -> line.startsWith("{")).toList();
    assertThat(json.get(0)).contains("\"event\":\"start\"");
    assertThat(json.get(json.size() - 1)).contains("\"event\":\"summary\"");
    for (String line : json) {
      new ObjectMapper().readTree(line);
    }
  }

  @Test
  void aFullDeviceBehindTheOutputIsAnError() throws Exception {
    Ended ended = run(new File("/dev/full"), "info", LOG.toString());
    assertThat(ended.status()).isEqualTo(1);
    assertThat(ended.err()).startsWith("fieldcal: standard output: cannot be written (");
  }

  @Test
  void aReaderThatHasEnoughIsNoError() throws Exception {
    endsQuietlyUnread("info", LOG.toString());
  }

  /** Otherwise {@code monitor … | head} would watch a network for nobody until the end of days. */
  @Test
  void aMonitorEndsWhenNobodyReadsIt() throws Exception {
    endsQuietlyUnread("monitor", "--log", LOG.toString(), "--speed", "0.1");
  }

  private void endsQuietlyUnread(String... arguments) throws Exception {
    Process process =
        new ProcessBuilder(command(arguments))
            .redirectError(folder.resolve("err.txt").toFile())
            .start();
    try {
      process.getInputStream().close();
      assertThat(process.waitFor(LONGEST_S, TimeUnit.SECONDS)).isTrue();
    } finally {
      process.destroyForcibly();
    }
    assertThat(folder.resolve("err.txt")).isEmptyFile();
    assertThat(process.exitValue()).isZero();
  }

  @Test
  void aFullDeviceForTheResultIsAnErrorThatNamesIt() throws Exception {
    Ended ended = run("calibrate", LOG.toString(), "--json", "/dev/full");
    assertThat(ended.status()).isEqualTo(1);
    assertThat(ended.err()).startsWith("fieldcal: /dev/full: ");
    assertThat(Files.isRegularFile(Path.of("/dev/full"))).isFalse();
  }

  @Test
  void resultsBehindALinkReplaceItsTarget() throws Exception {
    Path target = Files.createDirectory(folder.resolve("elsewhere")).resolve("result.json");
    Files.writeString(target, "old", StandardCharsets.UTF_8);
    Path link = Files.createSymbolicLink(folder.resolve("link.json"), target);
    assertThat(run("calibrate", LOG.toString(), "--json", link.toString()).status()).isZero();
    assertThat(link).isSymbolicLink();
    assertThat(Files.readString(target)).contains("fieldcal.calibration/1");
  }

  /** A name that is mistyped would be an empty session. */
  @Test
  void aConsoleOfNoDirectoryIsAnError() throws Exception {
    Path typo = folder.resolve("sesion");
    File out = folder.resolve("console.txt").toFile();
    Ended ended = run(out, "console", typo.toString(), "--port=0");
    assertThat(ended.status()).isEqualTo(1);
    assertThat(ended.err().lines())
        .containsExactly(
            "fieldcal: "
                + typo
                + ": no such directory; for a new session, make an empty one first");
    assertThat(typo).doesNotExist();
  }
}
