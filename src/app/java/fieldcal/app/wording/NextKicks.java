package fieldcal.app.wording;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Which kicks tell causes apart that would explain the recorded ones as well, in an operator's words. Causes that are easily taken for each other have a text of their own; for any other two it
 * says in which kicks each of them shows. Texts name no file's ids.
 */
public final class NextKicks {
  private static final String DRAG_LIFT_ROLL =
      "Record six chips of 4–6 m/s at 45° and six flat kicks each at 2 and at 6 m/s that roll out:"
          + " only the air brakes a ball in flight, only lift makes flights of the same speed"
          + " longer or shorter with the spin, and rolling resistance acts on the carpet alone.";

  private static final String WHICH_CLOCK =
      "Record ten flat kicks of 5–6 m/s each at the beginning and at the end of a session of twenty"
          + " minutes or more, from camera to camera, half of them along the rows of the images and"
          + " half along their columns, both ways: the error of a wrong rate grows over the"
          + " session, that of a late stamp stays the same, and that of a rolling shutter depends"
          + " on the row, not on the column.";

  private static final String PLACE_OR_STAMP =
      "Let a ball rest at three places that two cameras see, and make six flat kicks of 5–6 m/s"
          + " through each place, in both directions: a late stamp shifts only the moving ball,"
          + " along its direction of travel; a misplaced camera also shifts the resting ball.";

  private static final String SCALE_OR_LENS =
      "Record four flat kicks of 2–3 m/s through the middle of each camera's view and four along"
          + " its edges and into its corners: a wrong height shifts the ball in proportion to its"
          + " distance from the middle, a wrong lens hardly shifts it half way out, but strongly at"
          + " the edges.";

  private static final String WHERE_OR_WHEN =
      "Make the same four flat kicks of 2–3 m/s, in both directions, in both halves of the field,"
          + " at the beginning and at the end of the session: a worn part brakes kicks in one half,"
          + " in both directions; the direction of the carpet brakes kicks in one direction, in"
          + " both halves; a change over time shows between the beginning and the end.";

  private static final String BOUNCES =
      "Record four chips each of 3, 4.5 and 6 m/s at the same angle, with the dribbler off, and the"
          + " same again with the ball spinning on the dribbler before each kick: only bounces that"
          + " depend on spin differ between the two.";

  private static final String SPIN_OR_KICKER =
      "Let both robots kick the same flat kicks of 2, 4 and 6 m/s from the same place, with their"
          + " commands recorded: a kicker of the wrong strength changes the speed right after the"
          + " kick, and spin changes how far the ball slides.";

  private static final String WHICH_IS_SHIFTED =
      "No kick shows which camera is right: lay a ball on a mark of the field that both"
          + " see, such as the centre, and compare what they report.";

  private static final String WHICH_IS_LATE =
      "No kick shows which camera is right: compare the clocks of their computers with a time"
          + " server.";

  private static final String SHIFT_OR_HEIGHT =
      "With only two cameras, no kick distinguishes a shift from a wrong height of the ball: look"
          + " up which height of the ball's centre vision assumes (21.5 mm is right).";

  private static final String SHIFT_OR_PLACE =
      "No more kicks are needed: calibrating the camera again corrects either cause.";

  /** Texts on causes that no kick tells apart, or need not. */
  private static final Set<String> WITHOUT_KICKS =
      Set.of(WHICH_IS_SHIFTED, WHICH_IS_LATE, SHIFT_OR_HEIGHT, SHIFT_OR_PLACE);

  private static final String WHICH_VIEW =
      "Record four flat kicks of 2–3 m/s each through the whole view of either camera, lengthwise"
          + " and crosswise: only in the view of the wrong camera is the ball reported wrong.";

  /** By the two ids, in any order. */
  private static final Map<Set<String>, String> PAIRS =
      Map.ofEntries(
          pair("air_drag", "magnus", DRAG_LIFT_ROLL),
          pair("air_drag", "speed_dependent_roll", DRAG_LIFT_ROLL),
          pair("magnus", "speed_dependent_roll", DRAG_LIFT_ROLL),
          pair("camera_time_offset", "clock_skew", WHICH_CLOCK),
          pair("camera_time_offset", "rolling_shutter", WHICH_CLOCK),
          pair("clock_skew", "rolling_shutter", WHICH_CLOCK),
          pair("camera_time_offset", "camera_offset", PLACE_OR_STAMP),
          pair("camera_time_offset", "camera_pose_error", PLACE_OR_STAMP),
          pair("clock_skew", "camera_offset", PLACE_OR_STAMP),
          pair("clock_skew", "camera_pose_error", PLACE_OR_STAMP),
          pair("camera_pose_error", "lens_distortion_error", SCALE_OR_LENS),
          pair("ball_height_error", "lens_distortion_error", SCALE_OR_LENS),
          pair("carpet_nap", "worn_region", WHERE_OR_WHEN),
          pair("drift", "worn_region", WHERE_OR_WHEN),
          pair("carpet_nap", "drift", WHERE_OR_WHEN),
          pair("bounce_spin_coupling", "speed_dependent_restitution", BOUNCES),
          pair("kick_spin", "robot_kick_bias", SPIN_OR_KICKER),
          pair("side_spin", "robot_kick_bias", SPIN_OR_KICKER),
          pair("camera_offset", "ball_height_error", SHIFT_OR_HEIGHT),
          pair(
              "camera_pose_error",
              "ball_height_error",
              "Record four flat kicks of 2–3 m/s across the whole view of every camera: a wrong"
                  + " height of the ball shows in all of them alike, a misplaced camera in one."
                  + " With a single camera compare the drawn field lines with its picture,"
                  + " which only a misplaced camera shifts."),
          pair("camera_offset", "camera_pose_error", SHIFT_OR_PLACE),
          pair(
              "camera_offset",
              "lens_distortion_error",
              "Record four flat kicks of 2–3 m/s through the middle of the camera's view and four"
                  + " along each edge: an offset is the same everywhere, a wrong lens"
                  + " shifts opposite edges in opposite directions."),
          pair(
              "carpet_nap",
              "field_slope",
              "Record six flat kicks of 1.5–2 m/s that roll out, straight across the direction that"
                  + " was found, both ways, and six of 5–6 m/s along it: a slope bends the path of"
                  + " those that cross it, and also acts on a sliding ball; the direction of the"
                  + " carpet does neither. If a ball that is laid down starts to roll, there is a"
                  + " slope."),
          pair(
              "worn_region",
              "field_slope",
              "Make the same flat kick of 2 m/s through the place in both directions, four times"
                  + " each, and let it roll out: a worn part brakes in both directions, a slope in"
                  + " one only."),
          pair(
              "air_drag",
              "speed_dependent_restitution",
              "Record six flat kicks of 6 m/s and four chips each of 3 and 6 m/s of which at least"
                  + " three bounces are seen: the air also brakes flat kicks, while bounces only"
                  + " change the height of the next hop."));

  /** What each cause is called, and the kicks in which it shows. */
  private static final Map<String, Sign> SIGNS =
      Map.ofEntries(
          sign("air_drag", "air drag", "flat kicks and chips of 5–6 m/s beside slow ones of 2 m/s"),
          sign(
              "magnus",
              "lift of a spinning ball",
              "chips of 4–6 m/s with and without spin from the dribbler"),
          sign(
              "kick_spin",
              "spin from the kicker",
              "how far flat kicks of 4–6 m/s slide, by both robots"),
          sign(
              "side_spin",
              "side spin",
              "the curved first half second of flat kicks of 4–6 m/s, by both robots"),
          sign(
              "field_slope",
              "a slope",
              "flat kicks of 1.5–2 m/s that roll out in four directions, whose paths it bends"),
          sign(
              "carpet_nap",
              "the carpet's direction",
              "equal flat kicks of 2–3 m/s that roll out in eight directions"),
          sign(
              "speed_dependent_roll",
              "rolling that depends on speed",
              "flat kicks of 1, 2, 4 and 6 m/s on one line that roll out"),
          sign(
              "worn_region",
              "a worn part of the carpet",
              "equal flat kicks of 2–3 m/s through the place and one metre beside it, both ways"),
          sign(
              "camera_offset",
              "a camera's offset",
              "balls that rest, or roll at 1–2 m/s, where two cameras see them"),
          sign(
              "camera_time_offset",
              "a late time stamp",
              "flat kicks of 5–6 m/s from camera to camera in both directions"),
          sign(
              "camera_pose_error",
              "a misplaced camera",
              "flat kicks of 2–3 m/s from below the camera to the corners of its view"),
          sign(
              "camera_position_error",
              "a camera that is published at the wrong position",
              "chips of 4–6 m/s that fly high through the whole view of the camera, both ways"),
          sign(
              "lens_distortion_error",
              "a wrong lens",
              "flat kicks of 2–3 m/s along the edges of the camera's view"),
          sign(
              "ball_height_error",
              "a wrong height of the ball",
              "slow flat kicks across the whole view of every camera"),
          sign(
              "speed_dependent_restitution",
              "a bounce that depends on speed",
              "chips of 3, 4.5 and 6 m/s at the same angle"),
          sign(
              "bounce_spin_coupling",
              "a bounce that depends on spin",
              "chips of 4 m/s with and without spin from the dribbler"),
          sign(
              "drift",
              "a carpet that changes",
              "the same flat kicks of 2–3 m/s at the beginning and at the end of the session"),
          sign(
              "robot_kick_bias",
              "a badly calibrated kicker",
              "equal kicks by both robots from the same place, with their commands recorded"),
          sign(
              "clock_skew",
              "a clock at the wrong rate",
              "flat kicks of 5–6 m/s from camera to camera at the beginning and at the end of a"
                  + " session of twenty minutes"),
          sign(
              "rolling_shutter",
              "a rolling shutter",
              "flat kicks of 5–6 m/s along the columns of a camera's image, both ways"),
          sign("wind", "moving air", "hard chips on one line, in both directions"),
          sign(
              "slip_dependent_friction",
              "friction that depends on slip",
              "flat kicks of 1, 3 and 6 m/s on one line"),
          sign(
              "camera_moved",
              "a knocked camera",
              "the same flat kicks of 2–3 m/s before and after it was knocked"),
          sign(
              "ball_changed",
              "another ball",
              "the same flat kicks of 2–3 m/s with each of the balls"),
          sign(
              "contact_impacts",
              "a bounce that builds up spin",
              "chips of 4–6 m/s at 30° and at 60° that bounce four times"),
          sign(
              "carpet_seam",
              "a seam",
              "flat kicks of 2–3 m/s over it, straight and at an angle, both ways"));

  private NextKicks() {}

  private record Sign(String name, String kicks) {}

  private static Map.Entry<Set<String>, String> pair(String a, String b, String text) {
    return Map.entry(Set.of(a, b), text);
  }

  private static Map.Entry<String, Sign> sign(String id, String name, String kicks) {
    return Map.entry(id, new Sign(name, kicks));
  }

  /**
   * Which kicks to record next.
   *
   * @param cause id of the effect that is named
   * @param rivals ids of those that would explain the same; "id of camera n" where another camera would
   * @return a sentence or two for each kind of rival; empty without rivals
   */
  public static String toTellApart(String cause, List<String> rivals) {
    return rivals.stream()
        .filter(rival -> !rival.equals(cause))
        .map(rival -> Rival.ofCamera(rival).map(Rival::id).orElse(rival))
        .map(rival -> rival.equals(cause) ? whichCamera(cause) : toTellApart(cause, rival))
        .filter(text -> !text.isEmpty())
        .distinct()
        .collect(Collectors.joining(" "));
  }

  /**
   * What tells the causes apart, as a sentence of its own.
   *
   * @param next what {@link #toTellApart} says
   * @return the same, introduced where it says what to do; empty for an empty text
   */
  public static String introduced(String next) {
    return next.isEmpty() || needsNothing(next) ? next : "To tell them apart: " + next;
  }

  /**
   * Whether nothing has to be told apart, since one correction is right for both causes.
   *
   * @param next what {@link #toTellApart} says
   * @return false also for no text
   */
  public static boolean needsNothing(String next) {
    return next.equals(SHIFT_OR_PLACE);
  }

  /**
   * Whether kicks are what tells two causes apart.
   *
   * @param cause id of the effect that is named
   * @param rival id of one that would explain the same; "id of camera n" where another camera would
   * @return false when something else must be looked at, or nothing needs to be
   */
  public static boolean canTellApart(String cause, String rival) {
    return !WITHOUT_KICKS.contains(toTellApart(cause, List.of(rival)));
  }

  /** What is relative to the other cameras no kick decides; an error of a pose or lens shows in its own view. */
  private static String whichCamera(String cause) {
    return switch (cause) {
      case "camera_offset", "camera_moved" -> WHICH_IS_SHIFTED;
      case "camera_time_offset", "clock_skew" -> WHICH_IS_LATE;
      default -> WHICH_VIEW;
    };
  }

  private static String toTellApart(String cause, String rival) {
    String known = PAIRS.get(Set.of(cause, rival));
    if (known != null) {
      return known;
    }
    // The pair is the same in either order.
    Sign a = sign(cause.compareTo(rival) < 0 ? cause : rival);
    Sign b = sign(cause.compareTo(rival) < 0 ? rival : cause);
    return "Record five or more kicks of each kind: %s shows in %s; %s in %s."
        .formatted(a.name, a.kicks, b.name, b.kicks);
  }

  /** Of a cause that is new to the catalogue, as much as can be said of any. */
  private static Sign sign(String id) {
    return SIGNS.getOrDefault(
        id,
        new Sign(id.replace('_', ' '), "kicks of different speeds, places, directions and times"));
  }
}
