package fieldcal.archive.venue;

import java.io.Serializable;

/**
 * A value with its standard error.
 *
 * @param value in its own unit
 * @param error its standard error, positive
 */
public record Measured(double value, double error) implements Serializable {

  /**
   * Whether both are numbers that can be used.
   *
   * @return false when one is missing
   */
  public boolean known() {
    return Double.isFinite(value) && error > 0 && error < Double.POSITIVE_INFINITY;
  }
}
