package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.Dependence;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.LearnedTerm;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Something that improves the prediction of held-out kicks without being a named cause: a learned curve, a law that takes the place of the simple model's, what differs from kick to kick by chance, or an effect that is not proven.
 *
 * @param effect the term as the extended model holds it
 * @param actsOn "ground", "impact", "kick" or "measurement"
 * @param dependsOn the variables
 * @param camera id of the camera whose reports it changes; empty for everything else
 * @param curves one for each component, over the range of the data; empty for all but a learned curve
 * @param scatter standard deviation from kick to kick, in the unit of the effect's magnitude; 0 for what all kicks share
 * @param follows what the values of the kicks follow; empty where they differ by chance, and of all that kicks share
 * @param gain on kicks that were held out
 */
public record LearnedFinding(
    Effect effect,
    String actsOn,
    List<String> dependsOn,
    OptionalInt camera,
    List<LearnedCurve> curves,
    double scatter,
    Optional<Dependence> follows,
    Gain gain) {

  /** Copies the lists. {@inheritDoc} */
  public LearnedFinding {
    Objects.requireNonNull(effect, "effect");
    Objects.requireNonNull(follows, "follows");
    dependsOn = List.copyOf(dependsOn);
    curves = List.copyOf(curves);
  }

  /** What it is. */
  public enum Kind {
    /** A learned curve. */
    CURVE,
    /** A law that takes the place of the simple model's. */
    LAW,
    /** What differs from kick to kick and has no mean of its own: by chance, unless its values follow something. */
    SCATTER,
    /** An effect of the catalogue without which kicks are predicted worse, and which is not proven to be a cause. */
    UNPROVEN
  }

  /**
   * What it is.
   *
   * @return its kind
   */
  public Kind kind() {
    if (effect instanceof LearnedTerm) {
      return Kind.CURVE;
    }
    if (!effect.hasOwnMean()) {
      return Kind.SCATTER;
    }
    return effect.starts().isEmpty() ? Kind.UNPROVEN : Kind.LAW;
  }

  /**
   * Whether it may be reported as something that helps. A law and what differs by chance are in the model for what they explain, whatever they gain. Everything else must gain on held-out kicks.
   *
   * @return false for a curve or an effect whose gain may be due to the choice of the kicks
   */
  public boolean isShownToHelp() {
    return kind() == Kind.LAW || kind() == Kind.SCATTER || gain.isBeyondChance();
  }
}
