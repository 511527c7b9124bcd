package fieldcal.app.wording;

import java.util.Locale;

/** What is wrong, what it does to the game, what to do: a sentence each; the second may be empty. */
record Sentences(String what, String consequence, String advice) {

  /** Text with numbers in it, the same on every machine. */
  static String text(String format, Object... args) {
    return String.format(Locale.ROOT, format, args);
  }

  /** With a capital letter. */
  static String begin(String text) {
    return text.isEmpty() ? text : Character.toUpperCase(text.charAt(0)) + text.substring(1);
  }
}
