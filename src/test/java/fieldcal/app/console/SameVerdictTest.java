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
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** The same recordings give the same verdict with the same reasons on the terminal, in the JSON, and for the eyes of who opens the report and the console. */
class SameVerdictTest {
  private static final Path RECORDINGS =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  @TempDir private Path folder;

  private static Browser browser;

  @BeforeAll
  static void openBrowser() {
    browser = new Browser();
  }

  @AfterAll
  static void closeBrowser() {
    browser.close();
  }

  /** Reasons are those that hold the model back, the gravest first. */
  @ParameterizedTest
  @CsvSource({
    "good, publish, ''",
    "one-kick, record_more, few_kicks few_kicks few_kicks",
    "wrong-model, check_first, mean_against_joint_fit many_excluded many_excluded many_excluded"
        + " kicks_differ",
    "two-fields, do_not_publish, several_fields simulated_field kicks_differ",
  })
  void theVerdictIsTheSameEverywhere(String name, String decision, String holdBack)
      throws IOException {
    Path session = Files.createDirectories(folder.resolve("session"));
    List<Path> logs = record(name, session);
    Path out = folder.resolve("out");
    List<String> command = new ArrayList<>(List.of("calibrate", "--out=" + out));
    logs.forEach(log -> command.add(log.toString()));
    List<String> terminal = run(command.toArray(String[]::new)).lines().toList();

    JsonNode json = new ObjectMapper().readTree(out.resolve("calibration.json").toFile());
    JsonNode verdict = json.path("verdict");
    assertThat(verdict.path("decision").asText()).isEqualTo(decision);
    assertThat(holdingBack(verdict)).isEqualTo(holdBack);
    List<String> reasons = texts(verdict.path("because"));
    List<String> notes = texts(verdict.path("notes"));
    List<String> toDo = texts(verdict.path("to_do"));
    assertThat(toDo).isNotEmpty();
    assertThat(reasons.isEmpty()).isEqualTo(holdBack.isEmpty());
    assertThat(notes.size()).isLessThanOrEqualTo(verdict.path("reasons").size());

    assertThat(verdict(terminal).get(0))
        .isEqualTo("Verdict: " + decision.replace('_', ' ') + ". " + toDo.get(0))
        .isEqualTo(verdict.path("headline").asText());
    assertThat(marked(terminal, "  ! ")).isEqualTo(reasons);
    assertThat(marked(terminal, "  - ")).isEqualTo(notes);
    assertThat(marked(terminal, "  > ")).isEqualTo(toDo.subList(1, toDo.size()));

    JsonNode report = PageChecks.data(Files.readString(out.resolve("report.html")));
    assertSame(report.at("/report/verdict"), decision, reasons, notes, toDo);
    browser.open(out.resolve("report.html").toUri().toString());
    assertShown(decision, reasons, notes, toDo);
    try (RunningConsole console = RunningConsole.start(session)) {
      JsonNode state = console.settled();
      assertSame(state.at("/calibration/report/verdict"), decision, reasons, notes, toDo);
      browser.open(console.url() + "#publish");
      assertShown(decision, reasons, notes, toDo);
      browser.open(console.url() + "#kicks");
      browser.awaitText("#advice", toDo.get(0));
      assertThat(browser.text("#advice")).startsWithIgnoringCase(titled(decision));
    }
  }

  /** A session that is calibrated whole, in the order in which the console reads it. */
  private static List<Path> record(String name, Path session) throws IOException {
    Path log = session.resolve(name + ".log.gz");
    switch (name) {
      case "good" -> Files.copy(RECORDINGS.resolve("world-null-flat.log.gz"), log);
      case "wrong-model" -> Files.copy(RECORDINGS.resolve("world-flat-air-drag.log.gz"), log);
      case "two-fields" -> {
        Path other = session.resolve("another-field.log.gz");
        Files.copy(RECORDINGS.resolve("erforce-flat.log.gz"), other);
        run("simulate", "--scenario=flat", "--kicks=6", "--seed=4", "--out=" + log);
        // The console would leave it out by itself.
        Files.writeString(
            session.resolve("recordings.json"),
            "{\"schema\": \"fieldcal.recordings/1\", \"use\": {\""
                + log.getFileName()
                + "\": true, \""
                + other.getFileName()
                + "\": true}}");
        return List.of(other, log);
      }
      default -> run("simulate", "--scenario=flat", "--kicks=1", "--seed=4", "--out=" + log);
    }
    return List.of(log);
  }

  private static String holdingBack(JsonNode verdict) {
    List<String> ids = new ArrayList<>();
    for (JsonNode reason : verdict.path("reasons")) {
      if (!reason.path("decision").asText().equals("publish")) {
        ids.add(reason.path("reason").asText());
      }
    }
    return String.join(" ", ids);
  }

  /** All of it stands on the open page. */
  private static void assertShown(
      String decision, List<String> reasons, List<String> notes, List<String> toDo) {
    browser.awaitText("#verdict", toDo.get(0));
    String shown = browser.text("#verdict");
    assertThat(shown).containsIgnoringCase(titled(decision));
    Stream.of(reasons, notes, toDo)
        .flatMap(List::stream)
        .forEach(words -> assertThat(shown).contains(words));
  }

  private static String titled(String decision) {
    String mark =
        switch (decision) {
          case "publish" -> "✔ ";
          case "do_not_publish" -> "✘ ";
          default -> "⚠ ";
        };
    return mark + decision.replace('_', ' ');
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
    List<String> first = verdict(lines);
    return first.stream().filter(l -> l.startsWith(mark)).map(l -> l.substring(4)).toList();
  }

  /** The lines of the verdict, which ends with an empty line, as they were before they were wrapped. */
  private static List<String> verdict(List<String> lines) {
    List<String> whole = new ArrayList<>();
    for (String line : lines.subList(0, lines.indexOf(""))) {
      boolean begins = whole.isEmpty() || line.matches("  [!>-] .*");
      if (begins) {
        whole.add(line);
      } else {
        whole.set(whole.size() - 1, whole.get(whole.size() - 1) + " " + line.strip());
      }
    }
    return whole;
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
