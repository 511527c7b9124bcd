package fieldcal.app.hardening;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A little of {@link ParserFuzz} for every parser; {@code ./gradlew parserFuzz} runs more. */
class ParserFuzzTest {
  /** About a minute for all parsers together, on two cores that do little else. */
  private static final int INPUTS = 2_000;

  private static final Path PROJECT = Path.of(System.getProperty("fieldcal.projectDir", "."));

  @TempDir private static Path scratch;

  private static ParserFuzz fuzz;

  @BeforeAll
  static void gather() throws IOException {
    fuzz = new ParserFuzz(PROJECT, scratch);
  }

  @AfterAll
  static void close() throws IOException {
    fuzz.close();
  }

  @Test
  void whatBrokeAParserOnceDoesNotAgain() throws IOException {
    Path found = PROJECT.resolve("src/test/resources/fieldcal/app/hardening/found");
    assertThat(fuzz.runFound(found)).isPositive();
  }

  @Test
  void everyParserEndsWithOneLine() {
    assertThat(fuzz.names()).hasSize(40);
    for (String name : fuzz.names()) {
      // The first input is good, so that a parser that refuses everything is noticed.
      assertThat(fuzz.run(name, 1, INPUTS).read()).as(name).isPositive();
    }
  }
}
