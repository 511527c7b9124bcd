package fieldcal;

import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaConstructorCall;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.library.GeneralCodingRules;
import fieldcal.ball.BallState;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.AbstractCollection;
import java.util.AbstractMap;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.apache.commons.math3.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Who may use whom in the library, and what none of it may do. A new package gets a row here first. */
class ArchitectureTest {

  /** Each package of the library, and the packages it may use besides its own, its subpackages, the JDK and the two libraries. */
  private static final Map<String, List<String>> MAY_USE =
      Map.ofEntries(
          Map.entry("ball", List.of()),
          Map.entry("camera", List.of()),
          Map.entry("vision", List.of("camera", "ball", "proto")),
          Map.entry("gamelog", List.of("vision", "camera", "ball", "proto")),
          Map.entry("kick", List.of("vision", "camera")),
          Map.entry("fit", List.of("kick", "ball", "camera", "vision")),
          Map.entry("calibration", List.of("fit", "effect", "kick", "ball", "camera", "vision")),
          Map.entry("effect", List.of("ball", "camera", "kick", "vision")),
          Map.entry(
              "diagnosis",
              List.of("effect", "fit", "calibration", "kick", "ball", "camera", "vision")),
          Map.entry(
              "verdict",
              List.of(
                  "calibration", "diagnosis", "effect", "fit", "kick", "ball", "camera", "vision")),
          Map.entry("movement", List.of("vision")),
          Map.entry("live", List.of("fit", "kick", "movement", "ball", "camera", "vision")),
          Map.entry("play", List.of("vision")),
          Map.entry("simulation", List.of("camera", "vision")));

  /** Subpackages that may use less than the package they are in, or other parts of it: each with all that it may use of this library, besides its own. */
  private static final Map<String, List<String>> SUBPACKAGES =
      Map.ofEntries(
          Map.entry("fit.joint", List.of("ball")),
          Map.entry(
              "diagnosis.model",
              List.of("effect", "fit..", "calibration", "kick", "ball", "camera", "vision")),
          Map.entry(
              "diagnosis.search",
              List.of(
                  "diagnosis.model",
                  "effect",
                  "fit..",
                  "calibration",
                  "kick",
                  "ball",
                  "camera",
                  "vision")));

  /** Types whose static constants would be shared state. */
  private static final List<Class<?>> MUTABLE =
      List.of(
          AbstractCollection.class,
          AbstractMap.class,
          StringBuilder.class,
          Random.class,
          RandomGenerator.class,
          ThreadLocal.class,
          AtomicBoolean.class,
          AtomicInteger.class,
          AtomicLong.class,
          AtomicReference.class);

  private static final JavaClasses LIBRARY = new ClassFileImporter().importPath(libraryClasses());

  static Set<String> packages() {
    return new TreeSet<>(MAY_USE.keySet());
  }

  @ParameterizedTest
  @MethodSource("packages")
  void dependsOnlyOnItsRow(String name) {
    List<String> allowed =
        new ArrayList<>(
            List.of(
                "java..",
                "org.apache.commons.math3..",
                "com.google.protobuf..",
                "fieldcal",
                "fieldcal." + name + ".."));
    MAY_USE.get(name).forEach(other -> allowed.add("fieldcal." + other + ".."));
    classes()
        .that()
        .resideInAPackage("fieldcal." + name + "..")
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage(allowed.toArray(String[]::new))
        .allowEmptyShould(true)
        .check(LIBRARY);
  }

  static Set<String> subpackages() {
    return new TreeSet<>(SUBPACKAGES.keySet());
  }

  @ParameterizedTest
  @MethodSource("subpackages")
  void aSubpackageDependsOnlyOnItsRow(String name) {
    List<String> allowed =
        new ArrayList<>(
            List.of("java..", "org.apache.commons.math3..", "fieldcal", "fieldcal." + name));
    SUBPACKAGES.get(name).forEach(other -> allowed.add("fieldcal." + other));
    classes()
        .that()
        .resideInAPackage("fieldcal." + name)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage(allowed.toArray(String[]::new))
        .check(LIBRARY);
  }

  /** Effects describe themselves: who searches, fits or designs never asks which one it has before it. */
  @Test
  void noEffectIsKnownByItsClass() {
    noClasses()
        .that()
        .resideInAnyPackage("fieldcal.diagnosis..", "fieldcal.fit..", "fieldcal.design..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("fieldcal.effect.motion..", "fieldcal.effect.measurement..")
        .check(LIBRARY);
  }

  @Test
  void everyPackageHasARow() {
    Set<String> found = new TreeSet<>();
    for (JavaClass type : LIBRARY) {
      if (type.getPackageName().equals("fieldcal")) {
        continue; // what marks packages
      }
      found.add(type.getPackageName().replaceFirst("^fieldcal\\.([^.]+).*$", "$1"));
    }
    assertThat(found).isNotEmpty().isSubsetOf(MAY_USE.keySet());
  }

  @Test
  void rowsHaveNoLoop() {
    Set<String> placed = new TreeSet<>(Set.of("proto"));
    boolean grows = true;
    while (grows) {
      grows = false;
      for (String name : packages()) {
        grows |= placed.containsAll(MAY_USE.get(name)) && placed.add(name);
      }
    }
    assertThat(placed).containsAll(packages());
  }

  @ParameterizedTest
  @ValueSource(strings = {"main", "app"})
  void everyPackageSaysWhatIsInIt(String set) throws Exception {
    Path sources = Path.of(System.getProperty("fieldcal.projectDir", "."), "src", set, "java");
    try (var files = Files.walk(sources)) {
      assertThat(
              files
                  .filter(file -> file.toString().endsWith(".java"))
                  .map(Path::getParent)
                  .distinct())
          .isNotEmpty()
          .allSatisfy(folder -> assertThat(folder.resolve("package-info.java")).exists());
    }
  }

  @Test
  void standardStreamsAreNotUsed() {
    GeneralCodingRules.NO_CLASSES_SHOULD_ACCESS_STANDARD_STREAMS.check(LIBRARY);
  }

  @Test
  void timeRandomnessAndEnvironmentComeInByConstructor() {
    noClasses()
        .should()
        .callMethodWhere(
            target(owner(assignableTo(System.class)))
                .and(target(nameMatching("currentTimeMillis|nanoTime|getenv|getProperty|exit"))))
        .orShould()
        .callMethodWhere(
            target(owner(inPackage("java.time"))).and(target(nameMatching("now|system.*"))))
        .orShould()
        .callMethodWhere(
            target(owner(assignableTo(Math.class))).and(target(nameMatching("random"))))
        .orShould()
        .dependOnClassesThat()
        .areAssignableTo(ThreadLocalRandom.class)
        .orShould()
        .callConstructorWhere(
            DescribedPredicate.describe(
                "make a generator without a seed", ArchitectureTest::isUnseeded))
        .check(LIBRARY);
  }

  @Test
  void staticFieldsAreConstants() {
    fields().that().areStatic().should().beFinal().check(LIBRARY);
    var written = fields().that().areStatic().and().doNotHaveModifier(JavaModifier.SYNTHETIC);
    written
        .should()
        .haveRawType(
            DescribedPredicate.describe(
                "immutable or an array", type -> MUTABLE.stream().noneMatch(type::isAssignableTo)))
        .allowEmptyShould(true)
        .check(LIBRARY);
    written
        .and()
        .haveRawType(DescribedPredicate.describe("array", JavaClass::isArray))
        .should()
        .bePrivate()
        .allowEmptyShould(true)
        .check(LIBRARY);
  }

  @Test
  void typesAreNamedAfterWhatTheyAre() {
    noClasses()
        .that()
        .areTopLevelClasses()
        .should()
        .haveSimpleNameEndingWith("Impl")
        .check(LIBRARY);
  }

  private static boolean isUnseeded(JavaConstructorCall call) {
    JavaClass made = call.getTargetOwner();
    return call.getTarget().getRawParameterTypes().isEmpty()
        && (made.isEquivalentTo(Random.class) || made.isAssignableTo(RandomGenerator.class));
  }

  private static DescribedPredicate<JavaClass> inPackage(String name) {
    return DescribedPredicate.describe("in " + name, type -> type.getPackageName().equals(name));
  }

  static Path libraryClasses() {
    try {
      return Path.of(BallState.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
