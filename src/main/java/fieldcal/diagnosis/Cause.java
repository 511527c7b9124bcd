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
 * @param standardErrors of its estimated magnitudes and directions, by name, in their order and units; none of places, of what it acts on, and of what was not free; empty when the equations are singular
 * @param scatter how much the first magnitude differs from kick to kick: standard deviation over the kicks, in the magnitude's unit; 0 for effects that are the same for all kicks
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
