package fieldcal.kick;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The recordings of test-data against their truth files: every kick found, none invented, when, by whom, and how it ended. */
class RecordedKicksTest {
  private static final Path DATA =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  private record Truth(double unixTime, RobotId robot, double x, double y, String end) {}

  private record Found(List<Kick> kicks, Epoch epoch) {}

  private static Found find(Path log) throws IOException {
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    try (RecordingReader reader = RecordingReader.open(log)) {
      reader.read(
          new RecordingListener() {
            @Override
            public void onFrame(VisionFrame frame, double receivedTime) {
              finder.accept(frame);
            }

            @Override
            public void onGeometry(FieldGeometry geometry) {
              Map<Integer, Camera> cameras = new HashMap<>();
              for (CameraCalibration c : geometry.cameras()) {
                cameras.put(c.id(), Camera.of(c));
              }
              finder.geometry(geometry, cameras);
            }
          });
      finder.finish();
      return new Found(kicks, reader.epoch());
    }
  }

  private static List<Truth> truth(String name) throws IOException {
    List<Truth> truth = new ArrayList<>();
    Path json = DATA.resolve(name + ".truth.json");
    if (Files.exists(json)) {
      for (JsonNode k : new ObjectMapper().readTree(json.toFile()).get("kicks")) {
        JsonNode robot = k.get("robot");
        truth.add(
            new Truth(
                k.get("t0_unix").doubleValue(),
                robot(robot.get("team").textValue(), robot.get("id").intValue()),
                k.get("pos_mm").get(0).doubleValue() / 1000,
                k.get("pos_mm").get(1).doubleValue() / 1000,
                k.get("end_reason").textValue()));
      }
      return truth;
    }
    List<String> lines = Files.readAllLines(DATA.resolve(name + ".kicks.csv"));
    List<String> columns = List.of(lines.get(0).split(","));
    for (String line : lines.subList(1, lines.size())) {
      String[] f = line.split(",");
      String end = f[columns.indexOf("end_reason")];
      // This source calls a ball that comes to rest just behind the line not left.
      boolean outside =
          Math.abs(Double.parseDouble(f[columns.indexOf("end_x")])) > 6.0215
              || Math.abs(Double.parseDouble(f[columns.indexOf("end_y")])) > 4.5215;
      truth.add(
          new Truth(
              Double.parseDouble(f[columns.indexOf("t_kick_true")]),
              robot(f[columns.indexOf("team")], Integer.parseInt(f[columns.indexOf("robot_id")])),
              Double.parseDouble(f[columns.indexOf("kick_x")]),
              Double.parseDouble(f[columns.indexOf("kick_y")]),
              end.equals("rest") && !outside ? "stopped" : "left_field"));
    }
    return truth;
  }

  private static RobotId robot(String team, int id) {
    return new RobotId(Team.valueOf(team.toUpperCase(Locale.ROOT)), id);
  }

  @ParameterizedTest
  @CsvSource({
    "erforce-flat, 28, 2",
    "erforce-chip, 32, 0",
    "world-null-flat, 24, 1",
    "world-null-chip, 24, 0"
  })
  void everyKickIsFoundAndNoneInvented(String name, int count, int moved) throws IOException {
    List<Truth> truth = truth(name);
    Found found = find(DATA.resolve(name + ".log.gz"));
    List<Kick> kicks =
        found.kicks().stream().sorted((a, b) -> Double.compare(a.time(), b.time())).toList();
    assertThat(truth).hasSize(count);
    assertThat(kicks).hasSize(count);
    double[] late = new double[count];
    for (int i = 0; i < count; i++) {
      late[i] = found.epoch().unixSeconds(kicks.get(i).time()) - truth.get(i).unixTime();
    }
    // Some sources stamp their frames with a constant delay.
    double median = java.util.Arrays.stream(late).sorted().toArray()[count / 2];
    assertThat(Math.abs(median)).isLessThan(0.05);
    Map<String, Integer> ends = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      Kick kick = kicks.get(i);
      assertThat(late[i] - median).as("kick %d", i).isEqualTo(0, within(0.015));
      assertThat(kick.robot()).as("kick %d", i).contains(truth.get(i).robot());
      // The cameras of one source disagree by 40 mm.
      assertThat(kick.x()).as("kick %d", i).isEqualTo(truth.get(i).x(), within(0.045));
      assertThat(kick.y()).as("kick %d", i).isEqualTo(truth.get(i).y(), within(0.045));
      ends.merge(truth.get(i).end() + " is called " + kick.end().id(), 1, Integer::sum);
    }
    // Two were pushed by 4 and 8 mm before; one was not seen for the last 54 ms.
    assertThat(kicks.stream().filter(k -> !k.fromRest())).hasSize(moved);
    int wrong =
        ends.entrySet().stream()
            .filter(e -> !e.getKey().matches("(\\w+) is called \\1"))
            .mapToInt(Map.Entry::getValue)
            .sum();
    assertThat(wrong).as("%s", ends).isZero();
  }
}
