package fieldcal.diagnosis;

import fieldcal.effect.Effect;
import java.util.Objects;

/**
 * One possible cause and the evidence for it. Evidence counts less the more the named causes leave unexplained, as it does for {@link Cause#evidence}.
 *
 * @param effect with the numbers that fit best, alone on the simple model
 * @param scoreGain by how much the score test says that chi-square would fall on the simple model
 * @param evidence logarithm of its Bayes factor alone against the simple model; NaN where the score test left it no chance
 * @param addedEvidence logarithm of the Bayes factor that it would add to the causes named; NaN for those named themselves
 * @param named whether it is one of the causes
 */
public record Candidate(
    Effect effect, double scoreGain, double evidence, double addedEvidence, boolean named) {

  /** Checks that there is an effect. {@inheritDoc} */
  public Candidate {
    Objects.requireNonNull(effect, "effect");
  }
}
