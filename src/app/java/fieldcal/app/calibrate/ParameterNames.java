package fieldcal.app.calibrate;

import java.util.Locale;

/** Names of parameters in files, which are those of the league's messages: {@code accSlide} is {@code acc_slide}. */
final class ParameterNames {
  private ParameterNames() {}

  static String inFiles(String name) {
    return name.replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
  }
}
