package fieldcal.app.cli;

import fieldcal.app.wording.WordList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What the parser of the command line says about bad usage, in the words of the other errors. Thread safe. */
final class UsageWords {
  private static final Pattern MISSING =
      Pattern.compile("Missing required (?:options?(?: and parameters?)?|parameters?): (.*)");

  private static final Pattern ONE_OF =
      Pattern.compile("Missing required argument \\(specify one of these\\): \\((.*)\\)");

  private static final Pattern EXCLUSIVE =
      Pattern.compile("(.*) are mutually exclusive \\(specify only one\\)");

  private static final Pattern NO_VALUE =
      Pattern.compile("Missing required parameter for option '([^']*)' \\((.*)\\)");

  private static final Pattern UNKNOWN = Pattern.compile("Unknown options?: (.*)");

  private static final Pattern TOO_MANY =
      Pattern.compile("Unmatched arguments? (?:from|at) index \\d+: (.*)");

  private static final Pattern VALUE =
      Pattern.compile("Invalid value for option '([^']*)'(?: \\([^)]*\\))?: (.*)");

  private static final Pattern TWICE =
      Pattern.compile("option '([^']*)' \\(.*\\) should be specified only once");

  private UsageWords() {}

  /**
   * Puts one message into words.
   *
   * @param message of the parser, or of a command that checked its options itself
   * @return one line; what the parser says in other words stays
   */
  static String of(String message) {
    String text = message.replaceFirst("^Error: ", "");
    Matcher m = MISSING.matcher(text);
    if (m.matches()) {
      List<String> missing = names(m.group(1));
      return WordList.of(missing) + (missing.size() == 1 ? " is missing" : " are missing");
    }
    m = ONE_OF.matcher(text);
    if (m.matches()) {
      return "give " + String.join(" or ", choices(m.group(1), " \\| "));
    }
    m = EXCLUSIVE.matcher(text);
    if (m.matches()) {
      return "give " + String.join(" or ", choices(m.group(1), " and |, ")) + ", not both";
    }
    m = NO_VALUE.matcher(text);
    if (m.matches()) {
      return m.group(1) + " needs a value: " + m.group(2);
    }
    m = UNKNOWN.matcher(text);
    if (m.matches()) {
      return "there is no option " + m.group(1);
    }
    m = TOO_MANY.matcher(text);
    if (m.matches()) {
      return "one argument too many: " + m.group(1);
    }
    m = TWICE.matcher(text);
    if (m.matches()) {
      return m.group(1) + " is given more than once";
    }
    m = VALUE.matcher(text);
    if (m.matches()) {
      text = m.group(1) + ": " + m.group(2);
    }
    return text.replace("Missing required subcommand", "name a command")
        .replaceFirst("is not an? (int|long)$", "is not a whole number")
        .replaceFirst("is not a double$", "is not a number");
  }

  /** What somebody may have meant. The first of the parser's guesses is the nearest; the others have little in common with what was typed. */
  static Optional<String> guess(List<String> nearestFirst) {
    return nearestFirst.stream().findFirst().map(name -> "Did you mean '" + name + "'?");
  }

  /** {@code '--kind=flat|chip', '--kicks=N'} as a user types them. */
  private static List<String> names(String list) {
    return Arrays.stream(list.split("', '|, "))
        .map(name -> name.replace("'", "").replaceFirst("=", " "))
        .toList();
  }

  /** {@code [--log=LOG [--speed=X]] | [--multicast=ADDR:PORT]}: what each choice cannot do without. */
  private static List<String> choices(String list, String between) {
    return Arrays.stream(list.split(between))
        .map(one -> one.replaceFirst("^\\[", "").replaceFirst(" \\[.*$|\\]$", ""))
        .map(one -> one.replaceFirst("=", " "))
        .toList();
  }
}
