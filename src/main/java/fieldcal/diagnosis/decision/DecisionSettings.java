package fieldcal.diagnosis.decision;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;

/**
 * Every number that decides about a name, with where it comes from.
 *
 * @param falseAlarms chance that a recording with nothing wrong gets a name: the budget is half a per cent, of which the learned terms and the leftover have their share
 * @param tried independent things that were tried: columns of the dictionary, and places of those that have one; measured as the effective number of independent score tests on sound simulated recordings
 * @param uneven chance that a cause of the same strength in all kicks is taken for one that is not; that noise does not reach it is tested, too
 * @param formShare a cause that explains less than that share of what the largest cause of its kind (motion, measurement) explains, and gains little, is that one's form: a law whose shape is right to a sixth leaves three hundredths of its
 *     chi-square
 * @param formGain share of the held-out residual from which on it is a cause all the same: three per cent of the noise is a quarter of it in variance
 * @param imitation what a cause that all kicks share must explain at least, as a share of what is left: of so many effects some correlate by a half with whatever that is, take up a quarter of it, and leave three
 * @param fewKicks share of what values of each kick's own explain that kicks other than the two that gain most must have: two numbers, a mean and a scatter, fit any two
 * @param tie difference of cost up to which two explanations are equals: odds of e³ = 20 : 1
 * @param tieShare the same as a share of what the cause explains: where much is explained, errors of the model that all explanations share decide more than noise does
 * @param dependent chance that values which differ from kick to kick by chance are found to follow something that is recorded; counted by dealing them out to the kicks in other orders, so it holds for everything that is tried together. A twentieth of {@code falseAlarms},
 *     since only a recording with such values can raise this alarm, and several models of it are judged
 * @param leastGain share of the held-out residual that a cause must gain: the noise of a camera is known to a per cent. Of 129 causes that were named in recordings of independent generators, the true ones gained 4.5 per cent and more. One whose magnitude differs from kick to kick, which takes up something of anything, must gain {@code formGain}
 */
public record DecisionSettings(
    double falseAlarms,
    double tried,
    double uneven,
    double formShare,
    double formGain,
    double imitation,
    double fewKicks,
    double tie,
    double tieShare,
    double dependent,
    double leastGain) {

  /**
   * The numbers in use.
   *
   * @return the defaults
   */
  public static DecisionSettings defaults() {
    return new DecisionSettings(2e-3, 200, 1e-5, 0.03, 0.03, 1.0 / 3, 0.15, 6, 0.002, 1e-4, 0.01);
  }

  /**
   * What noise does not reach, however many causes were tried.
   *
   * @param numbers that were fitted
   * @return chi-square, in units of what is left
   */
  public double beyondNoise(int numbers) {
    return new ChiSquaredDistribution(null, numbers)
        .inverseCumulativeProbability(1 - falseAlarms / tried);
  }
}
