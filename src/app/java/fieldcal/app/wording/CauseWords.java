package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.effect.Effect;
import fieldcal.effect.ObservedCamera;
import java.util.Collection;
import java.util.List;
import java.util.Map;

/**
 * Puts causes into an operator's words. The numbers of what a cause does to a kick are those of the diagnosis' own model; those of what a camera reports
 * are of the places where it saw the ball. Immutable.
 */
public final class CauseWords {
  private final ExampleKicks kicks;
  private final ReportedShifts shifts;

  /**
   * Words for the causes of a diagnosis.
   *
   * @param diagnosis which one
   * @param observers the cameras as published, as the diagnosis was given them; may be empty, then less is said of what cameras report
   */
  public CauseWords(Diagnosis diagnosis, Collection<ObservedCamera> observers) {
    kicks = new ExampleKicks(diagnosis.model());
    shifts = new ReportedShifts(observers, diagnosis.kicks());
  }

  /**
   * One cause.
   *
   * @param cause of the diagnosis
   * @return its text
   */
  public CauseText of(Cause cause) {
    CauseText text = of(cause.effect(), cause.standardErrors());
    if (!(cause.scatter() > 0)) {
      return text;
    }
    String scatter =
        text("%s; differs from kick to kick by ± %s", text.strength(), Amount.of(cause.scatter()));
    return new CauseText(text.name(), text.what(), text.consequence(), text.advice(), scatter);
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
            .orElseGet(() -> new Sentences(effect.sentence(), "", MotionText.PREDICT));
    return new CauseText(
        EffectName.of(effect),
        s.what(),
        s.consequence(),
        s.advice(),
        EffectName.strength(effect, standardErrors));
  }

  /**
   * What could not be told apart, in a sentence.
   *
   * @param cause of the diagnosis
   * @return empty when nothing else explains the same
   */
  public static String rivals(Cause cause) {
    List<String> names = cause.indistinguishableFrom().stream().map(EffectName::of).toList();
    return names.isEmpty()
        ? ""
        : text(
            "These kicks cannot tell it from %s: it is named because it is the simpler explanation"
                + " or explains a little more.",
            String.join(" or ", names));
  }
}
