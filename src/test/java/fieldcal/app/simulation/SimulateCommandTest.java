package fieldcal.app.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.cli.Main;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The command's files, read back, and its answers to wrong input. */
class SimulateCommandTest {
  @TempDir private Path directory;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    List<String> all = new ArrayList<>(List.of("simulate"));
    all.addAll(List.of(args));
    return Main.commandLine()
        .setOut(new PrintWriter(out))
        .setErr(new PrintWriter(err))
        .execute(all.toArray(String[]::new));
  }

  /** What the system lets a program write into a file is bounded: every write beyond fails, as on a full disk. */
  @Test
  void aFullDiskLeavesNothingOfTheNewRecordingAndAllOfTheOldOne() throws Exception {
    Path prlimit = Path.of("/usr/bin/prlimit");
    assumeTrue(Files.isExecutable(prlimit), "prlimit of util-linux limits a process");
    assertThat(
            run("--scenario=flat", "--kicks=1", "--clean", "--out=" + directory.resolve("a.log")))
        .as(err.toString())
        .isZero();
    Map<String, byte[]> before = contents();
    // Larger than the old log's neighbours, smaller than any log; then smaller than all.
    for (int room : new int[] {1 << 16, 1 << 8}) {
      Process process =
          new ProcessBuilder(
                  prlimit.toString(),
                  "--fsize=" + room,
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-XX:-UsePerfData",
                  "-cp",
                  System.getProperty("java.class.path"),
                  "fieldcal.app.cli.Main",
                  "simulate",
                  "--scenario=flat",
                  "--kicks=3",
                  "--out=" + directory.resolve("a.log"))
              .redirectErrorStream(true)
              .start();
      String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertThat(process.waitFor()).as(said).isEqualTo(1);
      assertThat(said.strip().lines()).hasSize(1);
      assertThat(said).contains("a.log: ").contains("too large").doesNotContain("defect");
      assertThat(contents()).as("room for %d bytes", room).containsExactlyEntriesOf(before);
    }
  }

  private Map<String, byte[]> contents() throws IOException {
    Map<String, byte[]> contents = new TreeMap<>();
    try (Stream<Path> files = Files.list(directory)) {
      for (Path file : files.toList()) {
        contents.put(file.getFileName().toString(), Files.readAllBytes(file));
      }
    }
    return contents;
  }

  @Test
  void writesALogThatReadsBackWithTruthAndCommands() throws IOException {
    Path log = directory.resolve("drag.log.gz");
    int exit =
        run(
            "--scenario=flat",
            "--kicks=3",
            "--seed=5",
            "--effect=air_drag:cd=0.45",
            "--effect=worn_region:change=0.2,region=[0,6,-4.5,4.5]",
            "--out=" + log);
    assertThat(exit).as(err.toString()).isZero();
    assertThat(out.toString()).contains("seed 5").contains("3 kicks").contains("air_drag:cd=0.45");

    JsonNode truth = new ObjectMapper().readTree(directory.resolve("drag.truth.json").toFile());
    assertThat(truth.get("effects").get("air_drag").get("cd").doubleValue()).isEqualTo(0.45);
    assertThat(truth.get("kicks")).hasSize(3);
    List<String> commands = Files.readAllLines(directory.resolve("drag.commands.csv"));
    assertThat(commands).hasSize(4);
    assertThat(commands.get(0))
        .isEqualTo("t_unix,team,id,kind,speed_mps,direction_deg,elevation_deg");
    assertThat(Double.parseDouble(commands.get(1).split(",")[0]))
        .isEqualTo(truth.get("kicks").get(0).get("t0_unix").doubleValue(), within(1e-3));

    List<VisionPacket> packets = packets(log, (long) truth.get("unix_base").doubleValue());
    long frames = packets.stream().filter(p -> p.frame().isPresent()).count();
    long expected = 0;
    for (JsonNode count : truth.get("vision").get("frames")) {
      expected += count.longValue();
    }
    assertThat(frames).isEqualTo(expected);
    long geometries = packets.stream().filter(p -> p.geometry().isPresent()).count();
    assertThat(geometries).isEqualTo((long) Math.ceil(truth.get("duration").doubleValue()));
    assertThat(packets.get(0).geometry().orElseThrow().cameras()).hasSize(4);
    assertThat(packets.get(0).geometry().orElseThrow().flat()).isPresent();
  }

  private static List<VisionPacket> packets(Path log, long unixBase) throws IOException {
    VisionDecoder decoder = new VisionDecoder(Epoch.atSecondOf((double) unixBase));
    List<VisionPacket> packets = new ArrayList<>();
    try (GameLogReader reader = GameLogReader.open(log)) {
      assertThat(reader.next()).isTrue();
      assertThat(RecordingOrigin.isSimulationMark(reader)).as("says what it is").isTrue();
      while (reader.next()) {
        assertThat(reader.type()).isEqualTo(MessageType.SSL_VISION_2014);
        packets.add(
            decoder.decode(reader.buffer(), reader.payloadOffset(), reader.payloadLength()));
      }
    }
    return packets;
  }

  @Test
  void theSameSeedGivesTheSameFiles() throws IOException {
    for (String name : List.of("a", "b")) {
      int exit =
          run("--scenario=chip", "--kicks=2", "--out=" + directory.resolve(name + ".log.gz"));
      assertThat(exit).isZero();
    }
    for (String ending : List.of(".log.gz", ".truth.json", ".commands.csv")) {
      assertThat(directory.resolve("a" + ending))
          .hasSameBinaryContentAs(directory.resolve("b" + ending));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--effect=air_drak:cd=1 | unknown effect 'air_drak'; known are air_drag, magnus",
        "--effect=air_drag:cx=1 | air_drag has no parameter 'cx'; it has cd",
        "--effect=air_drag:cd=many | air_drag: cd must be a number, but is 'many'",
        "--effect=air_drag:cd=NaN | air_drag: cd must lie in",
        "--effect=air_drag | air_drag needs a value, for example air_drag:cd=",
        "--effect=camera_offset:x_mm=20,camera=4 | there are only 4 cameras",
        "--effect=worn_region:change=1,region=[0,1] | must be [x0,x1,y0,y1]",
        "--effect=robot_kick_bias:percent=5,team=green | must be yellow, blue or all",
        "--scenario=tennis | unknown scenario 'tennis'",
        "--preset=moon | unknown preset 'moon'; known are lab",
        "--cameras=9 | fieldcal: --cameras must be 1 to 8, but is 9",
        "--kicks=0 | --kicks must be 1 or more, but is 0",
        "--scenario=match --kicks=0 | --kicks must be 1 or more, but is 0",
        "--noise-mm=-1 | --noise-mm must be 0 to 100 mm, but is -1",
        "--speed-min=4 --speed-max=2 | --speed-max must be 4 to 10 m/s, but is 2",
        "--division=C | --division must be A or B",
        "--flat-model=1,2 | takes three numbers",
        "--blue-limits=1,-2,3 | --blue-limits must be a positive number, but is -2",
        "--outage=1:x:3 | --outage must be CAMERA:FROM:SECONDS"
      })
  void wrongInputIsNamed(String argument, String message) {
    List<String> args = new ArrayList<>(List.of("--out=" + directory.resolve("x.log")));
    if (!argument.startsWith("--scenario")) {
      args.add("--scenario=flat");
    }
    args.addAll(List.of(argument.trim().split(" ")));
    assertThat(run(args.toArray(String[]::new))).isEqualTo(2);
    assertThat(err.toString()).contains(message.trim());
    assertThat(directory).isEmptyDirectory();
  }

  /** As in the first table of the documents: every scenario takes a number of kicks. */
  @Test
  void aMatchHasAsManyKicksAsAreOrdered() throws IOException {
    Path log = directory.resolve("match.log");
    assertThat(run("--scenario", "match", "--kicks", "4", "--seed", "2", "--out=" + log))
        .as(err.toString())
        .isZero();
    assertThat(out.toString()).contains(" s, 4 kicks, ").doesNotContain("over before");
    JsonNode truth = new ObjectMapper().readTree(directory.resolve("match.truth.json").toFile());
    int commanded = 0;
    for (JsonNode kick : truth.get("kicks")) {
      commanded += kick.get("kind").textValue().equals("deflection") ? 0 : 1;
    }
    assertThat(commanded).isEqualTo(4);
    assertThat(Files.readAllLines(directory.resolve("match.commands.csv"))).hasSize(1 + 4);
  }

  @Test
  void aMatchWhoseTimeIsUpBeforeItsKicksSaysSo() {
    Path log = directory.resolve("match.log");
    assertThat(run("--scenario=match", "--kicks=500", "--minutes=0.5", "--out=" + log))
        .as(err.toString())
        .isZero();
    assertThat(out.toString()).contains("the 0.5 minutes were over before 500 kicks were played");
  }

  @Test
  void aFileThatCannotBeWrittenIsNamed() throws IOException {
    Path file = Files.createFile(directory.resolve("file"));
    Path log = file.resolve("x.log.gz");
    assertThat(run("--scenario=flat", "--kicks=1", "--out=" + log)).isEqualTo(1);
    assertThat(err.toString()).contains(file.toString());
  }

  @ParameterizedTest
  @CsvSource({"lab", "german-open-2026", "robocup-2026"})
  void presetsRun(String preset) {
    Path log = directory.resolve(preset + ".log");
    assertThat(run("--scenario=mixed", "--kicks=2", "--preset=" + preset, "--out=" + log))
        .as(err.toString())
        .isZero();
  }
}
