package fieldcal.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A team's regression test is quiet while nothing changes, and says in words what does. */
class RecordedTest {
  private static final Path LOG =
      Path.of(
          System.getProperty("fieldcal.projectDir", "."), "test-data", "world-null-flat.log.gz");

  @TempDir private Path folder;

  private static void accepting(Runnable assertion) {
    System.setProperty("fieldcal.accept", "true");
    try {
      assertion.run();
    } finally {
      System.clearProperty("fieldcal.accept");
    }
  }

  @Test
  void whatWasAcceptedStaysAndAChangeIsNamed() throws IOException {
    Path expected = folder.resolve("kicks/home.expected");
    Recorded kicks = Recorded.read(LOG, expected);
    KickPredictor straight =
        (kicked, seconds) ->
            new double[] {kicked.x() + kicked.vx() * seconds, kicked.y() + kicked.vy() * seconds};
    assertThatThrownBy(kicks::assertModelsStay)
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("expects nothing of “model.…” yet")
        .hasMessageContaining("-Dfieldcal.accept=true");

    accepting(
        () -> {
          kicks.assertModelsStay();
          kicks.assertPredictionsStay();
          kicks.assertPredictionsStay("straight", straight);
          kicks.assertDiagnosisStays();
        });
    assertThat(Files.readString(expected))
        .contains("model.kicks = 24.000 ± 0.0000", "model.flat.accSlide = -", "verdict = ");
    assertThatCode(
            () -> {
              kicks.assertModelsStay();
              kicks.assertPredictionsStay();
              kicks.assertPredictionsStay("straight", straight);
              kicks.assertDiagnosisStays();
            })
        .doesNotThrowAnyException();

    // The team's code gets worse: said with both numbers, for each horizon.
    assertThatThrownBy(
            () ->
                kicks.assertPredictionsStay(
                    "straight", (kicked, seconds) -> new double[] {kicked.x(), kicked.y()}))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("3 values are not as expected")
        .hasMessageContaining("prediction.straight.flat.1.0 s")
        .hasMessageContaining("but was");

    // Somebody knows a truth, and writes it into the file.
    String edited =
        Files.readString(expected)
            .replaceAll("(?m)^model.flat.accRoll = .*$", "model.flat.accRoll = -0.5 ± 0.01")
            .replaceAll("(?m)^diagnosis.causes = .*$", "diagnosis.causes = wind");
    Files.writeString(expected, edited);
    Recorded again = Recorded.read(LOG, expected);
    assertThatThrownBy(again::assertModelsStay)
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("1 value is not as expected")
        .hasMessageContaining("model.flat.accRoll   expected -0.5 ± 0.010000, but was -0.2");
  }

  @Test
  void toleranceThatPeopleChoseIsKeptWhenValuesAreAccepted() throws IOException {
    Path expected = folder.resolve("home.expected");
    Files.writeString(expected, "model.flat.accRoll = -0.5 ± 0.3\nother = kept\n");
    Recorded kicks = Recorded.read(LOG, expected);
    accepting(kicks::assertModelsStay);
    assertThat(Files.readString(expected))
        .containsPattern("model.flat.accRoll = -0.2\\d+ ± 0.30000")
        .contains("other = kept");
  }

  @Test
  void filesThatAreNoneAreNamedWithTheLine() throws IOException {
    Path expected = Files.writeString(folder.resolve("bad.expected"), "# head\na = 1 ± x\n");
    assertThatThrownBy(() -> Recorded.read(LOG, expected))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("bad.expected, line 2");
    assertThatThrownBy(() -> Recorded.read(folder.resolve("none.log"), folder.resolve("x")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("none");
  }
}
