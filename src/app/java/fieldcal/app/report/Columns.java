package fieldcal.app.report;

/** Checks of columns that belong together. */
final class Columns {
  private Columns() {}

  static void requireLength(String column, int expected, int actual) {
    if (actual != expected) {
      throw new IllegalArgumentException(
          "column " + column + " has " + actual + " values, t has " + expected);
    }
  }
}
