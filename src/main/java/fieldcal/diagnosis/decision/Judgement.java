package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.model.Component;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedTerm;
import java.util.Optional;

/**
 * What was decided about one component of a model.
 *
 * @param component which
 * @param effect with its fitted numbers
 * @param scatter standard deviation of its magnitude from kick to kick, in the magnitude's unit; 0 when it is the same for all
 * @param evidence by how much chi-square rises without it, everything else fitted again, in units of what is left
 * @param gain on held-out kicks: mm, per cent, lower and upper bound in mm
 * @param follows what its values follow, if it has one for each kick and these do not differ by chance
 * @param outcome the decision
 */
public record Judgement(
    Component component,
    Effect effect,
    double scatter,
    double evidence,
    double[] gain,
    Optional<Dependence> follows,
    Outcome outcome) {

  /** What it is taken for. */
  public enum Outcome {
    /** A cause. */
    NAMED,
    /** Among everything that was tried, noise alone would reach its evidence. */
    CHANCE,
    /** Its strength differs too much from kick to kick, or its values may come from something else. */
    UNSTEADY,
    /** It cannot be distinguished from the ball's own law with what is known of that law. */
    BALL_ITSELF,
    /** Only one or two kicks gain by it. */
    FEW_KICKS,
    /** It may be a form of something else: of a larger cause of its kind, of a learned curve, or of what is left. */
    FORM,
    /** Kicks that were held out do not gain by it. */
    NO_GAIN,
    /** Kicks that were held out gain by it, but less than any model of the ball is right to. */
    TOO_SMALL
  }

  /**
   * Whether it is a cause with a name: neither a learned curve nor chance.
   *
   * @return true when it may be named
   */
  public boolean isName() {
    boolean hasName = effect.hasOwnMean() && !(effect instanceof LearnedTerm);
    return outcome == Outcome.NAMED && hasName;
  }

  /**
   * Whether its values follow the same quantity as those of another one.
   *
   * @param other which
   * @return false where either differs by chance
   */
  public boolean followsSameAs(Judgement other) {
    return follows.isPresent()
        && follows.map(Dependence::on).equals(other.follows.map(Dependence::on));
  }

  /**
   * The same with another outcome.
   *
   * @param other the outcome
   * @return the changed copy
   */
  public Judgement as(Outcome other) {
    return new Judgement(component, effect, scatter, evidence, gain, follows, other);
  }

  /**
   * The same, named, with the evidence and the gain of the judgement whose place it takes.
   *
   * @param other which
   * @return the changed copy
   */
  public Judgement inPlaceOf(Judgement other) {
    return new Judgement(
        component, effect, scatter, other.evidence, other.gain, follows, Outcome.NAMED);
  }

  @Override
  public String toString() {
    return "%s %s evidence %.0f gain %.2f %%".formatted(outcome, effect, evidence, gain[1]);
  }
}
