package fieldcal.archive.table;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is written is what is read, and the same rows are the same bytes. */
class ParquetFileTest {
  private static final Table TABLE =
      new Table.Builder("test", "Everything.")
          .always(ColumnType.TEXT, "name", "", "")
          .always(ColumnType.INT, "number", "", "")
          .maybe(ColumnType.DOUBLE, "value", "m", "")
          .maybe(ColumnType.BOOLEAN, "flag", "", "")
          .maybe(ColumnType.TIME, "time", "", "")
          .maybe(ColumnType.LONG, "count", "", "")
          .maybe(ColumnType.INTS, "list", "", "")
          .build();

  @TempDir private Path folder;

  private static List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    for (int i = 0; i < 3000; i++) {
      Row row = TABLE.row().set("name", "Zwölf " + i % 7).set("number", i);
      if (i % 2 == 0) {
        row.set("value", Math.sqrt(i)).set("flag", i % 4 == 0).set("time", 1_763_712_345_123_456L);
      } else {
        row.set("count", (long) i << 33).set("list", List.of(i, -i));
      }
      rows.add(row);
    }
    return rows;
  }

  @Test
  void rowsComeBack() throws IOException {
    Path file = folder.resolve("a.parquet");
    ParquetFile.write(TABLE, rows(), file);
    List<Row> read = ParquetFile.read(TABLE, file);
    List<Row> expected = rows();
    assertThat(read).hasSameSizeAs(expected);
    for (int i = 0; i < expected.size(); i++) {
      for (Column column : TABLE.columns()) {
        assertThat(read.get(i).get(column.name())).isEqualTo(expected.get(i).get(column.name()));
      }
    }
  }

  /** The bytes as written by another process, whose hash codes of enums are others. */
  @Test
  void encodingsAreInOrder() throws IOException {
    Path file = folder.resolve("a.parquet");
    ParquetFile.write(TABLE, rows(), file);
    byte[] bytes = Files.readAllBytes(file);
    int length =
        java.nio.ByteBuffer.wrap(bytes)
            .order(java.nio.ByteOrder.LITTLE_ENDIAN)
            .getInt(bytes.length - 8);
    var footer =
        org.apache.parquet.format.Util.readFileMetaData(
            new java.io.ByteArrayInputStream(bytes, bytes.length - 8 - length, length));
    assertThat(footer.getRow_groups()).isNotEmpty();
    footer
        .getRow_groups()
        .forEach(
            group ->
                group
                    .getColumns()
                    .forEach(c -> assertThat(c.getMeta_data().getEncodings()).isSorted()));
  }

  @Test
  void missingIsMissing() {
    Row row = TABLE.row().set("value", Double.NaN).set("flag", Optional.empty());
    assertThat(row.get("value")).isNull();
    assertThat(row.number("value")).isNaN();
    assertThatThrownBy(() -> row.set("name", null)).hasMessageContaining("must not be missing");
    assertThatThrownBy(() -> row.set("number", 1.5)).hasMessageContaining("is INT, not 1.5");
    assertThatThrownBy(() -> ParquetFile.write(TABLE, List.of(row), folder.resolve("b.parquet")))
        .hasMessageContaining("column name of test is missing");
  }

  @Test
  void aDamagedFileIsAnError() throws IOException {
    Path file = Files.writeString(folder.resolve("a.parquet"), "no parquet at all");
    assertThatThrownBy(() -> ParquetFile.read(TABLE, file))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("a.parquet: cannot be read");
    ParquetFile.write(TABLE, rows(), file);
    assertThatThrownBy(() -> ParquetFile.read(Tables.KICKS, file))
        .hasMessageContaining("is not a file of table kicks");
  }
}
