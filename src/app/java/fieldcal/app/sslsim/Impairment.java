package fieldcal.app.sslsim;

/**
 * A bad network: what the served field loses and delays, in both directions.
 *
 * @param loss share of the packets that are lost, 0 … 1
 * @param delay of those that are not, s
 */
public record Impairment(double loss, double delay) {
  /** A good network. */
  public static final Impairment NONE = new Impairment(0, 0);

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the loss is not in [0, 1] or the delay not in [0, 1] s (or NaN)
   */
  public Impairment {
    if (!(loss >= 0 && loss <= 1 && delay >= 0 && delay <= 1)) {
      throw new IllegalArgumentException(
          "loss must lie in [0, 1] and delay in [0, 1] s, but are " + loss + " and " + delay);
    }
  }
}
