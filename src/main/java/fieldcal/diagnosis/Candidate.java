package fieldcal.diagnosis;

import fieldcal.effect.Effect;
import java.util.Objects;

/**
 * One possible cause and the evidence for it. The evidence is divided by what the named causes leave unexplained, as for {@link Cause#evidence}.
 *
 * @param effect with the numbers that fit best to first order, added to the simple model alone
 * @param scoreGain by how much chi-square of the simple model would fall with it, according to the score test
 * @param evidence logarithm of the Bayes factor of the model with it alone against the simple model; NaN where it was not computed, as in every diagnosis of this version
 * @param addedEvidence logarithm of the Bayes factor that it would add to the named causes; NaN where it was not computed, as in every diagnosis of this version
 * @param named whether it is one of the causes
 */
public record Candidate(
    Effect effect, double scoreGain, double evidence, double addedEvidence, boolean named) {

  /** Checks that there is an effect. {@inheritDoc} */
  public Candidate {
    Objects.requireNonNull(effect, "effect");
  }
}
