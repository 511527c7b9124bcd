package fieldcal.app.wording;

import fieldcal.ball.Parameter;
import fieldcal.diagnosis.Cause;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** What an operator calls an effect. */
public final class EffectName {
  private EffectName() {}

  /**
   * The name of a kind of effect, or of one camera's.
   *
   * @param id as in files; also with a camera, for example "camera_offset of camera 1"
   * @return a few words in lower case; of an unknown id, the id with blanks
   */
  public static String of(String id) {
    Optional<Rival> ofCamera = Rival.ofCamera(id);
    if (ofCamera.isPresent()) {
      return of(ofCamera.get().id(), CameraName.of(ofCamera.get().camera()));
    }
    return EffectWords.of(id).map(EffectWords::name).orElseGet(() -> id.replace('_', ' '));
  }

  private static String of(String id, String camera) {
    return EffectWords.of(id)
        .map(words -> words.name(camera))
        .orElseGet(() -> of(id) + " of " + camera);
  }

  /**
   * The name of one effect, with the camera, robot or place that it is about.
   *
   * @param effect the effect
   * @return for example "offset of camera 1"
   */
  public static String of(Effect effect) {
    if (effect instanceof LearnedTerm term) {
      return LearnedWords.name(term);
    }
    List<String> names = effect.parameters().stream().map(Parameter::name).toList();
    if (!effect.hasOwnMean()) {
      return ChanceWords.name(effect);
    }
    String name = of(effect.id());
    if (effect.id().equals(KickerSpin.ID) && !effect.isAbsent()) {
      return spin(effect, Map.of());
    }
    if (names.contains("camera")) {
      int camera = (int) effect.value("camera");
      return of(
          effect.id(),
          camera == EffectParameters.ALL_CAMERAS ? "all cameras" : CameraName.of(camera));
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
    if (names.contains("normal")) {
      return name + " " + FieldWords.line(effect.value("normal"), effect.value("distance"));
    }
    return name;
  }

  /**
   * The name of a cause: where the sign of spin is within its errors, neither topspin nor backspin.
   *
   * @param cause of a diagnosis
   * @return as {@link #of(Effect)}
   */
  public static String of(Cause cause) {
    return cause.effect().id().equals(KickerSpin.ID)
        ? spin(cause.effect(), cause.standardErrors())
        : of(cause.effect());
  }

  private static String spin(Effect effect, Map<String, Double> standardErrors) {
    return KickerSpin.of(effect, standardErrors).sort() + " from the kicker";
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
