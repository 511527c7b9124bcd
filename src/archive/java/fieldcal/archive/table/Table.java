package fieldcal.archive.table;

import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Objects;

/**
 * A table: its name, which is that of its folder, and its columns. The columns {@code tournament} and {@code match} are not among them: they are in the names of the folders.
 *
 * @param name of the table
 * @param meaning what a row is
 * @param columns in order
 */
public record Table(String name, String meaning, List<Column> columns) {

  /** Copies the list. {@inheritDoc} */
  public Table {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(meaning, "meaning");
    columns = List.copyOf(columns);
  }

  /** Collects the columns of a table. */
  public static final class Builder {
    private final String name;
    private final String meaning;
    private final List<Column> columns = new ArrayList<>();

    Builder(String name, String meaning) {
      this.name = name;
      this.meaning = meaning;
    }

    Builder always(ColumnType type, String column, String unit, String what) {
      columns.add(new Column(column, type, unit, false, what));
      return this;
    }

    Builder maybe(ColumnType type, String column, String unit, String what) {
      columns.add(new Column(column, type, unit, true, what));
      return this;
    }

    /** A number and its standard error. */
    Builder estimate(String column, String unit, String what) {
      maybe(ColumnType.DOUBLE, column, unit, what);
      return maybe(ColumnType.DOUBLE, column + "_error", unit, "standard error of " + column);
    }

    Table build() {
      return new Table(name, meaning, columns);
    }
  }

  /**
   * Where a column is.
   *
   * @param column its name
   * @return from 0 on
   * @throws NoSuchElementException when there is none of that name
   */
  public int index(String column) {
    for (int i = 0; i < columns.size(); i++) {
      if (columns.get(i).name().equals(column)) {
        return i;
      }
    }
    throw new NoSuchElementException("table " + name + " has no column " + column);
  }

  /**
   * A row without values.
   *
   * @return to be filled
   */
  public Row row() {
    return new Row(this);
  }
}
