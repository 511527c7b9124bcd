package fieldcal.app.wording;

import java.util.List;
import java.util.Locale;

/** What is wrong, what it does to the game, what to do: a sentence each; the second may be empty. */
record Sentences(String what, String consequence, String advice) {

  /** Text with numbers in it, the same on every machine. */
  static String text(String format, Object... args) {
    return String.format(Locale.ROOT, format, args);
  }

  /** For example "a, b and c". */
  static String list(List<String> items) {
    int last = items.size() - 1;
    return last < 1
        ? String.join("", items)
        : String.join(", ", items.subList(0, last)) + " and " + items.get(last);
  }

  /** With a capital letter. */
  static String begin(String text) {
    return text.isEmpty() ? text : Character.toUpperCase(text.charAt(0)) + text.substring(1);
  }
}
