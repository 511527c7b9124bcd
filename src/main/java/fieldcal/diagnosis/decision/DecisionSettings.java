package fieldcal.diagnosis.decision;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;

/**
 * Every number that decides about a name, with where it comes from.
 *
 * @param falseAlarms chance that a cause gets a name in a recording with nothing wrong: a part of the budget for false names, 0.5 % of such recordings, which learned terms and what is left share
 * @param tried number of independent tests, over the columns of the dictionary and their places; measured as the effective number of independent score tests on simulated recordings with nothing wrong
 * @param uneven chance with which strengths that scatter around zero from kick to kick pass for one strength that all kicks share: the level of Hotelling's test over the kicks. Whether noise reaches the evidence is tested separately
 * @param formShare a cause that explains less than this share of what the largest cause of its kind (motion, measurement) explains, and gains little, is taken for a form of that cause: a law whose shape is right to a sixth leaves 3 % of its
 * chi-square
 * @param formGain share of the held-out residual with which it is a cause all the same: a systematic error of a quarter of the noise raises the residual by 3 %
 * @param imitation what a cause that all kicks share must explain at least, as a share of what is left: of so many effects, some have a correlation of 0.5 with whatever is left; they absorb a quarter of it and leave three quarters
 * @param fewKicks for values that differ from kick to kick: share of the gain that must come from kicks other than the two that gain most, because two numbers, a mean and a scatter, fit any two kicks
 * @param tie difference of cost up to which two explanations count as equal, in units of chi-square: odds of e³ = 20 : 1
 * @param tieShare the same as a share of what the cause explains: where much is explained, common errors of the model make larger differences than noise
 * @param dependent chance that values which differ from kick to kick by chance are found to follow something that is recorded; counted by assigning them to the kicks in other orders, so it holds for everything that is tried together. A twentieth of {@code falseAlarms},
 *     since only recordings with such values are tested, but several models of each
 * @param leastGain share of the held-out residual that a cause must gain: the noise of a camera is known to about 1 %. Of 129 causes that were named in recordings of independent generators, the true ones gained 4.5 per cent and more. A cause whose magnitude differs from kick to kick absorbs a part of anything, and must gain {@code formGain}
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
   * @param numbers how many numbers were fitted, 1 or more
   * @return chi-square, in units of what is left
   */
  public double beyondNoise(int numbers) {
    return new ChiSquaredDistribution(null, numbers)
        .inverseCumulativeProbability(1 - falseAlarms / tried);
  }
}
