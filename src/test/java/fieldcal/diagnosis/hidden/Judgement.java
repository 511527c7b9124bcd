package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.hidden.Answer.Named;
import fieldcal.simulation.EffectSetting;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What a diagnosis is worth, measured by the truth.
 *
 * @param outcome in one word
 * @param found each hidden effect that has a name and what became of it
 * @param wrong causes named that are not there
 * @param excused causes named beside those that are there, which describe a part of them
 * @param verdict of the diagnosis, as in files
 * @param rightVariable whether what a cause without a name depends on was said first; empty without such a cause and where nothing was said
 */
public record Judgement(
    Outcome outcome,
    List<Found> found,
    List<Named> wrong,
    List<Named> excused,
    String verdict,
    Optional<Boolean> rightVariable) {

  /** In one word. */
  public enum Outcome {
    /** All that is there is named, and nothing else; beside an unnamed cause it is said that something is left or learned. */
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
      Optional<Named> cause,
      Optional<Strength> strength) {}

  /**
   * The error of a strength.
   *
   * @param scores error of each comparable parameter in its own standard errors
   * @param percent error over truth, directions and components together, %; NaN where it makes no sense
   */
  public record Strength(List<Double> scores, double percent) {
    /** Copies the list. {@inheritDoc} */
    public Strength {
      scores = List.copyOf(scores);
    }

    static Strength of(double percent, double... scores) {
      return new Strength(
          Arrays.stream(scores).filter(Double::isFinite).map(Math::abs).boxed().toList(), percent);
    }

    /**
     * The largest error.
     *
     * @return in standard errors; NaN where none is comparable
     */
    public double sigmas() {
      return scores.stream().mapToDouble(Double::doubleValue).max().orElse(Double.NaN);
    }
  }

  /** Copies the lists. {@inheritDoc} */
  public Judgement {
    found = List.copyOf(found);
    wrong = List.copyOf(wrong);
    excused = List.copyOf(excused);
  }

  /**
   * Hidden effects that could be seen.
   *
   * @return those that are not invisible
   */
  public List<Found> visible() {
    return found.stream()
        .filter(f -> f.visibility().level() != Visibility.Class.INVISIBLE)
        .toList();
  }

  /**
   * Whether all that could be seen was named or tied, and nothing else.
   *
   * @return false with a wrong name or a visible cause that was missed
   */
  public boolean complete() {
    return wrong.isEmpty() && visible().stream().allMatch(f -> f.how() != How.NOT);
  }

  /**
   * What was said, for a line of text.
   *
   * @param answer of the diagnosis
   * @return verdict, names, numbers, ties, terms
   */
  static String said(Answer answer) {
    Stream<String> names =
        answer.causes().stream()
            .map(
                c ->
                    Likeness.text(c.effect())
                        + (c.scatter() > 0 ? "±%.3f".formatted(c.scatter()) : "")
                        + " (%.1f".formatted(c.evidence())
                        + (c.indistinguishableFrom().isEmpty()
                            ? ")"
                            : "; or " + String.join(", ", c.indistinguishableFrom()) + ")"));
    Stream<String> terms =
        answer.learned().stream()
            .map(t -> "learned " + t.actsOn() + " by " + String.join(", ", t.dependsOn()));
    String all = Stream.concat(names, terms).collect(Collectors.joining(" + "));
    return answer.verdict() + (all.isEmpty() ? "" : ": " + all);
  }
}
