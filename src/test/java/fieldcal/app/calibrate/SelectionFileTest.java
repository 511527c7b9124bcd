package fieldcal.app.calibrate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.calibration.Calibration;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.CameraViews;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SelectionFileTest {
  @TempDir Path folder;

  private Path file(String kicks) throws IOException {
    return Files.writeString(
        folder.resolve("selection.json"),
        "{\"schema\": \"fieldcal.selection/1\", \"kicks\": [" + kicks + "]}");
  }

  /** Decisions about kicks of other recordings must survive a run that does not see those kicks. */
  @Test
  void decisionsAboutKicksThatAreNotThereSurvive() throws IOException {
    HandSelection before =
        HandSelection.none().drop("1763712345.12", "a foot").keep("1763712399.00");
    Calibration empty =
        new Calibration(
            List.of(), Map.of(), Map.of(), Optional.empty(), CameraViews.of(List.of()), 1);
    Path file = folder.resolve("sub").resolve("selection.json");
    SelectionFile.write(empty, before, Epoch.atSecondOf(1.7e9), file);
    HandSelection after = SelectionFile.read(file);
    assertThat(after.dropped()).isEqualTo(before.dropped());
    assertThat(after.kept()).isEqualTo(before.kept());
    assertThat(folder.resolve("sub")).isDirectoryContaining("glob:**selection.json");
  }

  @Test
  void readsWhatPeopleWrite() throws IOException {
    HandSelection s =
        SelectionFile.read(
            file(
                "{\"key\": \"1.25\", \"decision\": \"drop\"}, {\"key\": \"2.50\", \"decision\":"
                    + " \"keep\"}, {\"key\": \"3.75\"}, {\"key\": \"4.00\", \"decision\": \"auto\","
                    + " \"reason\": \"2 σ\"}"));
    assertThat(s.droppedBecause("1.25")).contains("no reason given");
    assertThat(s.isKept("2.50")).isTrue();
    assertThat(s.dropped()).hasSize(1);
    assertThat(s.kept()).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"key\": \"1.25\"}, {\"key\": \"2.50\", \"decision\": \"delete\"} | kick 2: decision must"
            + " be auto, drop or keep, not \"delete\"",
        "{\"key\": \"today\"} | kick 1: key must be a time",
        "{\"decision\": \"drop\"} | kick 1: key must be a time"
      })
  void aWrongEntryIsNamed(String kicks, String what) throws IOException {
    Path file = file(kicks);
    assertThatThrownBy(() -> SelectionFile.read(file))
        .isInstanceOf(InputException.class)
        .hasMessageStartingWith(file + ", ")
        .hasMessageContaining(what);
  }

  @Test
  void whatIsNoSelectionFileIsNamed() throws IOException {
    Path other = Files.writeString(folder.resolve("o.json"), "{\"schema\": \"x\"}");
    assertThatThrownBy(() -> SelectionFile.read(other))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("not a selection file");
    Path broken = Files.writeString(folder.resolve("b.json"), "{\n\"schema\": \"fieldc");
    assertThatThrownBy(() -> SelectionFile.read(broken))
        .isInstanceOf(InputException.class)
        .hasMessageContaining(broken + ", line 2");
    Path empty = Files.writeString(folder.resolve("e.json"), "");
    assertThatThrownBy(() -> SelectionFile.read(empty))
        .isInstanceOf(InputException.class)
        .hasMessageContaining(empty.toString());
    assertThatThrownBy(() -> SelectionFile.read(folder.resolve("missing.json")))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("no such file");
  }
}
