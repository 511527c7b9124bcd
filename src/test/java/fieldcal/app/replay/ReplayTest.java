package fieldcal.app.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.cli.Main;
import fieldcal.app.replay.McapReader.Message;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** {@code calibrate --csv} and {@code --mcap}: what is in the files is what is in {@code calibration.json}. */
class ReplayTest {
  /** CSV cells, quoted or not. */
  private static final Pattern CELL =
      Pattern.compile("\"((?:[^\"]|\"\")*)\"(?:,|$)|([^,]*)(?:,|$)");

  @TempDir private static Path shared;

  private static Path log;
  private static JsonNode json;
  private static List<Map<String, String>> kicks;
  private static List<Map<String, String>> observations;
  private static McapReader mcap;

  @BeforeAll
  static void calibrate() throws Exception {
    // A name that CSV must quote.
    log = shared.resolve("a, \"b\".log.gz");
    run("simulate", "--scenario=mixed", "--kicks=4", "--seed=5", "--out=" + log);
    export("one");
    json = new ObjectMapper().readTree(shared.resolve("one/calibration.json").toFile());
    kicks = table(shared.resolve("one/kicks.csv"));
    observations = table(shared.resolve("one/observations.csv"));
    mcap = new McapReader(Files.readAllBytes(shared.resolve("one/kicks.mcap")));
  }

  private static void export(String name) {
    Path out = shared.resolve(name);
    run(
        "calibrate",
        log.toString(),
        "--csv=" + out,
        "--mcap=" + out.resolve("kicks.mcap"),
        "--json=" + out.resolve("calibration.json"));
  }

  private static void run(String... args) {
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(new StringWriter()));
    commands.setErr(new PrintWriter(err));
    assertThat(commands.execute(args)).as(err.toString()).isZero();
  }

  private static List<Map<String, String>> table(Path file) throws IOException {
    List<Map<String, String>> rows = new ArrayList<>();
    List<String> header = null;
    for (String line : Files.readAllLines(file)) {
      List<String> cells = new ArrayList<>();
      Matcher m = CELL.matcher(line + ",");
      while (m.find() && m.end() <= line.length() + 1 && m.start() < line.length() + 1) {
        cells.add(m.group(1) != null ? m.group(1).replace("\"\"", "\"") : m.group(2));
      }
      if (header == null) {
        header = cells;
        continue;
      }
      assertThat(cells).hasSameSizeAs(header);
      Map<String, String> row = new LinkedHashMap<>();
      for (int i = 0; i < cells.size(); i++) {
        row.put(header.get(i), cells.get(i));
      }
      rows.add(row);
    }
    return rows;
  }

  private static double number(Map<String, String> row, String column) {
    return Double.parseDouble(row.get(column));
  }

  @Test
  void everyKickIsARowWithTheExactNumbers() {
    assertThat(kicks).hasSize(json.get("kicks").size()).hasSize(4);
    for (int i = 0; i < kicks.size(); i++) {
      Map<String, String> row = kicks.get(i);
      JsonNode kick = json.get("kicks").get(i);
      assertThat(row.get("kick")).isEqualTo(kick.get("id").asText());
      assertThat(row.get("kind")).isEqualTo(kick.get("kind").asText());
      assertThat(row.get("source")).isEqualTo(log.toString());
      assertThat(number(row, "rms_mm")).isEqualTo(kick.get("rms_mm").doubleValue());
      assertThat(number(row, "x_m")).isEqualTo(kick.at("/kick_position/0").doubleValue());
      assertThat(number(row, "vy_mps")).isEqualTo(kick.at("/kick_velocity/1").doubleValue());
      assertThat(row.get("selected")).isEqualTo(kick.get("selected").asBoolean() ? "1" : "0");
      assertThat(number(row, "t_unix")).isCloseTo(kick.get("t").asDouble(), within(0.02));
      kick.get("parameters")
          .properties()
          .forEach(p -> assertThat(number(row, p.getKey())).isEqualTo(p.getValue().doubleValue()));
    }
  }

  @Test
  void everyObservationIsARowAndTheResidualsAddUp() {
    for (int i = 0; i < kicks.size(); i++) {
      String id = kicks.get(i).get("kick");
      List<Map<String, String>> seen =
          observations.stream().filter(o -> o.get("kick").equals(id)).toList();
      assertThat(seen).hasSize(Integer.parseInt(kicks.get(i).get("observations")));
      double squares = 0;
      int used = 0;
      for (Map<String, String> o : seen) {
        if (o.get("used").equals("1")) {
          squares += Math.pow(number(o, "residual_x_mm"), 2);
          squares += Math.pow(number(o, "residual_y_mm"), 2);
          used++;
        }
      }
      assertThat(used).isEqualTo(Integer.parseInt(kicks.get(i).get("used_observations")));
      assertThat(Math.sqrt(squares / (2 * used)))
          .isCloseTo(number(kicks.get(i), "rms_mm"), within(1e-9));
    }
    List<Double> times = observations.stream().map(o -> number(o, "t_unix")).toList();
    assertThat(times).isSorted();
  }

  @Test
  void onTheGroundTheResidualIsSeenMinusPath() {
    assertThat(observations)
        .filteredOn(o -> number(o, "path_z_m") == 0)
        .isNotEmpty()
        .allSatisfy(
            o ->
                assertThat(number(o, "x_m") - number(o, "offset_x_m") - number(o, "path_x_m"))
                    .isCloseTo(number(o, "residual_x_mm") / 1000, within(1e-9)));
  }

  @Test
  void theSameCalibrationGivesTheSameBytes() throws IOException {
    export("two");
    for (String name : List.of("kicks.csv", "observations.csv", "kicks.mcap")) {
      assertThat(shared.resolve("two").resolve(name))
          .hasSameBinaryContentAs(shared.resolve("one").resolve(name));
    }
  }

  private static List<Message> topic(String name) {
    return mcap.messages.stream().filter(m -> m.topic().equals(name)).toList();
  }

  @Test
  void anotherReaderUnderstandsTheReplay() {
    assertThat(mcap.topics.values())
        .containsExactly("/vision", "/kick", "/path", "/residual", "/scene");
    assertThat(mcap.countInStatistics).isEqualTo(mcap.messages.size());
    assertThat(mcap.indexed).isEqualTo(mcap.messages.size());
    assertThat(topic("/kick")).hasSize(4);
    assertThat(topic("/residual")).hasSameSizeAs(observations);
    assertThat(topic("/scene")).hasSize(observations.size() + 4);
  }

  @Test
  void residualsAreThoseOfTheTable() {
    List<Message> residuals = topic("/residual");
    for (int i = 0; i < residuals.size(); i++) {
      Message m = residuals.get(i);
      Map<String, String> row = observations.get(i);
      assertThat(m.number("residual_x_mm")).isEqualTo(number(row, "residual_x_mm"));
      assertThat(m.number("camera")).isEqualTo(number(row, "camera"));
      assertThat(m.logTime() / 1e9).isCloseTo(number(row, "t_unix"), within(1e-6));
    }
  }

  /** Frames are vision's own bytes: each detection that was used is in a frame of that time and camera. */
  @Test
  void theFramesOfEveryKickAreThere() {
    Map<Long, List<Message>> frames =
        topic("/vision").stream().collect(Collectors.groupingBy(m -> m.logTime() / 1000));
    int found = 0;
    for (Map<String, String> o : observations) {
      long micros = Math.round(number(o, "t_unix") * 1e6);
      for (long at = micros - 1; at <= micros + 1; at++) {
        if (frames.containsKey(at)) {
          found++;
          break;
        }
      }
    }
    assertThat(found).isEqualTo(observations.size());
    assertThat(topic("/vision").stream().filter(m -> m.content().toString().contains("geometry")))
        .as("a field to draw on")
        .hasSizeGreaterThanOrEqualTo(4);
  }

  @Test
  void messagesComeInTheOrderOfTimeUpToTheCamerasDelays() {
    long latest = 0;
    for (Message m : mcap.messages) {
      assertThat(m.logTime()).isGreaterThan(latest - 50_000_000);
      latest = Math.max(latest, m.logTime());
    }
  }

  @Test
  void thePathBeginsAtTheKick() {
    Message kick = topic("/kick").get(0);
    Message first = topic("/path").get(0);
    assertThat(first.number("x_m")).isEqualTo(kick.number("x_m"));
    assertThat(first.number("t_s")).isZero();
    assertThat(first.logTime()).isEqualTo(kick.logTime());
  }
}
