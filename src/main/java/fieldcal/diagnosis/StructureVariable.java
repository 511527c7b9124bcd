package fieldcal.diagnosis;

import java.util.Locale;

/** What residuals may depend on. */
public enum StructureVariable {
  /** Time since the kick. */
  TIME_SINCE_KICK("s"),
  /** Speed of the ball. */
  SPEED("m/s"),
  /** Place in the field. */
  X("m"),
  /** Place in the field. */
  Y("m"),
  /** Direction of travel in the field frame, 0 = along x, counter-clockwise. */
  DIRECTION("rad"),
  /** Height of the ball above the carpet; only while it flies. */
  HEIGHT("m"),
  /** Which camera. */
  CAMERA(""),
  /** Column in the image. */
  IMAGE_COLUMN("px"),
  /** Row in the image. */
  IMAGE_ROW("px"),
  /** Time since the beginning of the session. */
  SESSION_TIME("s"),
  /** Which robot kicked. */
  ROBOT("");

  private final String unit;

  StructureVariable(String unit) {
    this.unit = unit;
  }

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Its unit.
   *
   * @return empty for ids and numbers of robots
   */
  public String unit() {
    return unit;
  }
}
