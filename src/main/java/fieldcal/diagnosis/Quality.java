package fieldcal.diagnosis;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * How well a model does.
 *
 * @param rmsMm residual per axis of all kicks in the joint fit, mm
 * @param noiseMm what it would be if the model were right: the cameras' noise, mm
 * @param holdoutRmsMm residual per axis of kicks that the shared parameters were not fitted to, mm; NaN with too few kicks
 * @param predictionErrorMm distance between predicted and seen position, root mean square, mm, by horizon in s: predicted from the first 0.3 s of kicks that were
 *     held out; horizons that no kick reaches are missing
 */
public record Quality(
    double rmsMm, double noiseMm, double holdoutRmsMm, Map<Double, Double> predictionErrorMm) {

  /** Copies the map, in order. {@inheritDoc} */
  public Quality {
    predictionErrorMm = Collections.unmodifiableMap(new TreeMap<>(predictionErrorMm));
  }
}
