package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.model.Component;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedTerm;
import java.util.Map;
import java.util.Optional;

/**
 * What was decided about one component of a model.
 *
 * @param component which
 * @param effect with its fitted numbers
 * @param errors standard errors of its parameters, by name
 * @param scatter of its magnitude from kick to kick; 0 when it is the same for all
 * @param evidence by how much chi-square rises without it, everything else fitted again, in units of what is left
 * @param gain on held-out kicks: mm, per cent, lower and upper bound in mm
 * @param follows what its values follow, if it has one for each kick and these do not differ by chance
 * @param outcome the decision
 */
public record Judgement(
    Component component,
    Effect effect,
    Map<String, Double> errors,
    double scatter,
    double evidence,
    double[] gain,
    Optional<Dependence> follows,
    Outcome outcome) {

  /** What it is taken for. */
  public enum Outcome {
    /** A cause. */
    NAMED,
    /** Noise reaches as much among everything that was tried. */
    CHANCE,
    /** Its strength differs from kick to kick more than a cause's does. */
    UNSTEADY,
    /** It differs from what the ball's own law may be by less than is known of that law. */
    BALL_ITSELF,
    /** Only one or two kicks gain by it. */
    FEW_KICKS,
    /** It is little beside a larger cause of its kind: that one's form. */
    FORM,
    /** Kicks that were held out do not gain by it. */
    NO_GAIN
  }

  /**
   * Whether it is a cause that has a name: no curve, and no chance.
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
   * The same, taken for something else.
   *
   * @param other what for
   * @return the changed copy
   */
  public Judgement as(Outcome other) {
    return new Judgement(component, effect, errors, scatter, evidence, gain, follows, other);
  }

  /**
   * The same, with what another one explained and gained whose place it took.
   *
   * @param other which
   * @return the changed copy
   */
  public Judgement inPlaceOf(Judgement other) {
    return new Judgement(
        component, effect, errors, scatter, other.evidence, other.gain, follows, Outcome.NAMED);
  }

  @Override
  public String toString() {
    return "%s %s evidence %.0f gain %.2f %%".formatted(outcome, effect, evidence, gain[1]);
  }
}
