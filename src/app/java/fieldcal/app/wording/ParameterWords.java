package fieldcal.app.wording;

import fieldcal.ball.Parameter;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** What people call a parameter of the ball models. */
public final class ParameterWords {
  private static final Map<String, String> WORDS =
      Map.of(
          "accSlide", "sliding deceleration",
          "accRoll", "rolling deceleration",
          "kSwitch", "switch to rolling",
          "dampingXyFirstHop", "horizontal damping at the first impact",
          "dampingXyOtherHops", "horizontal damping at later impacts",
          "dampingZ", "vertical damping");

  private static final Pattern FILE_NAME =
      Pattern.compile(
          WORDS.keySet().stream()
              .map(ParameterWords::inFiles)
              .sorted()
              .collect(Collectors.joining("|", "(?<!\\()\\b(", ")\\b")));

  private ParameterWords() {}

  /**
   * The name in files, which is that of the league's messages.
   *
   * @param name as in the model's record, for example {@code accSlide}
   * @return for example {@code acc_slide}
   */
  public static String inFiles(String name) {
    return Parameter.inFiles(name);
  }

  /**
   * The words alone.
   *
   * @param name as in the model's record
   * @return for example {@code sliding deceleration}; of an unknown parameter, its name in files
   */
  public static String words(String name) {
    return WORDS.getOrDefault(name, inFiles(name));
  }

  /**
   * The name in sentences.
   *
   * @param name as in the model's record
   * @return for example {@code sliding deceleration (acc_slide)}
   */
  public static String of(String name) {
    String words = WORDS.get(name);
    return words == null ? inFiles(name) : words + " (" + inFiles(name) + ")";
  }

  /**
   * The name in sentences of a parameter that is known by its name in files.
   *
   * @param name for example {@code acc_slide}
   * @return for example {@code sliding deceleration (acc_slide)}
   */
  public static String ofFileName(String name) {
    return WORDS.keySet().stream()
        .filter(known -> inFiles(known).equals(name))
        .findFirst()
        .map(ParameterWords::of)
        .orElse(name);
  }

  /**
   * Spells out the parameters that a note of the library names as files do. What is spelled out already, with the name in brackets, remains.
   *
   * @param note for example {@code acc_slide is 2.3 σ from the mean}
   * @return for example {@code sliding deceleration (acc_slide) is 2.3 σ from the mean}
   */
  public static String spelledOut(String note) {
    return FILE_NAME.matcher(note).replaceAll(found -> ofFileName(found.group()));
  }

  /**
   * The name in tables, where the unit follows the name.
   *
   * @param name as in the model's record
   * @return for example {@code sliding deceleration (acc_slide), m/s²}
   */
  public static String withUnit(String name) {
    return of(name) + (unit(name).isEmpty() ? "" : "," + unit(name));
  }

  /**
   * A value in a list of several.
   *
   * @param name as in the model's record
   * @param value in the parameter's unit
   * @return for example {@code sliding deceleration -3.012 m/s²}
   */
  public static String withValue(String name, double value) {
    String number = Amount.minus(String.format(Locale.ROOT, "%.3f", value));
    return words(name) + " " + number + unit(name);
  }

  /**
   * The unit with a blank before it.
   *
   * @param name as in the model's record
   * @return " m/s²"; empty for a ratio
   */
  public static String unit(String name) {
    return name.startsWith("acc") ? " m/s²" : "";
  }
}
