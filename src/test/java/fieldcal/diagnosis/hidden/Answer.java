package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.Candidate;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.effect.Effect;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;

/**
 * What a study asks of a diagnosis. The only class of the study that knows the diagnosis' types: when these change, this changes.
 *
 * @param verdict as in files: {@code model_adequate}, {@code explained}, {@code partly_explained}, {@code unexplained_structure}
 * @param causes that were named
 * @param learned terms without a name, the one that explains most first
 * @param left variables that what remains depends on, strongest first
 * @param base the simple model
 * @param extended the model with all causes and terms
 * @param details everything that is said, one line each, for whoever looks at one case
 */
public record Answer(
    String verdict,
    List<Named> causes,
    List<Term> learned,
    List<String> left,
    Fit base,
    Fit extended,
    List<String> details) {

  /** Nothing is wrong. */
  public static final String ADEQUATE = "model_adequate";

  /** Causes were named and nothing is left. */
  public static final String EXPLAINED = "explained";

  /**
   * A cause that was named.
   *
   * @param effect with its fitted numbers
   * @param standardErrors by name of the parameter
   * @param scatter from kick to kick; 0 for effects that are the same for all
   * @param evidence natural logarithm of a Bayes factor
   * @param lowGainMm lower bound of what held-out kicks gain, mm
   * @param indistinguishableFrom ids of effects, some with {@code of camera N} behind
   */
  public record Named(
      Effect effect,
      Map<String, Double> standardErrors,
      double scatter,
      double evidence,
      double lowGainMm,
      List<String> indistinguishableFrom) {}

  /**
   * A term that was learned.
   *
   * @param actsOn ground, impact, kick or measurement
   * @param dependsOn names of variables
   */
  public record Term(String actsOn, List<String> dependsOn) {}

  /**
   * How well a model does.
   *
   * @param noiseMm what the residual would be if the model were right, mm
   * @param holdoutRmsMm residual of kicks that were held out, mm
   */
  public record Fit(double noiseMm, double holdoutRmsMm) {}

  /** Copies the lists. {@inheritDoc} */
  public Answer {
    causes = List.copyOf(causes);
    learned = List.copyOf(learned);
    left = List.copyOf(left);
    details = List.copyOf(details);
  }

  /**
   * Asks for a diagnosis.
   *
   * @param problem kicks and cameras
   * @param progress is told each step
   * @return the answer
   */
  static Answer to(DiagnosisProblem problem, Consumer<String> progress) {
    return of(new Diagnoser().diagnose(problem, progress));
  }

  /**
   * What a study needs of a diagnosis.
   *
   * @param d the diagnosis
   * @return the same, reduced
   */
  static Answer of(Diagnosis d) {
    return new Answer(
        d.verdict().id(),
        d.causes().stream().map(Answer::named).toList(),
        learned(d),
        d.unexplained().dependsOn().stream().map(StructureVariable::id).toList(),
        fit(d.base()),
        fit(d.extended()),
        details(d));
  }

  private static List<Term> learned(Diagnosis d) {
    return d.learned().stream().map(f -> new Term(f.actsOn(), f.dependsOn())).toList();
  }

  private static Named named(Cause c) {
    return new Named(
        c.effect(),
        c.standardErrors(),
        c.scatter(),
        c.evidence(),
        c.gain().lowMm(),
        c.indistinguishableFrom());
  }

  private static Fit fit(Quality q) {
    return new Fit(q.noiseMm(), q.holdoutRmsMm());
  }

  private static List<String> details(Diagnosis d) {
    List<String> lines = new ArrayList<>();
    lines.add("base      " + d.base());
    lines.add("extended  " + d.extended());
    lines.add("left      " + d.unexplained());
    d.causes().forEach(c -> lines.add("cause     " + c));
    d.learned().forEach(l -> lines.add("learned   " + l.effect() + " gain " + l.gain()));
    d.trace().forEach(step -> lines.add("tried     " + step));
    d.problems().forEach(p -> lines.add("problem   " + p));
    for (Candidate c : d.candidates()) {
      lines.add(
          String.format(
              Locale.ROOT,
              "candidate %-90s score %.1f%s",
              c.effect(),
              c.scoreGain(),
              c.named() ? " named" : ""));
    }
    return lines;
  }
}
