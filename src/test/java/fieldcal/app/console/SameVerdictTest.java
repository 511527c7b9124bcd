package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.cli.Main;
import fieldcal.app.report.PageChecks;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** The same recording gives the same verdict with the same reasons on the terminal, in the JSON, in the report and in the console. */
class SameVerdictTest {
  private static final Path RECORDINGS =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({
    "good, publish, differs_from_published|agrees_with_published",
    "one-kick, record_more, few_kicks",
    "wrong-model, check_first, mean_against_joint_fit",
  })
  void theVerdictIsTheSameEverywhere(String name, String decision, String reason)
      throws IOException {
    Path session = Files.createDirectories(folder.resolve("session"));
    Path log = session.resolve(name + ".log.gz");
    switch (name) {
      case "good" -> Files.copy(RECORDINGS.resolve("world-null-flat.log.gz"), log);
      case "wrong-model" -> Files.copy(RECORDINGS.resolve("world-flat-air-drag.log.gz"), log);
      default -> run("simulate", "--scenario=flat", "--kicks=1", "--seed=4", "--out=" + log);
    }
    Path out = folder.resolve("out");
    List<String> terminal = run("calibrate", log.toString(), "--out=" + out).lines().toList();

    JsonNode json = new ObjectMapper().readTree(out.resolve("calibration.json").toFile());
    JsonNode verdict = json.path("verdict");
    assertThat(verdict.path("decision").asText()).isEqualTo(decision);
    assertThat(verdict.at("/reasons/0/reason").asText()).matches(reason);
    List<String> reasons = texts(verdict.path("because"));
    List<String> notes = texts(verdict.path("notes"));
    List<String> toDo = texts(verdict.path("to_do"));
    assertThat(toDo).isNotEmpty();

    assertThat(terminal.get(0))
        .isEqualTo("Verdict: " + decision.replace('_', ' ') + ". " + toDo.get(0))
        .isEqualTo(verdict.path("headline").asText());
    assertThat(marked(terminal, "  ! ")).isEqualTo(reasons);
    assertThat(marked(terminal, "  - ")).isEqualTo(notes);
    assertThat(marked(terminal, "  > ")).isEqualTo(toDo.subList(1, toDo.size()));

    JsonNode report = PageChecks.data(Files.readString(out.resolve("report.html")));
    assertSame(report.at("/report/verdict"), decision, reasons, notes, toDo);
    try (RunningConsole console = RunningConsole.start(session)) {
      JsonNode state = console.settled();
      assertSame(state.at("/calibration/report/verdict"), decision, reasons, notes, toDo);
    }
  }

  private static void assertSame(
      JsonNode words,
      String decision,
      List<String> reasons,
      List<String> notes,
      List<String> toDo) {
    assertThat(words.path("decision").asText()).isEqualTo(decision);
    assertThat(texts(words.path("reasons"))).isEqualTo(reasons);
    assertThat(texts(words.path("notes"))).isEqualTo(notes);
    assertThat(texts(words.path("toDo"))).isEqualTo(toDo);
  }

  private static List<String> marked(List<String> lines, String mark) {
    // The verdict ends with an empty line.
    List<String> first = lines.subList(0, lines.indexOf(""));
    return first.stream().filter(l -> l.startsWith(mark)).map(l -> l.substring(4)).toList();
  }

  private static List<String> texts(JsonNode array) {
    List<String> all = new ArrayList<>();
    array.forEach(text -> all.add(text.asText()));
    return all;
  }

  private static String run(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    assertThat(commands.execute(args)).as(err.toString()).isZero();
    return out.toString();
  }
}
