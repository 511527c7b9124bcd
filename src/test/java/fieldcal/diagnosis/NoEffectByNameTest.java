package fieldcal.diagnosis;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Fits and diagnosis know effects by their interface alone: what they say of themselves must be enough for any effect that is to come. */
class NoEffectByNameTest {
  private static final JavaClasses LIBRARY =
      new ClassFileImporter()
          .withImportOption(new ImportOption.DoNotIncludeTests())
          .importPackages("fieldcal");

  @Test
  void noClassUsesAnEffectOfTheCatalogue() {
    assertThat(LIBRARY.contain(Diagnoser.class)).isTrue();
    noClasses()
        .that()
        .resideInAnyPackage("fieldcal.diagnosis..", "fieldcal.fit..")
        .and(
            com.tngtech.archunit.base.DescribedPredicate.describe(
                "belong to the library", NoEffectByNameTest::isOfTheLibrary))
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("fieldcal.effect.motion..", "fieldcal.effect.measurement..")
        .check(LIBRARY);
  }

  private static boolean isOfTheLibrary(com.tngtech.archunit.core.domain.JavaClass type) {
    return sources().stream()
        .anyMatch(
            s ->
                s.toString()
                    .replace(java.io.File.separatorChar, '.')
                    .endsWith(outermost(type.getName()) + ".java"));
  }

  private static String outermost(String name) {
    return name.replaceFirst("\\$.*$", "");
  }

  private static List<Path> sources() {
    Path root =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "src", "main", "java", "fieldcal");
    try (var diagnosis = Files.walk(root.resolve("diagnosis"));
        var fit = Files.walk(root.resolve("fit"))) {
      return java.util.stream.Stream.concat(diagnosis, fit)
          .filter(f -> f.toString().endsWith(".java"))
          .toList();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  @Test
  void noSourceMentionsAnId() throws IOException {
    List<Path> sources = sources();
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
