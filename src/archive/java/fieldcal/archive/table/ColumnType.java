package fieldcal.archive.table;

/** What a column holds. */
public enum ColumnType {
  /** True or false. */
  BOOLEAN,
  /** A whole number of 32 bit. */
  INT,
  /** A whole number of 64 bit. */
  LONG,
  /** A number; never NaN or infinite, which are nulls instead. */
  DOUBLE,
  /** UTF-8. */
  TEXT,
  /** An instant, µs since 1970 UTC. */
  TIME,
  /** A list of whole numbers, without nulls. */
  INTS
}
