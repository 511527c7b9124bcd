package fieldcal.app.diagnose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.app.calibrate.InputException;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A damaged extended_model.json is told with file and field, and never half used. */
class ExtendedModelFileTest {
  private static final String GOOD =
      """
      {"schema": "fieldcal.extended_model/1",
       "flat": {"acc_slide": -3.1, "acc_roll": -0.28, "k_switch": 0.65},
       "chip": null,
       "effects": [{"effect": "air_drag", "parameters": {"cd": 0.45}},
                   {"effect": "worn_region", "parameters": {"change": 0.2, "region": [-1, 1, 0, 2]}},
                   {"effect": "robot_kick_bias",
                    "parameters": {"percent": 3, "yaw": 0, "team": "blue", "robot": 4}}],
       "session_start_unix": 1763712345.5,
       "note": "unknown fields beside the model do no harm"}
      """;

  @TempDir private Path folder;

  private Path file(String content) throws IOException {
    return Files.writeString(folder.resolve("extended_model.json"), content);
  }

  @Test
  void aGoodOneIsRead() throws IOException {
    var model = ExtendedModelFile.read(file(GOOD), new Epoch(0));
    assertThat(model.flat().orElseThrow().kSwitch()).isEqualTo(0.65);
    assertThat(model.chip()).isEmpty();
    assertThat(model.effects()).hasSize(3);
    assertThat(model.effects().get(1).value("region_y1")).isEqualTo(2);
    assertThat(model.effects().get(2).value("team")).isEqualTo(1);
    assertThat(model.flatPath(0, 0, 0, 3, 0).restTime()).isBetween(1.0, 20.0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "fieldcal.extended_model/1 | fieldcal.extended_model/9 | schema",
        "\"acc_slide\": -3.1, | '' | flat.acc_slide",
        "\"acc_slide\": -3.1 | \"acc_slide\": \"fast\" | flat.acc_slide",
        "\"acc_slide\": -3.1 | \"acc_slide\": 3.1 | flat",
        "\"acc_slide\": -3.1 | \"acc_slip\": 1, \"acc_slide\": -3.1 | flat.acc_slip",
        "{\"acc_slide\": -3.1, \"acc_roll\": -0.28, \"k_switch\": 0.65} | null | flat",
        "\"chip\": null | \"chip\": 7 | chip",
        "\"chip\": null | \"chip\": {} | chip.damping_xy_first_hop",
        "\"effects\" | \"effect\" | effects",
        "air_drag | air_dragg | effects[0].effect",
        "\"cd\": 0.45 | \"cd\": null | effects[0].parameters.cd",
        "\"cd\": 0.45 | \"cd\": 450 | effects[0].parameters.cd",
        "\"cd\": 0.45 | \"cw\": 0.45 | effects[0].parameters.cd",
        "\"cd\": 0.45 | \"cd\": 0.45, \"cl\": 0 | effects[0].parameters.cl",
        "[-1, 1, 0, 2] | [-1, 1, 0] | effects[1].parameters.region",
        "[-1, 1, 0, 2] | [1, -1, 0, 2] | effects[1].parameters.region",
        "[-1, 1, 0, 2] | [-1, 1, 0, \"2\"] | effects[1].parameters.region",
        "\"blue\" | \"green\" | effects[2].parameters.team",
        "\"robot\": 4 | \"robot\": 4.5 | effects[2].parameters.robot",
        "1763712345.5 | \"noon\" | session_start_unix",
      })
  void aDamagedOneIsToldWithItsField(String from, String to, String field) throws IOException {
    assertThat(GOOD).contains(from);
    Path file = file(GOOD.replace(from, to));
    assertThatThrownBy(() -> ExtendedModelFile.read(file, new Epoch(0)))
        .isInstanceOf(InputException.class)
        .hasMessageStartingWith(file + ", field " + field)
        .hasMessageNotContaining("\n");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {"'' | empty", "[] | a list", "3 | a single value", "{\"schema\": | not valid JSON"})
  void whatIsNoDocumentIsTold(String content, String message) throws IOException {
    Path file = file(content);
    assertThatThrownBy(() -> ExtendedModelFile.read(file, new Epoch(0)))
        .isInstanceOf(InputException.class)
        .hasMessageStartingWith(file.toString())
        .hasMessageContaining(message);
  }

  @Test
  void aMissingOneIsTold() {
    Path file = folder.resolve("none.json");
    assertThatThrownBy(() -> ExtendedModelFile.read(file, new Epoch(0)))
        .hasMessage(file + ": no such file");
  }
}
