package fieldcal.diagnosis;

import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.diagnosis.validation.HoldOut;
import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * How well a model does.
 *
 * @param rmsMm residual per axis of all kicks in the joint fit, mm
 * @param noiseMm what {@code rmsMm} would be if the model were right: the cameras' noise per axis, mm
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
   * @throws IllegalArgumentException when the two maps have different horizons
   */
  public Quality {
    predictionErrorMm = Collections.unmodifiableMap(new TreeMap<>(predictionErrorMm));
    typicalErrorMm = Collections.unmodifiableMap(new TreeMap<>(typicalErrorMm));
    if (!typicalErrorMm.keySet().equals(predictionErrorMm.keySet())) {
      throw new IllegalArgumentException(
          "horizons differ: " + predictionErrorMm.keySet() + " and " + typicalErrorMm.keySet());
    }
  }

  /** The quality of a model that was fitted to all kicks. */
  static Quality of(FittedModel f, HoldOut held) {
    ModelState state = f.solution().state();
    double squares = 0;
    double variance = 0;
    int n = 0;
    for (int k = 0; k < f.kickCount(); k++) {
      EffectKick term = f.kick(k);
      KickRecord d = term.record().asSeen();
      double[] rx = new double[d.size()];
      double[] ry = new double[d.size()];
      term.plainResiduals(f.solution().own(k), state, rx, ry);
      boolean[] used = d.used();
      for (int i = 0; i < rx.length; i++) {
        if (used[i]) {
          squares += rx[i] * rx[i] + ry[i] * ry[i];
          variance += 2 * d.variance(i);
          n += 2;
        }
      }
    }
    return new Quality(
        1000 * Math.sqrt(squares / n),
        1000 * Math.sqrt(variance / n),
        held.rmsMm(),
        held.predictionMm(),
        held.typicalMm());
  }
}
