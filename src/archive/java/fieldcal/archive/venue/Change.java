package fieldcal.archive.venue;

import java.util.Locale;
import java.util.OptionalInt;

/**
 * Something that changed between two matches in a row at a venue.
 *
 * @param venue its name
 * @param kind of change
 * @param camera id; empty for all at once, where it is not known which one, and for what is no camera
 * @param last match before
 * @param next match after
 * @param what in words
 * @param sigmas how many standard errors the largest difference is; NaN for what is certain
 */
public record Change(
    String venue,
    Kind kind,
    OptionalInt camera,
    MatchFacts last,
    MatchFacts next,
    String what,
    double sigmas) {

  /** What changed. */
  public enum Kind {
    /** Friction or bounces: the carpet, or a ball of the same build. */
    CARPET_OR_BALL,
    /** The ball: its moment of inertia changed, which no carpet does. */
    BALL,
    /** Friction or bounces change with time otherwise than before; they did not jump. */
    DRIFT,
    /** Vision publishes another calibration. */
    CAMERA_CALIBRATED,
    /** A camera reports everything elsewhere than before, relative to the others, with the calibration of before. */
    CAMERA_MOVED;

    /**
     * The name in the table.
     *
     * @return lower case with underscores
     */
    public String id() {
      return name().toLowerCase(Locale.ROOT);
    }
  }
}
