package fieldcal.app.calibrate;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.wording.WordList;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads a published ball model: {@code SSL_GeometryModels}, binary or text, or a {@code calibration.json}. */
public final class InitialModels {
  private static final Map<String, List<String>> PARAMETERS =
      Map.of(
          "flat", List.of("acc_slide", "acc_roll", "k_switch"),
          "chip", List.of("damping_xy_first_hop", "damping_xy_other_hops", "damping_z"));

  private InitialModels() {}

  /**
   * Reads.
   *
   * @param file from where
   * @return the models in it, at least one
   * @throws InputException when it holds none
   * @throws IOException when it cannot be read
   */
  public static BallModels read(Path file) throws IOException {
    byte[] content = JsonFiles.bytes(file);
    boolean json = new String(content, StandardCharsets.UTF_8).stripLeading().startsWith("{");
    try {
      return json ? fromJson(file) : BallModels.fromFile(content);
    } catch (IllegalArgumentException e) {
      throw new InputException(
          file
              + ": "
              + e.getMessage()
              + "; give SSL_GeometryModels (binary or text) or a calibration.json");
    }
  }

  private static BallModels fromJson(Path file) throws IOException {
    JsonNode root = JsonFiles.read(file);
    if (!CalibrationJson.SCHEMA.equals(root.path("schema").asText())) {
      throw new InputException(file + ": schema is not " + CalibrationJson.SCHEMA);
    }
    double roll = mean(root, "flat", "acc_roll");
    double slide = mean(root, "flat", "acc_slide");
    double kSwitch = mean(root, "flat", "k_switch");
    double first = mean(root, "chip", "damping_xy_first_hop");
    double other = mean(root, "chip", "damping_xy_other_hops");
    double up = mean(root, "chip", "damping_z");
    boolean flat = Double.isFinite(slide + roll + kSwitch);
    boolean chip = Double.isFinite(first + other + up);
    if (!flat && !chip) {
      throw new InputException(file + ": " + incomplete(root));
    }
    double chipRoll = Double.isFinite(roll) ? roll : FlatModel.typical().accRoll();
    return new BallModels(
        flat ? Optional.of(new FlatModel(slide, roll, kSwitch)) : Optional.empty(),
        chip ? Optional.of(new ChipModel(first, other, up, chipRoll)) : Optional.empty());
  }

  /** What the kicks did not determine, and what the calibration itself says of that. */
  private static String incomplete(JsonNode root) {
    List<String> missing = new ArrayList<>();
    for (String kind : List.of("flat", "chip")) {
      List<String> lacks =
          PARAMETERS.get(kind).stream().filter(p -> Double.isNaN(mean(root, kind, p))).toList();
      missing.add("the " + kind + " model lacks " + WordList.of(lacks));
    }
    String verdict = root.path("verdict").path("headline").asText();
    return "holds no complete model: "
        + String.join(", ", missing)
        + "."
        + (verdict.isEmpty() ? "" : " " + verdict);
  }

  private static double mean(JsonNode root, String kind, String parameter) {
    return root.path(kind).path(parameter).path("mean").asDouble(Double.NaN);
  }
}
