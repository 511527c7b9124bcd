package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Verdict;
import fieldcal.simulation.EffectSetting;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What a diagnosis is worth, measured by the truth.
 *
 * @param outcome in one word
 * @param found each hidden effect and what became of it
 * @param wrong causes named that are not there
 * @param verdict of the diagnosis
 */
public record Judgement(Outcome outcome, List<Found> found, List<Cause> wrong, Verdict verdict) {

  /** In one word. */
  public enum Outcome {
    /** All that is there is named, and nothing else; of nothing or of an unknown effect: no cause is blamed. */
    RIGHT,
    /** The same, but a name is only among those that a cause is said to be indistinguishable from. */
    TIE,
    /** Something that is there is not named, and nothing is said to be left. */
    MISSED,
    /** Nothing wrong is named, but something is said to be there that is not explained, while the catalogue has it. */
    UNEXPLAINED,
    /** Something is named that is not there. */
    WRONG
  }

  /** How an effect was found. */
  public enum How {
    /** By its name. */
    NAMED,
    /** Only as one that a named cause may be, too. */
    TIED,
    /** Not at all. */
    NOT
  }

  /**
   * What became of a hidden effect.
   *
   * @param hidden the effect
   * @param visibility how well it could be seen alone
   * @param how whether it was found
   * @param cause the cause that is it
   * @param strength how well its strength was met; only when named
   */
  public record Found(
      EffectSetting hidden,
      Visibility visibility,
      How how,
      Optional<Cause> cause,
      Optional<Strength> strength) {}

  /**
   * The error of a strength.
   *
   * @param sigmas largest error of a parameter in its own standard errors; NaN where none is comparable
   * @param percent error over truth, directions and components together, %; NaN where it makes no sense
   */
  public record Strength(double sigmas, double percent) {}

  /** Copies the lists. {@inheritDoc} */
  public Judgement {
    found = List.copyOf(found);
    wrong = List.copyOf(wrong);
  }

  /**
   * What was said, for a line of text.
   *
   * @param causes the causes of the diagnosis
   * @param verdict its verdict
   * @return names, numbers, ties
   */
  static String said(List<Cause> causes, Verdict verdict) {
    String names =
        causes.stream()
            .map(
                c ->
                    Likeness.text(c.effect())
                        + (c.scatter() > 0 ? "±%.3f".formatted(c.scatter()) : "")
                        + " (%.1f".formatted(c.evidence())
                        + (c.indistinguishableFrom().isEmpty()
                            ? ")"
                            : "; or " + String.join(", ", c.indistinguishableFrom()) + ")"))
            .collect(Collectors.joining(" + "));
    return verdict.id() + (names.isEmpty() ? "" : ": " + names);
  }
}
