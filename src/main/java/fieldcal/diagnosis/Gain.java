package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.Judgement;

/**
 * By how much something lowers the residual per axis of kicks that were held out of the fit. All numbers may be negative.
 *
 * @param mm root mean square without minus root mean square with it, mm
 * @param percent {@code mm} in per cent of the root mean square without it
 * @param lowMm lower bound of {@code mm}: 2.5 % quantile of a bootstrap over kicks
 * @param highMm upper bound: 97.5 % quantile
 */
public record Gain(double mm, double percent, double lowMm, double highMm) {

  /** What a component of a model gains. */
  static Gain of(Judgement j) {
    return new Gain(j.gain()[0], j.gain()[1], j.gain()[2], j.gain()[3]);
  }

  /**
   * Whether held-out kicks show that it helps at all.
   *
   * @return true when the lower bound is above zero; false when it is NaN
   */
  public boolean isBeyondChance() {
    return lowMm > 0;
  }
}
