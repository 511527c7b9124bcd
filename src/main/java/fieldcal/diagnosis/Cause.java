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
 * @param standardErrors standard errors of its estimated magnitudes and directions, by name, in their order and units; without places, what it acts on, and what was not free; empty when the equations are singular
 * @param scatter how much the first magnitude differs from kick to kick: standard deviation over the kicks, in the magnitude's unit; 0 for effects that are the same for all kicks
 * @param evidence half of the rise of chi-square without it, everything else fitted again, divided by the reduced chi-square that is left: about the logarithm of the odds
 * @param gain by how much it lowers the residual of held-out kicks
 * @param indistinguishableFrom ids of effects that would explain as much; such as "camera_offset of camera 1" where only the camera is uncertain
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
