package fieldcal.app.compare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.cli.Main;
import fieldcal.ball.FlatModel;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** {@code compare} as an operator runs it, on fields whose differences are known. */
class CompareCommandTest {
  private static final FlatModel FIELD = new FlatModel(-3.1, -0.28, 0.65);
  private static final FlatModel SIMULATOR = new FlatModel(-3.1, -0.24, 0.65);

  @TempDir private static Path folder;

  private record Answer(int exit, String out, String err) {}

  private static Answer run(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    int exit = commands.execute(args);
    return new Answer(exit, out.toString(), err.toString());
  }

  @BeforeAll
  static void record() {
    simulate("field", 3, FIELD);
    simulate("again", 8, FIELD);
    simulate("simulator", 5, SIMULATOR, "--effect=camera_offset:x_mm=12,camera=1");
  }

  private static void simulate(String name, int seed, FlatModel model, String... more) {
    List<String> args =
        new ArrayList<>(List.of("simulate", "--scenario=flat", "--kicks=10", "--cameras=2"));
    args.add("--seed=" + seed);
    args.add("--flat-model=" + model.accSlide() + "," + model.accRoll() + "," + model.kSwitch());
    args.add("--out=" + folder.resolve(name + ".log.gz"));
    args.addAll(List.of(more));
    Answer made = run(args.toArray(String[]::new));
    assertThat(made.exit()).as(made.err()).isZero();
  }

  private static String log(String name) {
    return folder.resolve(name + ".log.gz").toString();
  }

  @Test
  void theOneDifferenceIsNamedWithAllThatItCosts() throws IOException {
    Path out = folder.resolve("out");
    Answer answer =
        run(
            "compare",
            log("field"),
            "--with",
            log("simulator"),
            "--commands=" + folder.resolve("field.commands.csv"),
            "--with-commands=" + folder.resolve("simulator.commands.csv"),
            "--out=" + out);
    assertThat(answer.exit()).as(answer.err()).isZero();
    JsonNode json = new ObjectMapper().readTree(out.resolve("compare.json").toFile());
    assertThat(json.get("schema").asText()).isEqualTo("fieldcal.compare/1");
    assertThat(json.get("differences")).hasSize(1);
    JsonNode only = json.get("differences").get(0);
    assertThat(only.get("id").asText()).isEqualTo("accRoll");
    assertThat(only.get("real").asDouble()).isCloseTo(-0.28, within(0.003));
    assertThat(only.get("sim").asDouble()).isCloseTo(-0.24, within(0.003));
    assertThat(only.get("share_of_prediction_error").asDouble()).isCloseTo(1, within(1e-6));
    double shorter = SIMULATOR.restDistance(5) - FIELD.restDistance(5);
    JsonNode pass = json.get("pass");
    assertThat(pass.get("sim_distance").asDouble() - pass.get("real_distance").asDouble())
        .isCloseTo(shorter, within(0.1));
    assertThat(answer.out())
        .contains("less far on the field than in the simulator. The largest cause is rolling");
    // Half of the difference of the accelerations times the square of the time, while rolling.
    assertThat(json.get("prediction_error_mm").get("1.0").asDouble()).isBetween(10.0, 30.0);
    List<String> others = new ArrayList<>();
    for (JsonNode row : json.get("others")) {
      if (row.get("differs").asBoolean()) {
        others.add(row.get("id").asText());
      }
    }
    assertThat(json.get("others").findValuesAsText("id")).contains("kick_gain");
    // Two cameras stand on both sides of their mean. Acceleration and braking are the same.
    assertThat(others).containsExactlyInAnyOrder("offset_x.0", "offset_x.1");
    assertThat(Files.readString(out.resolve("compare.html"))).contains("less far on the field");
  }

  @Test
  void theSameFieldTwiceDiffersInNothing() throws IOException {
    Path file = folder.resolve("same.json");
    Answer answer = run("compare", log("field"), "--with", log("again"), "--json=" + file);
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(answer.out())
        .startsWith("These kicks show no difference between the ball on the field");
    JsonNode json = new ObjectMapper().readTree(file.toFile());
    assertThat(json.get("differences")).isEmpty();
    assertThat(json.get("parameters").size()).isEqualTo(3);
    assertThat(json.get("others").findValuesAsText("differs")).containsOnly("false");
  }

  @Test
  void wrongUsageIsTwoAndBadInputOne() {
    assertThat(run("compare").exit()).isEqualTo(2);
    assertThat(run("compare", log("field")).exit()).isEqualTo(2);
    Answer missing = run("compare", log("field"), "--with", "none.log");
    assertThat(missing.exit()).isEqualTo(1);
    assertThat(missing.err().lines()).hasSize(1);
    assertThat(missing.err()).contains("none.log");
  }
}
