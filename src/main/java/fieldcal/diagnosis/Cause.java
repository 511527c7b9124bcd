package fieldcal.diagnosis;

import fieldcal.effect.Effect;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * One cause of what the simple model gets wrong.
 *
 * @param effect the effect with its fitted numbers
 * @param standardErrors of its estimated parameters, by name, in their order and units
 * @param scatter how much the magnitude differs from kick to kick, standard deviation; 0 for effects that are the same for all kicks
 * @param evidence natural logarithm of the Bayes factor of the extended model with this cause against that without it
 * @param gain what kicks that were held out gain from it
 * @param indistinguishableFrom ids of effects that would explain the same as well
 * @param discriminatingKicks which kicks would tell these apart, for operators; empty when nothing is to be told apart
 */
public record Cause(
    Effect effect,
    Map<String, Double> standardErrors,
    double scatter,
    double evidence,
    Gain gain,
    List<String> indistinguishableFrom,
    String discriminatingKicks) {

  /** Copies the collections. {@inheritDoc} */
  public Cause {
    Objects.requireNonNull(effect, "effect");
    Objects.requireNonNull(gain, "gain");
    Objects.requireNonNull(discriminatingKicks, "discriminatingKicks");
    standardErrors = Collections.unmodifiableMap(new LinkedHashMap<>(standardErrors));
    indistinguishableFrom = List.copyOf(indistinguishableFrom);
  }
}
