package fieldcal.simulation;

import java.util.SplittableRandom;

/**
 * Seeded random numbers for one purpose. Every purpose has its own stream, so that switching one thing on does not change the numbers of another: an effect of magnitude zero leaves a recording
 * unchanged, to the last bit. Not thread-safe.
 */
public final class RandomStream {
  private final SplittableRandom random;
  private double spare = Double.NaN;

  private RandomStream(long seed) {
    random = new SplittableRandom(seed);
  }

  /**
   * The stream of a purpose.
   *
   * @param seed of the simulation
   * @param purpose names the stream
   * @return a new stream, the same for the same arguments
   */
  public static RandomStream of(long seed, String purpose) {
    // FNV-1a, 64 bit: String.hashCode would let short names collide.
    long hash = 0xcbf29ce484222325L;
    for (int i = 0; i < purpose.length(); i++) {
      hash = (hash ^ purpose.charAt(i)) * 0x100000001b3L;
    }
    return new RandomStream(seed * 0x9e3779b97f4a7c15L ^ hash);
  }

  /**
   * Uniform.
   *
   * @param min lower bound
   * @param max upper bound, not below min
   * @return a number in [min, max)
   */
  public double uniform(double min, double max) {
    return min + (max - min) * random.nextDouble();
  }

  /**
   * True with a probability.
   *
   * @param probability 0 … 1
   * @return the outcome
   */
  public boolean happens(double probability) {
    return random.nextDouble() < probability;
  }

  /**
   * A whole number.
   *
   * @param bound above 0
   * @return 0 … bound − 1
   */
  public int below(int bound) {
    return random.nextInt(bound);
  }

  /**
   * Normally distributed with mean 0 (polar method of Marsaglia).
   *
   * @param sigma standard deviation
   * @return a number
   */
  public double gaussian(double sigma) {
    if (!Double.isNaN(spare)) {
      double value = spare;
      spare = Double.NaN;
      return sigma * value;
    }
    double u;
    double v;
    double squared;
    do {
      u = uniform(-1, 1);
      v = uniform(-1, 1);
      squared = u * u + v * v;
    } while (squared >= 1 || squared == 0);
    double factor = Math.sqrt(-2 * Math.log(squared) / squared);
    spare = v * factor;
    return sigma * u * factor;
  }
}
