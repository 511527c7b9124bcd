package fieldcal.app;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import fieldcal.app.cli.Main;
import java.net.URISyntaxException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Who may use whom in the operator's tools: nobody in a circle, and nobody what an operator types or sees. */
class AppArchitectureTest {
  private static final JavaClasses TOOLS = new ClassFileImporter().importPath(tools());

  private static Path tools() {
    try {
      return Path.of(Main.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void noPackageIsInACircle() {
    slices().matching("fieldcal.app.(**)").should().beFreeOfCycles().check(TOOLS);
  }

  @Test
  void nobodyUsesTheCommandLine() {
    noClasses()
        .that()
        .resideOutsideOfPackage("fieldcal.app.cli..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("fieldcal.app.cli..", "picocli..")
        .check(TOOLS);
  }

  @Test
  void onlyTheCommandLineUsesTheConsole() {
    noClasses()
        .that()
        .resideOutsideOfPackages("fieldcal.app.cli..", "fieldcal.app.console..")
        .should()
        .dependOnClassesThat()
        .resideInAPackage("fieldcal.app.console..")
        .check(TOOLS);
  }

  /** A match is heard, a play goes on and a log is written without anything that reads or shows results. */
  @Test
  void theNetworkKnowsNothingOfResults() {
    classes()
        .that()
        .resideInAPackage("fieldcal.app.net..")
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage(
            "java..",
            "com.google.protobuf..",
            "fieldcal",
            "fieldcal.app.net..",
            "fieldcal.gamelog..",
            "fieldcal.vision..",
            "fieldcal.proto..")
        .check(TOOLS);
  }
}
