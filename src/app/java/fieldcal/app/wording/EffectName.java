package fieldcal.app.wording;

import fieldcal.ball.Parameter;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** What an operator calls an effect. */
public final class EffectName {
  private static final Map<String, String> NAMES =
      Map.ofEntries(
          Map.entry("air_drag", "air drag"),
          Map.entry("magnus", "lift of spinning balls (Magnus)"),
          Map.entry("kick_spin", "topspin/backspin from the kicker"),
          Map.entry("side_spin", "side spin from the kicker"),
          Map.entry("field_slope", "sloping field"),
          Map.entry("carpet_nap", "direction of the carpet"),
          Map.entry("speed_dependent_roll", "rolling that depends on speed"),
          Map.entry("worn_region", "worn part of the carpet"),
          Map.entry("camera_offset", "camera offset"),
          Map.entry("camera_time_offset", "wrong time stamps"),
          Map.entry("camera_pose_error", "misplaced camera"),
          Map.entry("lens_distortion_error", "wrong lens distortion"),
          Map.entry("ball_height_error", "wrong ball height in vision"),
          Map.entry("speed_dependent_restitution", "bounces that depend on speed"),
          Map.entry("bounce_spin_coupling", "bounces that depend on spin"),
          Map.entry("drift", "carpet that changes over time"),
          Map.entry("robot_kick_bias", "badly calibrated kicker"),
          Map.entry("clock_skew", "camera clock at the wrong rate"),
          Map.entry("rolling_shutter", "rolling shutter"));

  private EffectName() {}

  /**
   * The name of a sort of effect.
   *
   * @param id as in files
   * @return a few words in lower case; of an unknown id, the id with blanks
   */
  public static String of(String id) {
    return NAMES.getOrDefault(id, id.replace('_', ' '));
  }

  /**
   * The name of one effect, with the camera, robot or place that it is about.
   *
   * @param effect the effect
   * @return for example "camera offset, camera 1"
   */
  public static String of(Effect effect) {
    if (effect instanceof LearnedTerm term) {
      return LearnedWords.name(term);
    }
    List<String> names = effect.parameters().stream().map(Parameter::name).toList();
    String name = of(effect.id());
    if (effect.id().equals("kick_spin") && !effect.isAbsent()) {
      return effect.value("fraction") < 0 ? "backspin from the kicker" : "topspin from the kicker";
    }
    if (names.contains("camera")) {
      return name + ", camera " + (int) effect.value("camera");
    }
    if (names.contains("robot")) {
      return name + ", " + robot(effect);
    }
    if (names.contains("region_x0")) {
      return name
          + List.of("region_x0", "region_x1", "region_y0", "region_y1").stream()
              .map(n -> Amount.decimals(effect.value(n), 1))
              .collect(Collectors.joining(", ", " [", "] m"));
    }
    return name;
  }

  /** Whose robot an effect is about, for example "yellow 3". */
  static String robot(Effect effect) {
    Team team = effect.value("team") == 0 ? Team.YELLOW : Team.BLUE;
    return team.name().toLowerCase(Locale.ROOT) + " " + (int) effect.value("robot");
  }

  /**
   * How strong an effect is.
   *
   * @param effect with its numbers
   * @param standardErrors by name of the parameter; may lack some
   * @return its estimated parameters that are not zero, with errors and units, for example "x 21.3 ± 0.4 mm, y 0.2 ± 0.4 mm"; angles in degrees
   */
  public static String strength(Effect effect, Map<String, Double> standardErrors) {
    if (effect instanceof LearnedTerm term) {
      return "a curve of " + term.family().size() + " coefficients";
    }
    return effect.parameters().stream()
        .filter(p -> p.estimated() || standardErrors.containsKey(p.name()))
        .filter(p -> isSaid(p, effect))
        .map(p -> parameter(p, standardErrors.getOrDefault(p.name(), Double.NaN)))
        .collect(Collectors.joining(", "));
  }

  /** A part that is exactly absent needs no words, and its direction has none; all of an absent effect are said. */
  private static boolean isSaid(Parameter p, Effect effect) {
    boolean absentPart = effect.magnitudes().contains(p.name()) && p.value() == 0;
    boolean axisOfNothing = p.name().equals("axis") && effect.value("tilt_mrad") == 0;
    return effect.isAbsent() || !absentPart && !axisOfNothing;
  }

  private static String parameter(Parameter p, double error) {
    boolean angle = p.unit().equals("rad");
    double factor = angle ? Math.toDegrees(1) : 1;
    String unit = angle ? "°" : p.unit().isEmpty() ? "" : " " + p.unit();
    String name = brief(p);
    return (name.isEmpty() ? "" : name + " ")
        + Amount.withError(factor * p.value(), factor * error)
        + unit;
  }

  /** The name in files, without the unit that it ends with. */
  private static String brief(Parameter p) {
    String name = p.name().replace("percent_per_10min", "in ten minutes");
    return name.equals(p.unit()) || name.equals("percent")
        ? ""
        : name.replaceFirst("_" + Pattern.quote(p.unit()) + "$", "").replace('_', ' ');
  }
}
