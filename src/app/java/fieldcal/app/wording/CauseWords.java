package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.SpinAtKick;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.learned.LearnedTerm;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Puts causes into an operator's words. The numbers of what a cause does to a kick are those of the diagnosis' own model; those of what a camera reports
 * are of the places where it saw the ball. Where the extended model predicts no better than the simple one, nobody is advised to use it. Immutable.
 */
public final class CauseWords {
  private final ExampleKicks kicks;
  private final ReportedShifts shifts;
  private final boolean extendedHelps;

  /**
   * Words for the causes of a diagnosis.
   *
   * @param diagnosis which one
   * @param observers the cameras as published, as the diagnosis was given them; may be empty, then less is said of what cameras report
   */
  public CauseWords(Diagnosis diagnosis, Collection<ObservedCamera> observers) {
    kicks = new ExampleKicks(diagnosis.model());
    extendedHelps = VerdictText.caveat(diagnosis).isEmpty();
    shifts = new ReportedShifts(observers, diagnosis.kicks(), diagnosis.model().sessionStart());
  }

  /**
   * One cause.
   *
   * @param cause of the diagnosis
   * @return its text
   */
  public CauseText of(Cause cause) {
    CauseText text = of(cause.effect(), cause.standardErrors());
    String strength =
        cause.scatter() > 0
            ? text(
                "%s; differs from kick to kick by ± %s",
                text.strength(), Amount.of(cause.scatter()))
            : text.strength();
    return new CauseText(
        EffectName.of(cause), text.what(), text.consequence(), text.advice(), strength);
  }

  /**
   * One effect.
   *
   * @param effect with its numbers
   * @param standardErrors of its parameters by name; may lack some
   * @return its text; of an effect that has no words of its own, its sentence
   */
  public CauseText of(Effect effect, Map<String, Double> standardErrors) {
    Sentences s =
        EffectWords.of(effect.id())
            .map(words -> words.sentences(effect, standardErrors, kicks, shifts))
            .orElseGet(
                () -> new Sentences(effect.sentence(), "", "Predict with the extended model.", ""));
    return new CauseText(
        EffectName.of(effect),
        s.what(),
        s.consequence(),
        s.advice(extendedHelps),
        EffectName.strength(effect, standardErrors));
  }

  /**
   * Something that has no name: a learned curve, a law that takes the place of the simple model's, or what differs by chance.
   *
   * @param finding of the diagnosis
   * @return its text; the strength is the formula of a curve, the numbers of a law
   */
  public CauseText of(LearnedFinding finding) {
    if (finding.kind() == LearnedFinding.Kind.SCATTER) {
      return ChanceWords.of(finding.effect(), finding.scatter(), finding.follows());
    }
    if (finding.effect() instanceof SpinAtKick && finding.scatter() > 0) {
      return unproven(finding);
    }
    return finding.effect() instanceof LearnedTerm term
        ? LearnedWords.of(term, finding.curves(), finding.isShownToHelp(), extendedHelps)
        : of(finding.effect(), Map.of());
  }

  /** Spin of each kick that nobody can say to be the kickers'. */
  private CauseText unproven(LearnedFinding finding) {
    CauseText proven = of(finding.effect(), Map.of());
    String what =
        text(
            "%s It differs by ± %s %% from kick to kick. This is not proven: the ball or the"
                + " carpet may be what differs from the model.",
            proven.what(), MotionText.percent(finding.scatter()));
    return new CauseText(proven.name(), what, "", "", proven.strength());
  }

  /**
   * What could not be distinguished, in a sentence or two.
   *
   * @param cause of the diagnosis
   * @return empty when nothing else explains the same
   */
  public static String rivals(Cause cause) {
    String id = cause.effect().id();
    boolean ofOneCamera = isOfOneCamera(cause.effect());
    List<String> cameras = new ArrayList<>();
    List<String> names = new ArrayList<>();
    for (String rival : cause.indistinguishableFrom()) {
      Optional<Rival> ofCamera =
          Rival.ofCamera(rival).filter(r -> ofOneCamera && r.id().equals(id));
      if (ofCamera.isPresent()) {
        cameras.add(CameraName.of(ofCamera.get().camera()));
      } else {
        names.add(EffectName.of(rival));
      }
    }
    String other =
        text(
            "%s would explain these kicks about as well: %s. This one is named because it is"
                + " simpler or explains a little more.",
            names.size() > 1 ? "Other causes" : "Another cause", String.join(" or ", names));
    return Stream.of(whichCamera(cause, cameras), names.isEmpty() ? "" : other)
        .filter(s -> !s.isEmpty())
        .collect(Collectors.joining(" "));
  }

  private static boolean isOfOneCamera(Effect effect) {
    return effect.parameters().stream()
        .anyMatch(p -> p.name().equals("camera") && p.value() != EffectParameters.ALL_CAMERAS);
  }

  private static String whichCamera(Cause cause, List<String> others) {
    if (others.isEmpty()) {
      return "";
    }
    List<String> all = new ArrayList<>(others);
    all.add(CameraName.of((int) cause.effect().value("camera")));
    all.sort(
        Comparator.comparingInt((String camera) -> camera.length())
            .thenComparing(Comparator.naturalOrder()));
    return text(
        "These kicks do not show whether %s or %s %s.",
        String.join(", ", all.subList(0, all.size() - 1)),
        all.get(all.size() - 1),
        EffectWords.ofOneCamera(cause.effect().id()));
  }
}
