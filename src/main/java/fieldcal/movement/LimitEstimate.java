package fieldcal.movement;

import java.util.Objects;

/**
 * A limit of a team's robots, or why it is not known.
 *
 * @param value m/s or m/s², positive; NaN when undetermined
 * @param standardError in the same unit, from the noise and the number of samples, and for accelerations the error of the method itself; NaN when unknown
 * @param samples number of observations behind the estimate
 * @param reached false when the robots were never seen at their limit: then the value is only a lower bound
 * @param note why it is undetermined or only a bound; empty otherwise
 */
public record LimitEstimate(
    double value, double standardError, long samples, boolean reached, String note) {

  /**
   * Checks the note. {@inheritDoc}
   *
   * @throws NullPointerException when it is null
   */
  public LimitEstimate {
    Objects.requireNonNull(note, "note");
  }

  /**
   * No value.
   *
   * @param samples how many observations there were
   * @param why they do not determine it
   * @return an estimate without a value
   */
  public static LimitEstimate undetermined(long samples, String why) {
    return new LimitEstimate(Double.NaN, Double.NaN, samples, false, why);
  }

  /**
   * Whether there is a value.
   *
   * @return false when undetermined
   */
  public boolean known() {
    return Double.isFinite(value);
  }
}
