package fieldcal.archive.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** {@code docs/archive.md} lists the columns that the tables have, word for word. */
class TablesTest {
  private static final Path DOCUMENT =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "docs", "archive.md");

  static Iterable<Table> tables() {
    return Tables.ALL;
  }

  @ParameterizedTest
  @MethodSource("tables")
  void isDocumented(Table table) throws IOException {
    assertThat(Files.readString(DOCUMENT)).contains(section(table));
  }

  private static String section(Table table) {
    StringBuilder text = new StringBuilder();
    text.append("### ").append(table.name()).append("\n\n").append(table.meaning()).append("\n\n");
    text.append("| column | type | unit | missing | meaning |\n|---|---|---|---|---|\n");
    for (Column column : table.columns()) {
      text.append(
          "| `%s` | %s | %s | %s | %s |\n"
              .formatted(
                  column.name(),
                  column.type().name().toLowerCase(Locale.ROOT),
                  column.unit(),
                  column.nullable() ? "may be" : "never",
                  column.meaning()));
    }
    return text.toString();
  }
}
