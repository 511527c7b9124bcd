package fieldcal;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaType;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What hosts may rely on is complete: no public signature leads out of the public packages. */
class PublicApiTest {

  private static final String MESSAGES = "fieldcal.proto.";

  /** What signatures may have besides public types: the JDK, and the league's messages, whose fields the league keeps. No type of another library. */
  private static final List<String> ALSO = List.of("java.", MESSAGES);

  private static final JavaClasses LIBRARY =
      new ClassFileImporter().importPath(ArchitectureTest.libraryClasses());

  @Test
  void publicSignaturesHavePublicTypesOnly() {
    TreeSet<String> leaks = new TreeSet<>();
    forEachShown(
        (member, shown) -> {
          if (ALSO.stream().noneMatch(shown.getName()::startsWith) && !isPublicApi(shown)) {
            leaks.add(member.getFullName() + " shows " + shown.getName());
          }
        });
    assertThat(leaks).isEmpty();
  }

  @Test
  void theDocumentNamesTheMessagesThatAreShown() throws IOException {
    Path document = Path.of(System.getProperty("fieldcal.projectDir", "."), "docs/library.md");
    TreeSet<String> messages = new TreeSet<>();
    forEachShown(
        (member, shown) -> {
          if (shown.getName().startsWith(MESSAGES)) {
            messages.add(
                "`" + shown.getName().substring(MESSAGES.length()).replace('$', '.') + "`");
          }
        });
    assertThat(messages).isNotEmpty();
    assertThat(Files.readString(document)).contains(messages);
  }

  private static void forEachShown(BiConsumer<JavaMember, JavaClass> look) {
    for (JavaClass type : LIBRARY) {
      if (!isPublicApi(type) || !isVisible(type)) {
        continue;
      }
      Stream<JavaMember> members =
          Stream.concat(type.getFields().stream(), type.getCodeUnits().stream());
      for (JavaMember member : members.filter(PublicApiTest::isVisible).toList()) {
        for (JavaClass used : typesOf(member)) {
          JavaClass element = used.getBaseComponentType();
          if (!element.isPrimitive()) {
            look.accept(member, element);
          }
        }
      }
    }
  }

  @Test
  void packagesAreMarked() {
    assertThat(LIBRARY.getPackage("fieldcal.ball").isAnnotatedWith(PublicApi.class)).isTrue();
    assertThat(LIBRARY.getPackage("fieldcal.diagnosis").isAnnotatedWith(PublicApi.class)).isFalse();
  }

  private static boolean isPublicApi(JavaClass type) {
    return type.getPackage().isAnnotatedWith(PublicApi.class);
  }

  private static boolean isVisible(JavaClass type) {
    return type.getModifiers().contains(JavaModifier.PUBLIC)
        || type.getModifiers().contains(JavaModifier.PROTECTED);
  }

  private static boolean isVisible(JavaMember member) {
    return !member.getModifiers().contains(JavaModifier.SYNTHETIC)
        && (member.getModifiers().contains(JavaModifier.PUBLIC)
            || member.getModifiers().contains(JavaModifier.PROTECTED));
  }

  private static List<JavaClass> typesOf(JavaMember member) {
    List<JavaType> types = new ArrayList<>();
    if (member instanceof JavaCodeUnit unit) {
      types.add(unit.getReturnType());
      types.addAll(unit.getParameterTypes());
      types.addAll(unit.getExceptionTypes());
    } else {
      types.add(((JavaField) member).getType());
    }
    return types.stream().flatMap(type -> type.getAllInvolvedRawTypes().stream()).toList();
  }
}
