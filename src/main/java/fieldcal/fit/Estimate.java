package fieldcal.fit;

import fieldcal.ball.Parameter;
import java.util.Objects;
import java.util.Optional;
import org.apache.commons.math3.distribution.TDistribution;

/**
 * One parameter as a fit determines it.
 *
 * @param parameter with the estimated value; {@code estimated} says whether it was free
 * @param standardError of the value, same unit; NaN when it was fixed
 * @param undetermined why the data do not determine it; then the value is little more than the start and must not be averaged
 * @param atBound whether the estimate ran into a bound
 */
public record Estimate(
    Parameter parameter, double standardError, Optional<String> undetermined, boolean atBound) {
  /** Share of a normal distribution below its mean plus two standard deviations. */
  private static final double TWO_SIGMA = 0.97725;

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when the parameter or the reason is null
   */
  public Estimate {
    Objects.requireNonNull(parameter, "parameter");
    Objects.requireNonNull(undetermined, "undetermined");
  }

  /**
   * The parameter's name.
   *
   * @return as in the model's record (accSlide), or x, y, vx, vy, vz, t0
   */
  public String name() {
    return parameter.name();
  }

  /**
   * The estimate; not a measurement unless {@link #usable}.
   *
   * @return in the parameter's unit; where it was fixed or not determined, the value that it started from or nearly so
   */
  public double value() {
    return parameter.value();
  }

  /**
   * Whether the value is a measurement: free, determined, and inside its bounds.
   *
   * @return true when it may be averaged
   */
  public boolean usable() {
    return parameter.estimated()
        && undetermined.isEmpty()
        && !atBound
        && Double.isFinite(standardError);
  }

  /**
   * Factor by which the error of a mean grows because its scatter was estimated from few samples: with it, the truth lies within two standard errors as often as with a known scatter (Student 1908, Biometrika 6, 1). No factor is right for every number of standard errors: with this one and twelve samples, the truth lies within one standard error in 72 instead of 68 % of cases.
   *
   * @param samples number of samples, at least 2
   * @return the factor (–): 7 for two samples, 1.3 for six, 1.13 for twelve, nearer to 1 the more there are
   */
  public static double student(int samples) {
    return new TDistribution(null, samples - 1.0).inverseCumulativeProbability(TWO_SIGMA) / 2;
  }
}
