package fieldcal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import fieldcal.app.cli.Main;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/** What the README and docs/ tell the operator to type is understood, and the files it names are there. */
class ReadmeTest {

  private static final Path README = Documents.PROJECT.resolve("README.md");

  static List<String> commands() throws IOException {
    List<String> commands = new ArrayList<>();
    for (Path document : Documents.all()) {
      Documents.code(document, "").stream()
          .filter(line -> line.startsWith("./fieldcal "))
          .forEach(commands::add);
    }
    return commands;
  }

  @ParameterizedTest
  @MethodSource("commands")
  void commandIsUnderstood(String line) {
    List<String> words = Arrays.asList(line.split("\\s+"));
    CommandLine program = Main.commandLine();
    String[] arguments = words.subList(1, words.size()).toArray(String[]::new);
    assertThatCode(() -> program.parseArgs(arguments)).as(line).doesNotThrowAnyException();
    assertThat(
            words.stream()
                .filter(word -> word.startsWith("test-data/"))
                .map(Documents.PROJECT::resolve))
        .as(line)
        .allSatisfy(file -> assertThat(file).exists());
  }

  @Test
  void quickStartHasTheTwoCommands() throws IOException {
    List<String> lines = Documents.code(README, "sh");
    assertThat(lines).anyMatch(line -> line.startsWith("./fieldcal calibrate test-data/"));
    assertThat(lines).contains("./gradlew test");
  }

  /** The first thing that a newcomer types: it must end soon, and as the README says. */
  @Test
  void theFirstExampleEndsAsTheReadmeSays(@TempDir Path folder) throws IOException {
    List<String> lines = commandsOf(README).subList(0, 2);
    assertThat(Files.readString(README)).contains("The verdict is *check first*.", ": air drag.");
    assertThat(output(lines.get(0), folder)).startsWith("Verdict: check first. Run diagnose");
    assertThat(output(lines.get(1), folder)).contains("cause is found: air drag");
    assertThat(folder).isDirectoryContaining("glob:**/report.html");
  }

  private static List<String> commandsOf(Path document) throws IOException {
    return Documents.code(document, "sh").stream()
        .filter(l -> l.startsWith("./fieldcal "))
        .toList();
  }

  /** What a command prints, with its results in another folder. */
  private static String output(String line, Path folder) {
    List<String> words =
        Arrays.stream(line.split("\\s+"))
            .skip(1)
            .map(w -> w.startsWith("test-data/") ? Documents.PROJECT.resolve(w).toString() : w)
            .map(w -> w.equals("out") ? folder.toString() : w)
            .toList();
    StringWriter out = new StringWriter();
    CommandLine program = Main.commandLine();
    program.setOut(new PrintWriter(out));
    assertThat(program.execute(words.toArray(String[]::new))).as(line).isZero();
    return out.toString().replaceAll("\\s+", " ");
  }

  /** Whoever stands at the field reads it once; everything else is in docs/. */
  @Test
  void howLongADiagnosisTakesIsSaidInOneSentence() throws IOException {
    for (String file :
        List.of(
            "docs/operator.md",
            "docs/diagnosis.md",
            "src/app/resources/fieldcal/app/console/diagnosis.js")) {
      assertThat(Files.readString(Documents.PROJECT.resolve(file)))
          .as(file)
          .contains("takes some seconds; chips with several causes take some minutes.");
    }
  }

  @Test
  void theReadmeIsShort() throws IOException {
    assertThat(Files.readString(README).strip().split("\\s+")).hasSizeLessThanOrEqualTo(1500);
  }

  @Test
  void everyCommandIsInTheReadme() throws IOException {
    String readme = Files.readString(README);
    Set<String> names = Main.commandLine().getSubcommands().keySet();
    assertThat(names)
        .hasSizeGreaterThan(10)
        .allSatisfy(name -> assertThat(readme).contains("`" + name + " "));
  }
}
