package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.camera.CameraCalibration;
import fieldcal.camera.ChangedCalibration;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A camera whose geometry, or a part of it, cannot be used is named by every command that looks at cameras: in one line, once. */
class UnusableCamerasTest {
  /** One that sees the ball often. */
  private static final int CAMERA = 1;

  @TempDir private static Path folder;

  private static Path sound;

  /** What is published of the camera. */
  private enum Broken {
    FOLDED_LENS("does not see", c -> ChangedCalibration.withDistortion(c, -0.5)),
    POSITION_IN_SPACE("too far", c -> ChangedCalibration.withWorldX(c, 1e35)),
    POSITION_OUTSIDE("too far", c -> ChangedCalibration.withWorldX(c, 200)),
    HANGS_TOO_HIGH("no usable position", c -> ChangedCalibration.withHeight(c, 200)),
    HANGS_IN_SPACE("no usable position", c -> ChangedCalibration.withHeight(c, 1e35));

    private final String reason;
    private final UnaryOperator<CameraCalibration> change;

    Broken(String reason, UnaryOperator<CameraCalibration> change) {
      this.reason = reason;
      this.change = change;
    }
  }

  @BeforeAll
  static void simulate() {
    sound = folder.resolve("sound.log");
    Told.by("simulate", "--scenario=mixed", "--kicks=6", "--seed=3", "--out=" + sound);
  }

  private static Path recording(Broken broken) throws IOException {
    Path log = folder.resolve(broken + ".log");
    return Files.exists(log)
        ? log
        : EditedLog.copy(
            sound, log, p -> new VisionPacket(p.frame(), p.geometry().map(g -> broken(g, broken))));
  }

  private static FieldGeometry broken(FieldGeometry geometry, Broken broken) {
    return geometry.withCameras(
        geometry.cameras().stream()
            .map(c -> c.id() == CAMERA ? broken.change.apply(c) : c)
            .toList());
  }

  private static void namedOnce(Broken broken, String out, String name) {
    // Lines that a terminal would break are continued with four spaces.
    List<String> lines =
        out.replaceAll("\n {4}(?! )", " ")
            .lines()
            .filter(line -> line.contains(broken.reason))
            .toList();
    assertThat(lines).as(out).singleElement().asString().contains(name).hasSizeLessThan(400);
  }

  @ParameterizedTest
  @EnumSource
  void infoNamesIt(Broken broken) throws IOException {
    namedOnce(broken, Told.by("info", "" + recording(broken)), "       " + CAMERA + "  ");
    JsonNode info = new ObjectMapper().readTree(Told.by("info", "--json", "" + recording(broken)));
    assertThat(info.at("/geometry/cameras/" + CAMERA + "/note").asText()).contains(broken.reason);
  }

  @ParameterizedTest
  @EnumSource
  void calibrateNamesIt(Broken broken) throws IOException {
    namedOnce(broken, Told.by("calibrate", "" + recording(broken)), ", camera " + CAMERA + ": ");
  }

  @ParameterizedTest
  @EnumSource
  void diagnoseNamesIt(Broken broken) throws IOException {
    namedOnce(broken, Told.by("diagnose", "" + recording(broken)), ", camera " + CAMERA + ": ");
  }

  @ParameterizedTest
  @EnumSource
  void monitorNamesIt(Broken broken) throws IOException {
    Path changes = folder.resolve("changes.json");
    String out = Told.by("monitor", "--log", "" + recording(broken), "--json", "" + changes);
    namedOnce(broken, out, "camera " + CAMERA + ": ");
    List<String> lines = Files.readAllLines(changes);
    JsonNode fault =
        new ObjectMapper().readTree(lines.get(lines.size() - 1)).at("/camera_faults/0");
    assertThat(fault.path("camera").asInt()).isEqualTo(CAMERA);
    assertThat(fault.path("reason").asText()).contains(broken.reason);
  }

  @Test
  void soundCamerasAreNotNamed() {
    for (String command : List.of("info", "calibrate", "diagnose", "monitor --log")) {
      String[] words =
          Stream.concat(Stream.of(command.split(" ")), Stream.of("" + sound))
              .toArray(String[]::new);
      assertThat(Told.by(words)).doesNotContain("does not see", "too far", "no usable", "SILENT");
    }
  }
}
