package fieldcal.diagnosis;

import fieldcal.effect.Effect;
import java.util.Objects;

/**
 * One possible cause, and what speaks for it at first sight.
 *
 * @param effect with the numbers that fit best to first order, added to the simple model alone
 * @param scoreGain by how much chi-square of the simple model would fall with it, according to the score test
 * @param named whether it is one of the causes
 */
public record Candidate(Effect effect, double scoreGain, boolean named) {

  /** Checks that there is an effect. {@inheritDoc} */
  public Candidate {
    Objects.requireNonNull(effect, "effect");
  }
}
