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
 * @param evidence half of what chi-square rises by without it, everything else fitted again, in units of what is left: about the logarithm of the odds
 * @param gain what kicks that were held out gain from it
 * @param indistinguishableFrom ids of effects that would explain the same; "camera_offset of camera 1" where only the camera is open
 */
public record Cause(
    Effect effect,
    Map<String, Double> standardErrors,
    double scatter,
    double evidence,
    Gain gain,
    List<String> indistinguishableFrom) {

  /** Copies the collections. {@inheritDoc} */
  public Cause {
    Objects.requireNonNull(effect, "effect");
    Objects.requireNonNull(gain, "gain");
    standardErrors = Collections.unmodifiableMap(new LinkedHashMap<>(standardErrors));
    indistinguishableFrom = List.copyOf(indistinguishableFrom);
  }
}
