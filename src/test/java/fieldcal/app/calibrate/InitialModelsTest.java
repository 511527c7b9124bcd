package fieldcal.app.calibrate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class InitialModelsTest {
  private static final BallModels MODELS =
      new BallModels(
          Optional.of(new FlatModel(-3.25, -0.25, 0.625)),
          Optional.of(new ChipModel(0.75, 0.875, 0.5, -0.25)));

  @TempDir Path folder;

  @Test
  void binaryAndTextAreTheLeaguesMessages() throws IOException {
    Path binary = Files.write(folder.resolve("m.pb"), MODELS.toBytes());
    Path text = Files.writeString(folder.resolve("m.txt"), MODELS.toText());
    assertThat(InitialModels.read(binary)).isEqualTo(MODELS);
    assertThat(InitialModels.read(text)).isEqualTo(MODELS);
  }

  @Test
  void aCalibrationServesAsTheNextOnesStart() throws IOException {
    Path json =
        json(
            "\"flat\": {\"acc_slide\": {\"mean\": -3.25}, \"acc_roll\": {\"mean\": -0.25},"
                + " \"k_switch\": {\"mean\": 0.625}},\"chip\": {\"damping_xy_first_hop\":"
                + " {\"mean\": 0.75}, \"damping_xy_other_hops\": {\"mean\": 0.875},\"damping_z\":"
                + " {\"mean\": 0.5}}");
    assertThat(InitialModels.read(json)).isEqualTo(MODELS);
  }

  @Test
  void halfAModelIsNone() throws IOException {
    Path json = json("\"flat\": {\"acc_slide\": {\"mean\": -3.25}}, \"chip\": {}");
    assertThatThrownBy(() -> InitialModels.read(json))
        .isInstanceOf(InputException.class)
        .hasMessageStartingWith(json + ": ")
        .hasMessageEndingWith(
            "holds no complete model: the flat model lacks acc_roll and k_switch, the chip model"
                + " lacks damping_xy_first_hop, damping_xy_other_hops and damping_z.");
  }

  /** Who exports it learns what to do from the calibration itself. */
  @Test
  void anIncompleteCalibrationSaysItsVerdict() throws IOException {
    Path json =
        json(
            "\"flat\": {\"acc_slide\": {\"mean\": -3.25}, \"acc_roll\": {\"mean\": -0.25}},"
                + " \"verdict\": {\"headline\": \"Verdict: record more. Record flat kicks.\"}");
    assertThatThrownBy(() -> InitialModels.read(json))
        .hasMessageContaining("the flat model lacks k_switch,")
        .hasMessageEndingWith(". Verdict: record more. Record flat kicks.");
  }

  private Path json(String content) throws IOException {
    return Files.writeString(
        folder.resolve("c.json"), "{\"schema\": \"fieldcal.calibration/1\", " + content + "}");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"schema\": \"other/1\"} | schema is not fieldcal.calibration/1",
        "{\"schema\": | not valid JSON",
        "not a model at all | SSL_GeometryModels",
        "straight_two_phase { acc_slide: 3 acc_roll: -0.3 k_switch: 0.6 } | acc"
      })
  void whatIsNoModelIsNamed(String content, String what) throws IOException {
    Path file = Files.writeString(folder.resolve("m"), content);
    assertThatThrownBy(() -> InitialModels.read(file))
        .isInstanceOf(InputException.class)
        .hasMessageContaining(file.toString())
        .hasMessageContaining(what)
        .hasMessageNotContaining("\n");
  }

  @Test
  void anEmptyOrMissingFileIsNamed() throws IOException {
    Path empty = Files.write(folder.resolve("empty"), new byte[0]);
    assertThatThrownBy(() -> InitialModels.read(empty))
        .isInstanceOf(InputException.class)
        .hasMessageStartingWith(empty + ": ");
    Path missing = folder.resolve("missing.pb");
    assertThatThrownBy(() -> InitialModels.read(missing))
        .isInstanceOf(InputException.class)
        .hasMessage(missing + ": no such file");
  }
}
