package fieldcal.archive.table;

import java.util.Objects;

/**
 * One column of a table.
 *
 * @param name lower case with underscores
 * @param type what it holds
 * @param unit of its numbers; empty where there is none
 * @param nullable whether a value may be missing
 * @param meaning for people; for a nullable column also when it is missing
 */
public record Column(String name, ColumnType type, String unit, boolean nullable, String meaning) {

  /** Checks that nothing is missing. {@inheritDoc} */
  public Column {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(type, "type");
    Objects.requireNonNull(unit, "unit");
    Objects.requireNonNull(meaning, "meaning");
  }
}
