package fieldcal.archive.table;

import java.util.List;
import java.util.Optional;

/** One row of a table, by the names of its columns. What is not a finite number is missing. Mutable, for one thread. */
public final class Row {
  private final Table table;
  private final Object[] values;

  Row(Table table) {
    this.table = table;
    values = new Object[table.columns().size()];
  }

  /**
   * Sets a value.
   *
   * @param column its name
   * @param value of the column's type; null, an empty optional and NaN are missing values
   * @return this row
   * @throws IllegalArgumentException when the column has another type, or may not be missing
   */
  public Row set(String column, Object value) {
    int index = table.index(column);
    Column its = table.columns().get(index);
    Object plain = plain(value);
    if (plain == null && !its.nullable()) {
      throw new IllegalArgumentException(
          "column " + column + " of " + table.name() + " must not be missing");
    }
    if (plain != null && !fits(its.type(), plain)) {
      throw new IllegalArgumentException(
          "column " + column + " of " + table.name() + " is " + its.type() + ", not " + plain);
    }
    values[index] = plain;
    return this;
  }

  private static Object plain(Object value) {
    Object inner = value instanceof Optional<?> optional ? optional.orElse(null) : value;
    return inner instanceof Double number && !Double.isFinite(number) ? null : inner;
  }

  private static boolean fits(ColumnType type, Object value) {
    return switch (type) {
      case BOOLEAN -> value instanceof Boolean;
      case INT -> value instanceof Integer;
      case LONG, TIME -> value instanceof Long;
      case DOUBLE -> value instanceof Double;
      case TEXT -> value instanceof String;
      case INTS ->
          value instanceof List<?> list && list.stream().allMatch(Integer.class::isInstance);
    };
  }

  /**
   * A number.
   *
   * @param column its name, of type DOUBLE
   * @return NaN when it is missing
   */
  public double number(String column) {
    Object value = get(column);
    return value == null ? Double.NaN : (Double) value;
  }

  /**
   * A text.
   *
   * @param column its name, of type TEXT
   * @return null when it is missing
   */
  public String text(String column) {
    return (String) get(column);
  }

  /**
   * A whole number.
   *
   * @param column its name, of type INT, LONG or TIME
   * @return 0 when it is missing
   */
  public long whole(String column) {
    Object value = get(column);
    return value == null ? 0 : ((Number) value).longValue();
  }

  /**
   * A value.
   *
   * @param column its name
   * @return null when it is missing
   */
  public Object get(String column) {
    return values[table.index(column)];
  }

  Object get(int index) {
    return values[index];
  }

  /**
   * The table.
   *
   * @return of which this is a row
   */
  public Table table() {
    return table;
  }
}
