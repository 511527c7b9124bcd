package fieldcal.app.wording;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The same cause in another camera, as {@link fieldcal.diagnosis.Cause#indistinguishableFrom} names it: "camera_offset of camera 1".
 *
 * @param id of the effect
 * @param camera which camera
 */
public record Rival(String id, int camera) {
  private static final Pattern FORM = Pattern.compile("(\\w+) of camera (\\d{1,6})");

  /**
   * Reads a name.
   *
   * @param name an effect's id, with or without a camera
   * @return empty when it names no camera
   */
  public static Optional<Rival> ofCamera(String name) {
    Matcher m = FORM.matcher(name);
    return m.matches()
        ? Optional.of(new Rival(m.group(1), Integer.parseInt(m.group(2))))
        : Optional.empty();
  }
}
