package fieldcal.app.hardening;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A little of {@link ParserFuzz} for every parser; {@code ./gradlew parserFuzz} runs more. */
class ParserFuzzTest {
  /** Half a minute on a busy machine for all parsers together. */
  private static final int INPUTS = 2_000;

  @TempDir private static Path scratch;

  @Test
  void whatBrokeAParserOnceDoesNotAgain() throws IOException {
    Path project = Path.of(System.getProperty("fieldcal.projectDir", "."));
    try (ParserFuzz fuzz = new ParserFuzz(project, scratch)) {
      Path found = project.resolve("src/test/resources/fieldcal/app/hardening/found");
      assertThat(fuzz.runFound(found)).isPositive();
    }
  }

  @Test
  void everyParserEndsWithOneLine() throws IOException {
    try (ParserFuzz fuzz =
        new ParserFuzz(Path.of(System.getProperty("fieldcal.projectDir", ".")), scratch)) {
      assertThat(fuzz.names()).hasSize(31);
      for (String name : fuzz.names()) {
        // The first input is good, so that a parser that refuses everything is noticed.
        assertThat(fuzz.run(name, 1, INPUTS).read()).as(name).isPositive();
      }
    }
  }
}
