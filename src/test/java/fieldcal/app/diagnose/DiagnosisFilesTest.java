package fieldcal.app.diagnose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.Unexplained;
import fieldcal.effect.Effect;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.RobotKickBias;
import fieldcal.effect.motion.WornRegion;
import fieldcal.vision.Epoch;
import fieldcal.vision.Team;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The files of a diagnosis: the contract's names and types, and no number that JSON does not know. */
class DiagnosisFilesTest {
  @TempDir private Path folder;

  private JsonNode written(Diagnosis diagnosis) throws IOException {
    Path file = folder.resolve("diagnosis.json");
    DiagnosisSession.writeJson(SampleOutcome.of(diagnosis, 2), file);
    String text = Files.readString(file);
    assertThat(text).doesNotContain("NaN").doesNotContain("Infinity");
    return new ObjectMapper().readTree(text);
  }

  private static Diagnosis withCauses(Diagnosis d, List<Cause> causes, Quality base) {
    return SampleDiagnosis.with(d, causes, base, List.of());
  }

  private static Cause cause(Effect effect, double scatter) {
    return new Cause(effect, Map.of(), scatter, 10, new Gain(1, 10, 0.5, 1.5), List.of());
  }

  @Test
  void theContractsFieldsAreThere() throws IOException {
    JsonNode root = written(SampleDiagnosis.explained(8));
    assertThat(root.get("schema").textValue()).isEqualTo("fieldcal.diagnosis/1");
    assertThat(root.get("verdict").textValue()).isEqualTo("explained");
    for (String model : List.of("base", "extended")) {
      assertThat(root.get(model).get("rms_mm").isDouble()).isTrue();
      assertThat(root.get(model).get("holdout_rms_mm").isDouble()).isTrue();
      assertThat(root.get(model).get("prediction_error_mm").fieldNames())
          .toIterable()
          .containsExactly("0.5", "1.0", "2.0");
    }
    assertThat(root.get("base").get("noise_mm").doubleValue()).isEqualTo(1.5);
    assertThat(root.get("base").get("prediction_error_mm").get("1.0").doubleValue())
        .isEqualTo(38.2);
    JsonNode offset = root.get("causes").get(0);
    assertThat(offset.get("effect").textValue()).isEqualTo("camera_offset");
    assertThat(offset.get("parameters").fieldNames())
        .toIterable()
        .containsExactly("x_mm", "y_mm", "camera");
    assertThat(offset.get("parameters").get("camera").isInt()).isTrue();
    assertThat(offset.get("standard_errors").get("x_mm").doubleValue()).isEqualTo(0.12);
    assertThat(offset.get("evidence").doubleValue()).isEqualTo(18234);
    assertThat(offset.get("holdout_gain_mm").doubleValue()).isEqualTo(12.1);
    assertThat(offset.get("holdout_gain_percent").doubleValue()).isEqualTo(82.9);
    assertThat(offset.get("indistinguishable_from").get(0).textValue())
        .isEqualTo("camera_offset of camera 0");
    assertThat(offset.get("discriminating_kicks").textValue()).contains("lay a ball on a mark");
    assertThat(root.get("unexplained").get("significant").isBoolean()).isTrue();
    assertThat(root.get("unexplained").get("depends_on").isArray()).isTrue();
  }

  @Test
  void whatWasLearnedHasItsPoints() throws IOException {
    JsonNode root = written(SampleDiagnosis.partly(8));
    assertThat(root.get("verdict").textValue()).isEqualTo("partly_explained");
    JsonNode learned = root.get("learned");
    assertThat(learned).hasSize(5);
    for (JsonNode one : learned) {
      assertThat(one.get("acts_on").textValue()).isIn("ground", "impact", "kick", "measurement");
      assertThat(one.get("depends_on").isArray()).isTrue();
      assertThat(one.get("formula").textValue()).isNotBlank();
      assertThat(one.get("holdout_gain_mm").isDouble()).isTrue();
      assertThat(one.get("holdout_gain_percent").isDouble()).isTrue();
    }
    assertThat(learned.get(0).get("points")).as("of a law").isEmpty();
    assertThat(learned.get(1).get("points").get(3)).hasSize(3);
    assertThat(learned.get(1).get("depends_on").get(0).textValue()).isEqualTo("speed");
    assertThat(learned.get(1).get("camera").isNull()).isTrue();
    assertThat(learned.get(2).get("points").get(3)).hasSize(4);
    assertThat(learned.get(3).get("camera").intValue()).isEqualTo(1);
    assertThat(learned.get(3).get("points")).as("of one component").hasSize(81);
    assertThat(learned.get(3).get("curves")).hasSize(2);
    assertThat(learned.get(3).has("scatter")).isFalse();
    assertThat(learned.get(4).get("scatter").doubleValue()).isEqualTo(0.1);
  }

  @Test
  void learnedTermsAndLawsComeBackWithTheModel() throws IOException {
    Diagnosis d = SampleDiagnosis.partly(4);
    assertThat(d.model().effects()).as("not what is chance").hasSize(5);
    DiagnosisSession.writeAll(SampleOutcome.of(d, 0), folder);
    Path file = folder.resolve("extended_model.json");
    assertThat(ExtendedModelFile.read(file, SampleOutcome.EPOCH)).isEqualTo(d.model());
  }

  @Test
  void moreThanTheContractIsThere() throws IOException {
    JsonNode root = written(SampleDiagnosis.explained(8));
    assertThat(root.get("sources").get(0).textValue()).isEqualTo("friday.log.gz");
    assertThat(root.get("seed").longValue()).isEqualTo(42);
    assertThat(root.get("kicks").get("each")).hasSize(8);
    assertThat(root.get("cameras").get(1).get("noise_mm").isDouble()).isTrue();
    assertThat(root.get("causes").get(0).get("holdout_gain_bounds_mm").get(1).doubleValue())
        .isEqualTo(12.7);
    assertThat(root.get("candidates")).hasSize(SampleDiagnosis.explained(8).candidates().size());
    assertThat(root.get("candidates").get(0).get("score_gain").isNumber()).isTrue();
    assertThat(root.get("structure").get("before").get(0).get("bins")).isNotEmpty();
    assertThat(root.get("problems")).hasSize(2);
  }

  @Test
  void whatIsLeftHasItsVariables() throws IOException {
    JsonNode root = written(SampleDiagnosis.unexplained(8));
    assertThat(root.get("verdict").textValue()).isEqualTo("unexplained_structure");
    assertThat(root.get("unexplained").get("significant").booleanValue()).isTrue();
    assertThat(root.get("unexplained").get("depends_on").get(0).textValue())
        .isEqualTo("time_since_kick");
    assertThat(root.get("causes")).isEmpty();
  }

  /** The contract's field stays the root mean square of all predictions; what the words say stands beside it. */
  @Test
  void typicalErrorsStandBesideTheRootMeanSquare() throws IOException {
    Diagnosis d = SampleDiagnosis.explained(8);
    Quality stray = new Quality(3, 1.5, 4, Map.of(1.0, 1048.7), Map.of(1.0, 54.3));
    JsonNode base = written(withCauses(d, d.causes(), stray)).get("base");
    assertThat(base.get("prediction_error_mm").get("1.0").doubleValue()).isEqualTo(1048.7);
    assertThat(base.get("typical_prediction_error_mm").get("1.0").doubleValue()).isEqualTo(54.3);
    assertThat(base.get("typical_prediction_error_mm").get("2.0").isNull()).isTrue();
  }

  @Test
  void whatIsNotKnownIsNull() throws IOException {
    Diagnosis d = SampleDiagnosis.explained(8);
    Quality few = SampleDiagnosis.quality(3, Double.NaN, Double.NaN, Map.of(0.5, 4.0));
    Gain none = new Gain(Double.NaN, Double.NaN, Double.NaN, Double.POSITIVE_INFINITY);
    Cause cause =
        new Cause(
            d.causes().get(0).effect(),
            Map.of("x_mm", Double.NaN),
            0,
            Double.POSITIVE_INFINITY,
            none,
            List.of());
    JsonNode root = written(withCauses(d, List.of(cause), few));
    assertThat(root.get("base").get("holdout_rms_mm").isNull()).isTrue();
    assertThat(root.get("base").get("prediction_error_mm").get("2.0").isNull()).isTrue();
    assertThat(root.get("causes").get(0).get("holdout_gain_percent").isNull()).isTrue();
    assertThat(root.get("causes").get(0).get("standard_errors").get("x_mm").isNull()).isTrue();
  }

  @Test
  void parametersHaveTheContractsForm() throws IOException {
    List<Cause> causes =
        List.of(
            cause(new WornRegion(0.2, -1, 1.5, 0, 2), 0),
            cause(new RobotKickBias(3, 0.01, Team.BLUE, 4), 0),
            cause(new KickSpin(-0.3), 0.08),
            cause(new KickSpin(-0.3), 0));
    Diagnosis d = SampleDiagnosis.explained(4);
    JsonNode all = written(withCauses(d, causes, d.base())).get("causes");
    assertThat(all.get(0).get("parameters").toString())
        .isEqualTo("{\"change\":0.2,\"region\":[-1.0,1.5,0.0,2.0]}");
    assertThat(all.get(1).get("parameters").toString())
        .isEqualTo("{\"percent\":3.0,\"yaw\":0.01,\"team\":\"blue\",\"robot\":4}");
    assertThat(all.get(2).get("parameters").toString())
        .isEqualTo("{\"fraction\":-0.3,\"scatter\":0.08}");
    assertThat(all.get(3).get("parameters").has("scatter")).isFalse();
  }

  @Test
  void theExtendedModelComesBack() throws IOException {
    Diagnosis d = SampleDiagnosis.explained(4);
    DiagnosisSession.writeAll(SampleOutcome.of(d, 0), folder);
    Path file = folder.resolve("extended_model.json");
    assertThat(ExtendedModelFile.read(file, SampleOutcome.EPOCH)).isEqualTo(d.model());
    assertThat(ExtendedModelFile.read(file, new Epoch(0)).sessionStart())
        .isEqualTo(1_763_712_345.0, within(1e-6));
    assertThat(folder.resolve("diagnosis.json")).isNotEmptyFile();
  }

  @Test
  void unexplainedWithoutNumbersIsNull() throws IOException {
    Diagnosis d = SampleDiagnosis.adequate(4);
    Unexplained unknown = new Unexplained(false, Double.NaN, Double.NaN, List.of());
    Diagnosis bare = SampleDiagnosis.leaving(d, d.extended(), unknown);
    assertThat(written(bare).get("unexplained").get("systematic_mm").isNull()).isTrue();
  }
}
