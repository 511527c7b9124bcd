package fieldcal.app.wording;

import fieldcal.diagnosis.StructureVariable;

/** What residuals may depend on, in words, and which kicks would show more of it. */
public final class StructureWords {
  private StructureWords() {}

  /**
   * The variable.
   *
   * @param variable which
   * @return for a sentence, for example "the speed of the ball"
   */
  public static String of(StructureVariable variable) {
    return switch (variable) {
      case TIME_SINCE_KICK -> "the time since the kick";
      case SPEED -> "the speed of the ball";
      case X -> "the place along the field (x)";
      case Y -> "the place across the field (y)";
      case DIRECTION -> "the direction of travel";
      case HEIGHT -> "the height of the ball";
      case CAMERA -> "which camera sees the ball";
      case IMAGE_COLUMN -> "the column in the image";
      case IMAGE_ROW -> "the row in the image";
      case SESSION_TIME -> "the time since the session began";
      case ROBOT -> "which robot kicked";
    };
  }

  /**
   * A button's text.
   *
   * @param variable which
   * @return one word or two
   */
  public static String brief(StructureVariable variable) {
    return switch (variable) {
      case TIME_SINCE_KICK -> "time since kick";
      case SPEED -> "speed";
      case X -> "place x";
      case Y -> "place y";
      case DIRECTION -> "direction";
      case HEIGHT -> "height";
      case CAMERA -> "camera";
      case IMAGE_COLUMN -> "image column";
      case IMAGE_ROW -> "image row";
      case SESSION_TIME -> "session time";
      case ROBOT -> "robot";
    };
  }

  /**
   * Which kicks to record to learn more of what depends on a variable.
   *
   * @param variable which
   * @return a sentence
   */
  public static String kicksToRecord(StructureVariable variable) {
    return switch (variable) {
      case TIME_SINCE_KICK, SPEED ->
          "Record flat kicks on one line, from 1 to 6 m/s, and let them roll out.";
      case X, Y -> "Record equal kicks that begin in each quarter of the field.";
      case DIRECTION -> "Record equal kicks from the centre in eight directions.";
      case HEIGHT -> "Record chips of different height on one line, and flat kicks on the same.";
      case CAMERA, IMAGE_COLUMN, IMAGE_ROW ->
          "Record flat kicks that cross the whole view of each camera, lengthwise and crosswise.";
      case SESSION_TIME ->
          "Repeat the same ten kicks at the beginning and at the end of the session.";
      case ROBOT -> "Let each robot do the same kicks from the same place.";
    };
  }
}
