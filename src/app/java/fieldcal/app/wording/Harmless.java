package fieldcal.app.wording;

import java.util.Arrays;
import java.util.Set;

/** Text of others — names of teams and files, errors of simulators — as a terminal may show it: what would steer the terminal is made visible instead. */
public final class Harmless {
  private static final char ESCAPE = '\u001b';

  /** Unicode has a picture of each control character, in the same order. */
  private static final char PICTURES = '\u2400';

  private static final char PICTURE_OF_DELETE = '\u2421';
  private static final char DELETE = '\u007f';
  private static final char REPLACEMENT = '\ufffd';

  /**
   * What the help of commands sets, by ECMA-48: normal, bold, italic, red, yellow, and their ends. Others could hide what follows, such as 8 (concealed) and
   * 30 (black).
   */
  private static final Set<String> COLOURS =
      Set.of("", "0", "1", "3", "21", "22", "23", "31", "33", "39");

  private Harmless() {}

  /**
   * Makes a text harmless. Line ends, tabs and the colours of this program's own help stay.
   *
   * @param text any
   * @return the same, with every other control character, and every one that turns the direction of writing, replaced by a visible one
   */
  public static String text(CharSequence text) {
    StringBuilder shown = new StringBuilder(text.length());
    int i = 0;
    while (i < text.length()) {
      int colour = text.charAt(i) == ESCAPE ? colourEnd(text, i) : i;
      if (colour > i) {
        shown.append(text, i, colour);
        i = colour;
      } else {
        shown.append(shown(text, i));
        i++;
      }
    }
    return shown.toString();
  }

  /**
   * Makes a text harmless that is a part of a line, such as a name: a line end in it could begin a line that this program did not write.
   *
   * @param text any
   * @return the same as by {@link #text}, with line ends made visible, too
   */
  public static String line(CharSequence text) {
    return text(text)
        .replace('\r', (char) (PICTURES + '\r'))
        .replace('\n', (char) (PICTURES + '\n'));
  }

  private static char shown(CharSequence text, int i) {
    char c = text.charAt(i);
    boolean lineEnd = c == '\r' && i + 1 < text.length() && text.charAt(i + 1) == '\n';
    if (c == '\n' || c == '\t' || lineEnd) {
      return c;
    }
    if (c < ' ') {
      return (char) (PICTURES + c);
    }
    if (c == DELETE) {
      return PICTURE_OF_DELETE;
    }
    boolean control = Character.isISOControl(c) || Character.getType(c) == Character.FORMAT;
    return control ? REPLACEMENT : c;
  }

  /** Behind a sequence that only sets colours of the help, ESC [ numbers m; {@code from} where there is none. */
  private static int colourEnd(CharSequence text, int from) {
    int i = from + 1;
    if (i >= text.length() || text.charAt(i) != '[') {
      return from;
    }
    i++;
    while (i < text.length() && (Character.isDigit(text.charAt(i)) || text.charAt(i) == ';')) {
      i++;
    }
    boolean ends = i < text.length() && text.charAt(i) == 'm';
    return ends && ofTheHelp(text.subSequence(from + 2, i).toString()) ? i + 1 : from;
  }

  private static boolean ofTheHelp(String numbers) {
    return Arrays.stream(numbers.split(";")).allMatch(COLOURS::contains);
  }
}
