package fieldcal.app.history;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.app.history.HistoryEntry.Action;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The history of a session survives restarts, crashes and two programs that write at once. */
class HistoryTest {
  /** So many that two programs meet. */
  private static final int ENTRIES = 200;

  @TempDir private Path folder;

  private static HistoryEntry entry(String place) {
    return new HistoryEntry(
        HistoryEntry.SCHEMA,
        0,
        1.5,
        Action.EXPORTED,
        "grsim",
        place,
        "publish",
        List.of("a.log"),
        List.of(3, 4),
        Map.of("acc_slide", -3.0),
        "text",
        null,
        null);
  }

  @Test
  void anEmptySessionHasNone() throws IOException {
    assertThat(new History(folder).entries()).isEmpty();
    assertThat(new History(folder).toUndo("x")).isEmpty();
  }

  @Test
  void whatIsAddedIsThereForTheNextRun() throws IOException {
    HistoryEntry one = new History(folder).add(entry("x"), Optional.empty());
    HistoryEntry two = new History(folder).add(entry("y"), Optional.of(new byte[] {1, 2}));
    assertThat(new History(folder).entries()).containsExactly(one, two);
    assertThat(one.id()).isEqualTo(1);
    assertThat(new History(folder).before(two)).containsExactly(1, 2);
    assertThat(new History(folder).toUndo("x")).as("there was nothing before").isEmpty();
    assertThat(new History(folder).toUndo("y")).contains(two);
  }

  /** Two runs write the same line. */
  @Test
  void parametersAreWrittenInTheOrderOfTheirNames() throws IOException {
    Map<String, Double> model = new HashMap<>();
    List<String> names = IntStream.range(0, 12).mapToObj(i -> "p" + (char) ('a' + i)).toList();
    names.forEach(name -> model.put(name, 1.0));
    HistoryEntry made =
        new HistoryEntry(
            HistoryEntry.SCHEMA,
            0,
            1.5,
            Action.EXPORTED,
            "grsim",
            "x",
            null,
            List.of(),
            List.of(),
            model,
            null,
            null,
            null);
    new History(folder).add(made, Optional.empty());
    String line = Files.readString(folder.resolve("history.jsonl"));
    List<Integer> places = names.stream().map(name -> line.indexOf('"' + name + '"')).toList();
    assertThat(places).isSorted().allMatch(place -> place > 0);
  }

  @Test
  void eachIsUndoneOnceTheLatestFirst() throws IOException {
    History history = new History(folder);
    HistoryEntry one = history.add(entry("x"), Optional.of(new byte[] {1}));
    HistoryEntry two = history.add(entry("x"), Optional.of(new byte[] {2}));
    assertThat(history.toUndo("x")).contains(two);
    history.add(two.undone(2), Optional.empty());
    assertThat(history.toUndo("x")).contains(one);
    history.add(one.undone(3), Optional.empty());
    assertThat(history.toUndo("x")).isEmpty();
  }

  /** Lines of a later version have numbers, too. */
  @Test
  void whatWasThereBeforeIsFoundByItsName() throws IOException {
    Files.createDirectories(folder.resolve("history"));
    Files.write(folder.resolve("history/1.before"), new byte[] {7});
    Files.writeString(
        folder.resolve("history.jsonl"),
        "{\"schema\":\"fieldcal.history/2\",\"before\":\"history/1.before\"}\n");
    History history = new History(folder);
    HistoryEntry added = history.add(entry("x"), Optional.of(new byte[] {2}));
    assertThat(history.before(history.entries().get(0))).containsExactly(2);
    assertThat(added.before()).isEqualTo("history/2.before");
    assertThat(folder.resolve("history/1.before")).hasBinaryContent(new byte[] {7});
  }

  @ParameterizedTest
  @ValueSource(strings = {"../secret", "history/../../secret", "/etc/passwd", "history", "\0"})
  void nothingOutsideOfTheHistoryIsPutBack(String name) {
    HistoryEntry one = entry("x");
    HistoryEntry made =
        new HistoryEntry(
            one.schema(),
            1,
            1,
            one.action(),
            one.target(),
            one.place(),
            null,
            List.of(),
            List.of(),
            Map.of(),
            null,
            name,
            null);
    assertThatThrownBy(() -> new History(folder).before(made))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("history");
  }

  /** Adds entries as another program would. */
  static final class Writer {
    private Writer() {}

    public static void main(String[] args) throws IOException {
      for (int i = 0; i < ENTRIES; i++) {
        String place = args[1] + "-" + i;
        new History(Path.of(args[0]))
            .add(entry(place), Optional.of(place.getBytes(StandardCharsets.UTF_8)));
      }
    }
  }

  @Test
  void twoProgramsThatWriteAtOnceGetDifferentNumbers() throws Exception {
    List<Process> programs = new ArrayList<>();
    for (String name : List.of("a", "b")) {
      programs.add(
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-cp",
                  System.getProperty("java.class.path"),
                  Writer.class.getName(),
                  folder.toString(),
                  name)
              .inheritIO()
              .start());
    }
    for (Process program : programs) {
      assertThat(program.waitFor()).isZero();
    }
    History history = new History(folder);
    assertThat(history.entries()).hasSize(2 * ENTRIES);
    for (HistoryEntry one : history.entries()) {
      assertThat(new String(history.before(one), StandardCharsets.UTF_8)).isEqualTo(one.place());
    }
  }

  @Test
  void aLineThatWasCutOffTakesNoOtherWithIt() throws IOException {
    History history = new History(folder);
    history.add(entry("x"), Optional.empty());
    Files.write(
        folder.resolve("history.jsonl"),
        "{\"schema\":\"fieldcal.hi".getBytes(StandardCharsets.UTF_8),
        StandardOpenOption.APPEND);
    history.add(entry("y"), Optional.empty());
    assertThat(history.entries()).extracting(HistoryEntry::place).containsExactly("x", "y");
  }

  @Test
  void fieldsOfALaterVersionDoNoHarm() throws IOException {
    Files.writeString(
        folder.resolve("history.jsonl"),
        "{\"schema\":\"fieldcal.history/1\",\"unix\":1,\"action\":\"EXPORTED\",\"mood\":\"good\"}\n"
            + "{\"schema\":\"fieldcal.history/2\",\"action\":\"SUNG\"}\nnull\n7\n");
    assertThat(new History(folder).entries()).hasSize(1);
  }
}
