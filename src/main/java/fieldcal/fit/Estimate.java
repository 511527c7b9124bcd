package fieldcal.fit;

import fieldcal.ball.Parameter;
import java.util.Objects;
import java.util.Optional;

/**
 * What a fit says of one parameter.
 *
 * @param parameter with the estimated value; {@code estimated} tells whether it was free
 * @param standardError of the value, same unit; NaN when it was fixed
 * @param undetermined why the data do not determine it; then the value is little more than the start and must not be averaged
 * @param atBound whether the estimate ran into a bound
 */
public record Estimate(
    Parameter parameter, double standardError, Optional<String> undetermined, boolean atBound) {

  /** Checks that nothing is missing. {@inheritDoc} */
  public Estimate {
    Objects.requireNonNull(parameter, "parameter");
    Objects.requireNonNull(undetermined, "undetermined");
  }

  /**
   * The parameter's name.
   *
   * @return as in the model's record
   */
  public String name() {
    return parameter.name();
  }

  /**
   * The estimate.
   *
   * @return in the parameter's unit
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
}
