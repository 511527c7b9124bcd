package fieldcal.testing;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** A text file of lines {@code name = value ± tolerance} or {@code name = words}, made by a program and edited by people. */
final class Expectations {
  private static final String HEAD =
      """
      # What is expected of %s: name = value ± tolerance, or name = words.
      # Written by a test that ran with -Dfieldcal.accept=true. Values and tolerances may be edited, for example to a truth that is known otherwise.
      """;

  /** A value with what it may differ by. */
  record Value(String text, double tolerance) {
    static Value of(double value, double tolerance) {
      return new Value(number(value), tolerance);
    }

    static Value of(String words) {
      return new Value(words, Double.NaN);
    }

    boolean isNumber() {
      return !Double.isNaN(tolerance);
    }

    String written() {
      return isNumber() ? text + " ± " + number(tolerance) : text;
    }
  }

  private final Path file;
  private final Map<String, Value> values;

  private Expectations(Path file, Map<String, Value> values) {
    this.file = file;
    this.values = values;
  }

  static Expectations read(Path file) throws IOException {
    Map<String, Value> values = new TreeMap<>();
    if (Files.exists(file)) {
      int number = 0;
      for (String line : lines(file)) {
        number++;
        if (!line.isBlank() && !line.startsWith("#")) {
          int equals = line.indexOf('=');
          if (equals < 0) {
            throw new IOException(file + ", line " + number + ": expected name = value");
          }
          values.put(
              line.substring(0, equals).strip(),
              value(line.substring(equals + 1).strip(), file + ", line " + number));
        }
      }
    }
    return new Expectations(file, values);
  }

  private static List<String> lines(Path file) throws IOException {
    try {
      return Files.readAllLines(file, StandardCharsets.UTF_8);
    } catch (CharacterCodingException e) {
      throw new IOException(file + ": is not a text in UTF-8", e);
    }
  }

  private static Value value(String text, String place) throws IOException {
    int sign = text.indexOf('±');
    if (sign < 0) {
      return Value.of(text);
    }
    String value = text.substring(0, sign).strip();
    try {
      double tolerance = Double.parseDouble(text.substring(sign + 1).strip());
      if (tolerance >= 0 && Double.isFinite(Double.parseDouble(value))) {
        return new Value(value, tolerance);
      }
    } catch (NumberFormatException e) {
      // The message below says what is expected.
    }
    throw new IOException(place + ": expected numbers, value ± tolerance, but found " + text);
  }

  /** The differences for names with a prefix, one line each; a name that is missing on either side counts as a difference. */
  List<String> differences(String prefix, Map<String, Value> now) {
    List<String> lines = new ArrayList<>();
    TreeMap<String, Value> all = new TreeMap<>(now);
    values.keySet().stream()
        .filter(n -> n.startsWith(prefix))
        .forEach(n -> all.putIfAbsent(n, null));
    int width = all.keySet().stream().mapToInt(String::length).max().orElse(0);
    all.forEach(
        (name, is) -> {
          Value was = values.get(name);
          String difference = difference(was, is);
          if (!difference.isEmpty()) {
            lines.add(String.format(Locale.ROOT, "  %-" + width + "s  %s", name, difference));
          }
        });
    return lines;
  }

  private static String difference(Value was, Value is) {
    if (was == null) {
      return "is new: " + is.text();
    }
    if (is == null) {
      return "expected " + was.written() + ", but there is none";
    }
    if (!was.isNumber() || !is.isNumber()) {
      return was.text().equals(is.text())
          ? ""
          : "expected " + was.written() + ", but was " + is.text();
    }
    double off = Double.parseDouble(is.text()) - Double.parseDouble(was.text());
    if (Math.abs(off) <= was.tolerance()) {
      return "";
    }
    return "expected " + was.written() + ", but was " + is.text() + ", off by " + number(off);
  }

  /** Writes new values for the names with a prefix; their tolerances and all other lines stay. */
  void accept(String prefix, Map<String, Value> now, String recording) throws IOException {
    TreeMap<String, Value> all = new TreeMap<>(values);
    all.keySet().removeIf(name -> name.startsWith(prefix));
    now.forEach(
        (name, value) -> {
          Value was = values.get(name);
          boolean keep = was != null && was.isNumber() && value.isNumber();
          all.put(name, keep ? new Value(value.text(), was.tolerance()) : value);
        });
    StringBuilder text = new StringBuilder(String.format(Locale.ROOT, HEAD, recording));
    all.forEach((name, value) -> text.append(name + " = " + value.written() + "\n"));
    Path directory = file.toAbsolutePath().getParent();
    Files.createDirectories(directory);
    Files.writeString(file, text, StandardCharsets.UTF_8);
    values.clear();
    values.putAll(all);
  }

  boolean has(String prefix) {
    return values.keySet().stream().anyMatch(name -> name.startsWith(prefix));
  }

  Path file() {
    return file;
  }

  /** Five digits: what is rounded off is far below any tolerance. */
  private static String number(double value) {
    return String.format(Locale.ROOT, "%.5g", value);
  }
}
