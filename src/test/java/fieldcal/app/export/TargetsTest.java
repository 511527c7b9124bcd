package fieldcal.app.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.export.Target.Key;
import fieldcal.app.export.Target.TargetFile;
import fieldcal.app.export.format.BaseFile;
import fieldcal.app.export.format.Editor.Change;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every target: a file as a team has it comes out byte for byte but for the values, and another reader finds these values. */
class TargetsTest {
  /** Written are six digits. */
  private static final double ROUNDING = 1e-5;

  /** A file of a target with the model that goes there. */
  record Sample(String target, String base, String model, String entry, String team) {
    @Override
    public String toString() {
      return base;
    }

    String golden() {
      return base.replaceFirst("\\.[a-z]+$", ".golden");
    }

    Exporter exporter() throws IOException {
      ExportModel read = ExportModel.read(file(model));
      if (target.equals("immortals")) {
        read = read.beside(ExportModel.read(file("limits.json")));
      }
      return new Exporter(
          Target.of(target), read, Optional.ofNullable(team), Optional.ofNullable(entry));
    }
  }

  static Stream<Sample> samples() {
    String ball = "calibration.json";
    String robots = "limits.json";
    return Stream.of(
        new Sample("ssl-vision-processor", "ssl-vision-processor.yml", ball, null, null),
        new Sample("ssl-vision", "ssl-vision.xml", ball, null, null),
        new Sample("geometry-text", "geometry-text.txt", ball, null, null),
        new Sample("sumatra", "sumatra.xml", ball, null, null),
        new Sample("sumatra", "sumatra-robots.json", robots, "TIGERs v2020", "yellow"),
        new Sample("erforce-tracker", "erforce-tracker.txt", ball, null, null),
        new Sample("erforce-realism", "erforce-realism.txt", ball, null, null),
        new Sample("erforce-realism", "erforce-cameras.txt", "twin.json", null, null),
        new Sample("immortals", "immortals.toml", ball, null, null),
        new Sample("grsim", "grsim.xml", ball, null, null),
        new Sample("grsim", "grsim-robots.ini", robots, null, "blue"),
        new Sample("robot-specs", "robot-specs.yaml", robots, "RobôCin", "yellow"));
  }

  static Path file(String name) {
    return Path.of(
        System.getProperty("fieldcal.projectDir", "."),
        "src/test/resources/fieldcal/app/export",
        name);
  }

  @Test
  void everyFileOfEveryTargetHasASample() {
    Set<String> all = new TreeSet<>();
    for (String name : Target.names()) {
      Target.of(name).files().forEach(f -> all.add(name + " " + f.file()));
    }
    Set<String> sampled =
        samples()
            .map(
                s -> {
                  try {
                    return s.target() + " " + s.exporter().file().file();
                  } catch (IOException e) {
                    throw new AssertionError(e);
                  }
                })
            .collect(Collectors.toCollection(TreeSet::new));
    assertThat(sampled).isEqualTo(all);
  }

  @ParameterizedTest
  @MethodSource("samples")
  void onlyTheValuesChange(Sample sample) throws IOException {
    Export export = sample.exporter().into(BaseFile.read(file(sample.base())));
    assertThat(export.bytes()).isEqualTo(Files.readAllBytes(file(sample.golden())));
  }

  @ParameterizedTest
  @MethodSource("samples")
  void anotherReaderFindsTheValues(Sample sample) throws Exception {
    Exporter exporter = sample.exporter();
    Export export = exporter.into(BaseFile.read(file(sample.base())));
    check(sample, exporter, export);
  }

  @ParameterizedTest
  @MethodSource("samples")
  void anotherReaderFindsTheValuesOfANewFile(Sample sample) throws Exception {
    Exporter exporter = sample.exporter();
    if (!exporter.file().newFile().startsWith("refuse: ")) {
      check(sample, exporter, exporter.fresh());
    }
  }

  /** The expected value comes from the model, the descriptor's factor and the range alone. */
  private static void check(Sample sample, Exporter exporter, Export export) throws Exception {
    TargetFile descriptor = exporter.file();
    ExportModel model = ExportModel.read(file(sample.model()));
    if (sample.target().equals("immortals")) {
      model = model.beside(ExportModel.read(file("limits.json")));
    }
    ExportModel ofTeam = sample.team() == null ? model : model.ofTeam(sample.team());
    int found = 0;
    for (Key key : descriptor.keys()) {
      if (ofTeam.quantities().of(key.quantity()).isEmpty()) {
        continue;
      }
      double value =
          key.factor() * ofTeam.quantities().of(key.quantity()).getAsDouble() / key.divisor();
      double taken = Math.min(key.max(), Math.max(key.min(), value));
      String entry = sample.entry() == null ? descriptor.entry() : sample.entry();
      List<String> path =
          key.path().stream().map(n -> entry == null ? n : n.replace("{entry}", entry)).toList();
      assertThat(IndependentReaders.read(descriptor.form(), export.bytes(), path))
          .as("%s", path)
          .isCloseTo(taken, within(ROUNDING * Math.abs(taken)));
      found++;
    }
    assertThat(found).isEqualTo(export.changes().size()).isGreaterThan(1);
  }

  @ParameterizedTest
  @MethodSource("samples")
  void exportingTwiceChangesNothingMore(Sample sample) throws IOException {
    byte[] once = Files.readAllBytes(file(sample.golden()));
    Export again = sample.exporter().into(BaseFile.of("golden", once));
    assertThat(again.bytes()).isEqualTo(once);
    assertThat(again.changes())
        .allSatisfy(c -> assertThat(c.before()).isEqualTo(c.setting().text()));
  }

  @Test
  void theOldValuesAreShown() throws IOException {
    Sample sample = samples().findFirst().orElseThrow();
    Export export = sample.exporter().into(BaseFile.read(file(sample.base())));
    assertThat(export.changes().stream().map(Change::before))
        .containsExactly("-3.40", "-0.45", "0.64", "0.55", ".88", "5.4e-1");
  }

  /** An operator enters the values by hand, under the names that SSL-Vision shows. */
  @Test
  void theOperatorsGuideHasTheNamesOfSslVision() throws IOException {
    String guide =
        Files.readString(
            Path.of(System.getProperty("fieldcal.projectDir", "."), "docs", "operator.md"));
    for (TargetFile file : Target.of("ssl-vision").files()) {
      for (Key key : file.keys()) {
        int last = key.path().size() - 1;
        assertThat(guide)
            .contains(
                "| `"
                    + key.quantity()
                    + "` | "
                    + key.path().get(last - 1)
                    + " | "
                    + key.path().get(last)
                    + " |");
      }
    }
  }

  @Test
  void everyDescriptorSaysWhereItsKeysWereRead() {
    for (String name : Target.names()) {
      for (TargetFile file : Target.of(name).files()) {
        assertThat(file.isVerified()).as(name).isEqualTo(!file.verified().isEmpty());
      }
    }
  }

  @Test
  void whatIsNotPublicIsCalledUnverified() throws IOException {
    assertThat(new Sample("sumatra", "", "calibration.json", null, null).exporter().notes())
        .first()
        .asString()
        .startsWith("UNVERIFIED");
  }

  @Test
  void otherCharactersThanUtf8Survive() throws IOException {
    BaseFile base = BaseFile.read(file("ssl-vision.xml"));
    assertThat(base.charset()).isEqualTo(StandardCharsets.ISO_8859_1);
  }
}
