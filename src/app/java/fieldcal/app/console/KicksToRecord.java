package fieldcal.app.console;

import fieldcal.app.console.SessionNotes.CauseNote;
import fieldcal.app.console.SessionNotes.DiagnosisNote;
import fieldcal.app.wording.NextKicks;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * What a diagnosis would like to have recorded, as plays that can be ordered: the kicks in which the causes that cannot be told apart show. The play kicks along its own lines, so what else
 * the diagnosis says of places and directions remains in its words.
 */
final class KicksToRecord {
  /** Half as many again as a diagnosis asks for at least: some do not determine what they should. */
  private static final int KICKS = 12;

  private static final Wish FAST_FLAT = new Wish("flat", KICKS, 4, 6.5, "");
  private static final Wish SLOW_FLAT = new Wish("flat", KICKS, 1.5, 3, "");
  private static final Wish ALL_FLAT = new Wish("flat", KICKS, 2, 6.5, "");
  private static final Wish CHIPS = new Wish("chip", KICKS, 3, 5.5, "");

  /** In which kicks each cause shows. */
  private static final Map<String, List<Wish>> SHOWS_IN =
      Map.ofEntries(
          Map.entry("air_drag", List.of(ALL_FLAT, CHIPS)),
          Map.entry("magnus", List.of(CHIPS)),
          Map.entry("kick_spin", List.of(FAST_FLAT)),
          Map.entry("side_spin", List.of(FAST_FLAT)),
          Map.entry("field_slope", List.of(SLOW_FLAT)),
          Map.entry("carpet_nap", List.of(SLOW_FLAT)),
          Map.entry("speed_dependent_roll", List.of(ALL_FLAT)),
          Map.entry("worn_region", List.of(SLOW_FLAT)),
          Map.entry("camera_time_offset", List.of(FAST_FLAT)),
          Map.entry("camera_pose_error", List.of(SLOW_FLAT)),
          Map.entry("camera_position_error", List.of(CHIPS)),
          Map.entry("lens_distortion_error", List.of(SLOW_FLAT)),
          Map.entry("ball_height_error", List.of(SLOW_FLAT)),
          Map.entry("speed_dependent_restitution", List.of(CHIPS)),
          Map.entry("bounce_spin_coupling", List.of(CHIPS)),
          Map.entry("drift", List.of(SLOW_FLAT)),
          Map.entry("robot_kick_bias", List.of(ALL_FLAT)),
          Map.entry("clock_skew", List.of(FAST_FLAT)),
          Map.entry("rolling_shutter", List.of(FAST_FLAT)),
          Map.entry("wind", List.of(CHIPS)),
          Map.entry("slip_dependent_friction", List.of(ALL_FLAT)),
          Map.entry("camera_moved", List.of(SLOW_FLAT)),
          Map.entry("ball_changed", List.of(SLOW_FLAT)),
          Map.entry("contact_impacts", List.of(CHIPS)),
          Map.entry("carpet_seam", List.of(SLOW_FLAT)));

  private KicksToRecord() {}

  /**
   * A play that would help.
   *
   * @param kind flat or chip
   * @param kicks how many
   * @param slowest m/s
   * @param fastest m/s
   * @param why in the words of the diagnosis
   */
  record Wish(String kind, int kicks, double slowest, double fastest, String why) {
    private Wish because(String reason) {
      return new Wish(kind, kicks, slowest, fastest, reason);
    }
  }

  /** The wishes of a diagnosis; none where everything could be told apart. */
  static List<Wish> of(DiagnosisNote note) {
    Set<Wish> wishes = new LinkedHashSet<>();
    for (CauseNote cause : note.causes()) {
      if (!cause.next().isEmpty() && !NextKicks.needsNothing(cause.next())) {
        Stream.concat(Stream.of(cause.effect()), cause.rivals().stream())
            .flatMap(effect -> SHOWS_IN.getOrDefault(effect, List.of(ALL_FLAT)).stream())
            .distinct()
            .map(wish -> wish.because(cause.next()))
            .forEach(wishes::add);
      }
    }
    if (note.verdict().equals("unexplained_structure")) {
      wishes.add(ALL_FLAT.because(String.join(" ", note.lines())));
      wishes.add(CHIPS.because(String.join(" ", note.lines())));
    }
    return new ArrayList<>(wishes);
  }
}
