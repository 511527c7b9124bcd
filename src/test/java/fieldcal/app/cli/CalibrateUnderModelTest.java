package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.google.protobuf.TextFormat;
import fieldcal.app.calibrate.InitialModels;
import fieldcal.proto.SSL_GeometryModels;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code calibrate --model}: what of an extended model the league's message has no field for is said wherever the numbers are. */
class CalibrateUnderModelTest {
  private static final String MODEL =
      """
      {"schema": "fieldcal.extended_model/1",
       "flat": {"acc_slide": -3.1, "acc_roll": -0.28, "k_switch": 0.7},
       "effects": [{"effect": "air_drag", "parameters": {"cd": 0.45}},
                   {"effect": "drift", "parameters": {"percent_per_10min": 0.5}},
                   {"effect": "camera_time_offset", "parameters": {"ms": 3, "camera": 17}}],
       "session_start_unix": 1600000000}
      """;

  @TempDir private static Path folder;

  private static Path log;
  private static Path out;
  private static Answer answer;

  private record Answer(int exit, String out, String err) {}

  @BeforeAll
  static void calibrate() throws IOException {
    log = folder.resolve("drag.log.gz");
    String[] simulate = {
      "simulate",
      "--scenario=flat",
      "--kicks=6",
      "--physics=contact",
      "--effect=air_drag:cd=0.45",
      "--seed=2",
      "--out=" + log
    };
    assertThat(run(simulate).exit()).isZero();
    Path model = Files.writeString(folder.resolve("extended_model.json"), MODEL);
    out = folder.resolve("out");
    answer = run("calibrate", log.toString(), "--model=" + model, "--out=" + out);
    assertThat(answer.exit()).as(answer.toString()).isZero();
    assertThat(answer.err()).isEmpty();
  }

  private static Answer run(String... args) {
    StringWriter text = new StringWriter();
    StringWriter err = new StringWriter();
    int exit =
        Main.commandLine().setOut(new PrintWriter(text)).setErr(new PrintWriter(err)).execute(args);
    return new Answer(exit, text.toString(), err.toString());
  }

  @Test
  void theTextFormSaysItInCommentsThatEveryReaderSkips() throws IOException {
    Path file = out.resolve("geometry_models.txt");
    String text = Files.readString(file);
    assertThat(text)
        .startsWith("# ")
        .contains("#   air drag (cd 0.45)")
        .contains("calibrate without --model");
    // Protobuf's own reader, and ours.
    SSL_GeometryModels.Builder message = SSL_GeometryModels.newBuilder();
    TextFormat.merge(text, message);
    assertThat(message.getStraightTwoPhase().getAccSlide()).isNegative();
    assertThat(InitialModels.read(file))
        .isEqualTo(InitialModels.read(out.resolve("geometry_models.pb")));
  }

  @Test
  void theJsonNamesWhatIsNotInTheMessage() throws IOException {
    JsonNode model =
        new ObjectMapper().readTree(out.resolve("calibration.json").toFile()).get("extended_model");
    assertThat(model.get("not_in_message").toString())
        .isEqualTo("[\"air_drag\",\"drift\",\"camera_time_offset\"]");
    assertThat(model.get("effects").get(0).get("parameters").get("cd").doubleValue())
        .isEqualTo(0.45);
    // Not the begin in the model's file, which is another recording's.
    assertThat(model.get("session_start_unix").doubleValue()).isGreaterThan(1_600_000_100);
    assertThat(model.get("settled").booleanValue()).isTrue();
    assertThat(model.get("rounds").intValue()).isPositive();
  }

  @Test
  void theTerminalAndTheReportSayIt() throws IOException {
    String report = Files.readString(out.resolve("report.html"));
    for (String where : new String[] {answer.out(), report}) {
      assertThat(where.replaceAll("\\s+", " "))
          .contains(
              "message carries the parameters, but not the effects they are valid with: air drag")
          .contains("no such camera")
          .contains(
              "These effects depend on the time, which is counted from the beginning of these"
                  + " recordings: carpet that changes");
    }
  }

  @Test
  void withoutAModelNothingIsSaidOfIt() throws IOException {
    Path plain = folder.resolve("plain");
    Answer simple = run("calibrate", log.toString(), "--out=" + plain);
    assertThat(simple.out()).doesNotContain("valid with");
    assertThat(Files.readString(plain.resolve("geometry_models.txt")))
        .contains("straight")
        .doesNotContain("effects");
    assertThat(Files.readString(plain.resolve("calibration.json")))
        .doesNotContain("extended_model");
  }

  @Test
  void aBadModelIsOneLineBeforeAnythingIsRead() throws IOException {
    Path bad =
        Files.writeString(folder.resolve("bad.json"), MODEL.replace("air_drag", "air_brake"));
    Answer wrong = run("calibrate", folder.resolve("no.log").toString(), "--model=" + bad);
    assertThat(wrong.exit()).isEqualTo(1);
    assertThat(wrong.err().strip())
        .isEqualTo(
            "fieldcal: " + bad + ", field effects[0].effect: there is no effect 'air_brake'");
  }
}
