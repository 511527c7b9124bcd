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
 * @param typicalErrorMm the same of a usual kick, which no single kick decides: root mean square over the kicks, where one that is more than three times as wrong as the median kick counts as three
 *     times; the same horizons
 */
public record Quality(
    double rmsMm,
    double noiseMm,
    double holdoutRmsMm,
    Map<Double, Double> predictionErrorMm,
    Map<Double, Double> typicalErrorMm) {

  /**
   * Copies the maps, in order. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the two have other horizons
   */
  public Quality {
    predictionErrorMm = Collections.unmodifiableMap(new TreeMap<>(predictionErrorMm));
    typicalErrorMm = Collections.unmodifiableMap(new TreeMap<>(typicalErrorMm));
    if (!typicalErrorMm.keySet().equals(predictionErrorMm.keySet())) {
      throw new IllegalArgumentException(
          "horizons differ: " + predictionErrorMm.keySet() + " and " + typicalErrorMm.keySet());
    }
  }
}
