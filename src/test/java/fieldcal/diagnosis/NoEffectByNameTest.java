package fieldcal.diagnosis;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Fits and diagnosis know effects by their interface alone: what they say of themselves must be enough for any effect that is to come. */
class NoEffectByNameTest {
  @Test
  void noClassUsesAnEffectOfTheCatalogue() throws URISyntaxException {
    JavaClasses library =
        new ClassFileImporter()
            .importPath(
                Path.of(
                    Diagnoser.class.getProtectionDomain().getCodeSource().getLocation().toURI()));
    noClasses()
        .that()
        .resideInAnyPackage("fieldcal.diagnosis..", "fieldcal.fit..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("fieldcal.effect.motion..", "fieldcal.effect.measurement..")
        .check(library);
  }

  @Test
  void noSourceMentionsAnId() throws IOException {
    List<Path> sources = new ArrayList<>();
    Path root =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "src", "main", "java", "fieldcal");
    for (String name : List.of("diagnosis", "fit")) {
      try (Stream<Path> files = Files.walk(root.resolve(name))) {
        files.filter(f -> f.toString().endsWith(".java")).forEach(sources::add);
      }
    }
    assertThat(sources).hasSizeGreaterThan(50);
    for (Path source : sources) {
      String code =
          Files.readString(source).replaceAll("(?s)/\\*.*?\\*/", "").replaceAll("//.*", "");
      for (Effect effect : EffectCatalogue.all()) {
        assertThat(code)
            .as("%s", source)
            .doesNotContainPattern("\"[^\"\\n]*\\b" + effect.id() + "\\b")
            .doesNotContainPattern("\\b" + effect.getClass().getSimpleName() + "\\b");
      }
    }
  }
}
