package fieldcal.app.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.export.TargetsTest.Sample;
import fieldcal.app.export.format.BaseFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Files that cannot be edited give one clear error with file and place, and never a damaged file. */
class BadBaseTest {

  static Stream<Sample> samples() {
    return TargetsTest.samples();
  }

  private static String text(Sample sample) throws IOException {
    return BaseFile.read(TargetsTest.file(sample.base())).text();
  }

  private static Sample sample(String base) {
    return samples().filter(s -> s.base().equals(base)).findFirst().orElseThrow();
  }

  private static void refused(Sample sample, String text, String... words) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    assertThatThrownBy(() -> sample.exporter().into(BaseFile.of("the/base", bytes)))
        .isInstanceOf(InputException.class)
        .message()
        .startsWith("the/base")
        .doesNotContain("\n")
        .satisfies(m -> assertThat(List.of(words)).allSatisfy(w -> assertThat(m).contains(w)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ssl-vision-processor.yml|    k_switch:   0.64\\n",
        "ssl-vision.xml|<Var name=\"Switch factor\" type=\"double\" minval=\"0.000000\""
            + " maxval=\"1.000000\">0.700000</Var>",
        "geometry-text.txt|        k_switch: 0.64\\n",
        "sumatra-robots.json|\"accMax\": 3.0, \"brkMax\": 6.0e0, ",
        "immortals.toml|inertia_distribution = 0.5\\n",
        "grsim-robots.ini|VelAbsoluteMax=5\\n",
        "erforce-tracker.txt|switch_ratio: 0.7\\n",
        "robot-specs.yaml|      vel_absolute_max: 3.7   # 🤖 rather fast\\n"
      })
  void aMissingKeyIsNamed(String base, String line) throws IOException {
    Sample sample = sample(base);
    String whole = text(sample);
    String wanted = line.replace("\\n", "\n");
    assertThat(whole).contains(wanted.strip());
    refused(sample, whole.replace(wanted.strip(), ""), " has no ");
  }

  @Test
  void aMissingKeyIsNamedWithThePlaceWhereItShouldBe() throws IOException {
    Sample sample = sample("ssl-vision-processor.yml");
    refused(
        sample,
        text(sample).replace("    k_switch:   0.64\n", ""),
        "line 16",
        "models.straight_two_phase has no k_switch");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ssl-vision-processor.yml|k_switch:   0.64|k_switch: 0.64\\n    k_switch: 0.7|line 18",
        "geometry-text.txt|k_switch: 0.64|k_switch: 0.64\\n k_switch: 0.7|line 44",
        "sumatra-robots.json|\"brkMax\": 6.0e0|\"brkMax\": 6.0, \"brkMax\": 7|line 15",
        "grsim-robots.ini|VelAbsoluteMax=5|VelAbsoluteMax=5\\nVelAbsoluteMax=6|line 14",
        "erforce-tracker.txt|switch_ratio: 0.7|switch_ratio: 0.7\\nswitch_ratio: 0.6|line 3",
        "sumatra.xml|<minHopHeight|<kSwitch:ROBOCUP>1</kSwitch:ROBOCUP><minHopHeight|line 8"
      })
  void aKeyThatIsThereTwiceIsNamed(String base, String once, String twice, String line)
      throws IOException {
    Sample sample = sample(base);
    String changed = text(sample).replace(once, twice.replace("\\n", "\n"));
    assertThat(changed).isNotEqualTo(text(sample));
    refused(sample, changed, "twice", line);
  }

  @Test
  void tomlItselfForbidsAKeyTwice() throws IOException {
    Sample sample = sample("immortals.toml");
    refused(
        sample,
        text(sample).replace("acc_slide = -3.3", "acc_slide = -3.3\nacc_slide = -3"),
        "line 9",
        "acc_slide");
  }

  @ParameterizedTest
  @MethodSource("samples")
  void binaryIsRefused(Sample sample) throws IOException {
    byte[] bytes = {10, 27, 9, 0, 0, 1};
    assertThatThrownBy(() -> BaseFile.of("the/base", bytes))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("the/base, byte 3")
        .hasMessageContaining("binary");
    refused(sample, "");
  }

  @ParameterizedTest
  @MethodSource("samples")
  void fileOfAnotherFormIsRefused(Sample sample) throws IOException {
    for (Sample other : samples().toList()) {
      if (!other.exporter().file().form().equals(sample.exporter().file().form())) {
        refused(sample, text(other));
      }
    }
  }

  @Test
  void valueThatIsNoNumberIsNotReplaced() throws IOException {
    Sample sample = sample("ssl-vision-processor.yml");
    refused(
        sample, text(sample).replace("-3.40", "fast"), "line 16", "should be a number", "'fast'");
  }

  @Test
  void aValueSharedByTwoKeysIsNotReplaced() throws IOException {
    Sample sample = sample("ssl-vision-processor.yml");
    refused(
        sample,
        text(sample)
            .replace("-3.40", "&slow -3.40")
            .replace("\"acc_roll\": -0.45", "\"acc_roll\": *slow"),
        "shares its value");
  }

  @Test
  void nothingOutsideTheFileIsRead() throws IOException {
    Sample sample = sample("ssl-vision.xml");
    String bomb = "<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/passwd\">]>";
    refused(sample, bomb + "<VarXML>&e;</VarXML>");
  }

  /** 2,000 damaged files: an error that names the file, or a file in which the values are. */
  @Test
  void damagedFilesNeverCauseADefect() throws IOException {
    Random random = new Random(20260101);
    for (Sample sample : samples().toList()) {
      byte[] good = Files.readAllBytes(TargetsTest.file(sample.base()));
      Exporter exporter = sample.exporter();
      for (int i = 0; i < 200; i++) {
        byte[] bad = good.clone();
        int edits = 1 + random.nextInt(4);
        for (int k = 0; k < edits; k++) {
          bad[random.nextInt(bad.length)] = (byte) random.nextInt(256);
        }
        try {
          exporter.into(BaseFile.of("the/base", bad));
        } catch (InputException e) {
          assertThat(e.getMessage()).startsWith("the/base");
        }
      }
    }
  }
}
