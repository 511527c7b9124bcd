package fieldcal.app.replay;

import java.io.IOException;
import java.math.BigDecimal;
import java.util.Optional;

/** Rows of a CSV file (RFC 4180, but lines end with a line feed): numbers exact to the last bit, empty cells for what is not known. */
final class CsvRow {
  private final Appendable to;
  private boolean first = true;

  CsvRow(Appendable to) {
    this.to = to;
  }

  CsvRow text(String value) throws IOException {
    boolean quoted = value.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return cell(quoted ? '"' + value.replace("\"", "\"\"") + '"' : value);
  }

  CsvRow text(Optional<String> value) throws IOException {
    return text(value.orElse(""));
  }

  CsvRow number(double value) throws IOException {
    return cell(Double.isFinite(value) ? Double.toString(value) : "");
  }

  CsvRow integer(long value) throws IOException {
    return cell(Long.toString(value));
  }

  CsvRow flag(boolean value) throws IOException {
    return cell(value ? "1" : "0");
  }

  /** Unix time in seconds with all nine decimals, which a double does not hold. */
  CsvRow nanos(long unixNanos) throws IOException {
    return cell(BigDecimal.valueOf(unixNanos, 9).toPlainString());
  }

  private CsvRow cell(String value) throws IOException {
    if (!first) {
      to.append(',');
    }
    to.append(value);
    first = false;
    return this;
  }

  void end() throws IOException {
    to.append('\n');
    first = true;
  }
}
