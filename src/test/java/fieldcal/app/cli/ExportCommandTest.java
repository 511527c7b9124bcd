package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InitialModels;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.history.History;
import fieldcal.app.history.HistoryEntry;
import fieldcal.app.history.HistoryEntry.Action;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** The command as an operator runs it. */
class ExportCommandTest {
  @TempDir private Path folder;

  private Path model;

  private record Answer(int exit, String out, String err) {}

  private static Path sample(String name) {
    return Path.of(
        System.getProperty("fieldcal.projectDir", "."),
        "src/test/resources/fieldcal/app/export",
        name);
  }

  @BeforeEach
  void copy() throws IOException {
    model = folder.resolve("calibration.json");
    Files.copy(sample("calibration.json"), model);
  }

  private static Answer run(Object... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    String[] words = new String[args.length + 1];
    words[0] = "export";
    for (int i = 0; i < args.length; i++) {
      words[i + 1] = args[i].toString();
    }
    int exit = commands.execute(words);
    return new Answer(exit, out.toString(), err.toString());
  }

  @Test
  void withoutOutTheFileIsTheOutputAndTheNotesAreNot() throws IOException {
    Answer answer = run(model, "--to=erforce-tracker", "--base=" + sample("erforce-tracker.txt"));
    assertThat(answer.exit()).isZero();
    assertThat(answer.out()).isEqualTo(Files.readString(sample("erforce-tracker.golden")));
    assertThat(answer.err()).contains("fast_deceleration  2.79 → 3.12346 m/s²");
    assertThat(new History(folder).entries()).as("a look is no export").isEmpty();
  }

  /** An extended model that stayed from an earlier session is easily sent for that of this one. */
  @Test
  void anExtendedModelOfOtherRecordingsIsNamed() throws IOException {
    Path extended = folder.resolve("extended_model.json");
    Files.copy(sample("extended_model.json"), extended);
    Path out = folder.resolve("models.txt");
    Object[] arguments = {
      model, "--to=geometry-text", "--extended=" + extended, "--out=" + out, "--overwrite"
    };
    from(model, "friday.log.gz", "1 ns, 2 bytes");
    assertThat(run(arguments).out()).as("not known of what it is").doesNotContain("other record");

    from(extended, "renamed.log.gz", "1 ns, 2 bytes");
    assertThat(run(arguments).out()).doesNotContain("other record");

    from(extended, "sunday.log.gz", "3 ns, 2 bytes");
    assertThat(run(arguments).out())
        .contains(extended + " is of other recordings (sunday.log.gz) than " + model + ": ");
    assertThat(run(extended, "--to=geometry-text").err())
        .contains("calibration.json in " + folder + " is of other recordings (friday.log.gz)");
  }

  private static void from(Path file, String source, String identity) throws IOException {
    ObjectMapper mapper = new ObjectMapper();
    ObjectNode root = (ObjectNode) mapper.readTree(file.toFile());
    new MadeFrom(List.of(source), List.of(identity)).writeTo(root);
    mapper.writeValue(file.toFile(), root);
  }

  @Test
  void nothingIsOverwrittenWithoutBeingTold() throws IOException {
    Path present = folder.resolve("field.txt");
    Files.copy(sample("erforce-tracker.txt"), present);
    Answer refused = run(model, "--to=erforce-tracker", "--base=" + present, "--out=" + present);
    assertThat(refused.exit()).isEqualTo(1);
    assertThat(refused.err()).contains(present + ": exists").hasLineCount(1);
    assertThat(present).hasSameBinaryContentAs(sample("erforce-tracker.txt"));

    Answer done =
        run(model, "--to=erforce-tracker", "--base=" + present, "--out=" + present, "--overwrite");
    assertThat(done.exit()).isZero();
    assertThat(present).hasSameBinaryContentAs(sample("erforce-tracker.golden"));
  }

  @Test
  void theHistoryKeepsWhatLeftAndRollbackPutsBackWhatWasThere() throws IOException {
    Path present = folder.resolve("field.txt");
    Files.copy(sample("erforce-tracker.txt"), present);
    run(model, "--to=erforce-tracker", "--base=" + present, "--out=" + present, "--overwrite");
    HistoryEntry entry = new History(folder).entries().get(0);
    assertThat(entry.action()).isEqualTo(Action.EXPORTED);
    assertThat(entry.target()).isEqualTo("erforce-tracker");
    assertThat(entry.place()).isEqualTo(present.toString());
    assertThat(entry.kicks()).containsExactly(1, 2, 4);
    assertThat(entry.sources()).containsExactly("flat.log.gz", "chip.log.gz");
    assertThat(entry.model()).containsEntry("acc_slide", -3.1234567).hasSize(6);
    assertThat(entry.verdict()).isNull();

    Answer back = run(model, "--to=erforce-tracker", "--out=" + present, "--rollback");
    assertThat(back.err()).isEmpty();
    assertThat(back.exit()).isZero();
    assertThat(present).hasSameBinaryContentAs(sample("erforce-tracker.txt"));
    assertThat(run(model, "--to=erforce-tracker", "--out=" + present, "--rollback").exit())
        .isEqualTo(1);
  }

  @Test
  void aModelThatMustNotBePublishedIsNot() throws IOException {
    String verdict =
        "\"verdict\": {\"decision\": \"do_not_publish\", \"headline\": \"Do not publish: no"
            + " good.\", \"because\": [\"The kicks disagree.\"]},";
    Files.writeString(
        model, Files.readString(model).replaceFirst("\"sources\"", verdict + " \"sources\""));
    Path out = folder.resolve("new.toml");
    Path numbers = folder.resolve("geometry_models.txt");
    Files.writeString(numbers, InitialModels.read(model).toText());
    for (Path from : List.of(model, numbers)) {
      Answer refused = run(from, "--to=immortals", "--out=" + out);
      assertThat(refused.exit()).isEqualTo(1);
      assertThat(refused.err()).contains("Do not publish: no good.").contains("--force");
      assertThat(out).doesNotExist();
    }
    Answer forced = run(model, "--to=immortals", "--out=" + out, "--force");
    assertThat(forced.exit()).isZero();
    assertThat(forced.out()).contains("Do not publish: no good.").contains("The kicks disagree.");
    assertThat(new History(folder).entries().get(0).verdict()).isEqualTo("do_not_publish");
  }

  @Test
  void theOtherVerdictsAreShown() throws IOException {
    String verdict =
        "\"verdict\": {\"decision\": \"check_first\", \"headline\": \"Verdict: check first.\","
            + " \"because\": []},";
    Files.writeString(
        model, Files.readString(model).replaceFirst("\"sources\"", verdict + " \"sources\""));
    Answer answer = run(model, "--to=immortals");
    assertThat(answer.exit()).isZero();
    assertThat(answer.err().lines()).contains("Verdict: check first.");
    // Whoever finds the file later does not see the terminal.
    assertThat(answer.out()).contains("# Verdict: check first.\n");
  }

  @Test
  void otherFilesOfTheProductAreModelsToo() {
    assertThat(run(sample("extended_model.json"), "--to=grsim").exit()).isZero();
    assertThat(run(sample("limits.json"), "--to=immortals").out())
        .contains("[yellow_specs.limits]")
        .contains("vel_absolute_max = 3.25");
  }

  @Test
  void geometryModelsAreAModel() throws IOException {
    Path text = folder.resolve("geometry_models.txt");
    Files.writeString(text, "straight_two_phase { acc_slide: -3 acc_roll: -0.26 k_switch: 0.64 }");
    Answer answer = run(text, "--to=erforce-tracker");
    assertThat(answer.exit()).isZero();
    assertThat(answer.out()).contains("fast_deceleration: 3.0\n").doesNotContain("z_damping");
    assertThat(answer.err()).contains("Not known: vertical damping (damping_z)");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--to=nowhere",
        "--to=grsim --apply=http://localhost:1",
        "--to=ssl-vision-processor --apply=http://localhost:1 --out=x",
        "--to=grsim --rollback",
        "--to=grsim --overwrite",
        "--to=robot-specs --team=red"
      })
  void badUsageEndsWithTwo(String options) {
    Object[] args = (model + " " + options).split(" ");
    assertThat(run(args).exit()).isEqualTo(2);
  }

  @Test
  void aPlaceThatIsNoneIsTheOnlyLine() {
    Answer answer = run(model, "--to=ssl-vision-processor", "--apply=vision");
    assertThat(answer.exit()).isEqualTo(1);
    assertThat(answer.err()).contains("vision: is not an address like http://").hasLineCount(1);
    assertThat(answer.out()).isEmpty();
  }

  @Test
  void badInputIsOneLineWithFileAndPlace() throws IOException {
    Path broken = folder.resolve("broken.json");
    Files.writeString(broken, "{\n \"schema\": ,");
    assertThat(run(broken, "--to=grsim").err()).contains(broken + ", line 2").hasLineCount(1);
    Files.writeString(broken, "{\"schema\": \"other/1\"}");
    assertThat(run(broken, "--to=grsim").err()).contains("schema is 'other/1'").hasLineCount(1);
    assertThat(run(folder.resolve("none.json"), "--to=grsim").err())
        .contains("no such file")
        .hasLineCount(1);
    assertThat(run(sample("limits.json"), "--to=sumatra").err())
        .contains("--team yellow")
        .hasLineCount(1);
    assertThat(run(sample("limits.json"), "--to=robot-specs", "--team=blue").err())
        .contains("--entry NAME")
        .hasLineCount(1);
    assertThat(
            run(sample("limits.json"), "--to=robot-specs", "--team=blue", "--entry=ER-Force").err())
        .contains("needs --base")
        .hasLineCount(1);
    assertThat(run(sample("limits.json"), "--to=ssl-vision").err())
        .contains("holds none of what ssl-vision takes: sliding deceleration (acc_slide)")
        .hasLineCount(1);
  }
}
