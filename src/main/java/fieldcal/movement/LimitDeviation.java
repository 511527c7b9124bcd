package fieldcal.movement;

import java.util.Objects;

/**
 * A named departure from the model of one limit for all speeds and directions.
 *
 * @param effect what it is
 * @param coefficient its size, as in {@link MovementEffect} (–)
 * @param standardError of the coefficient, from the noise, the number of manoeuvres, and the error of the method itself (–)
 * @param seenIn {@code acceleration} or {@code braking}
 * @param shareBefore share of the manoeuvres that lie at a uniform limit
 * @param shareAfter share of the manoeuvres that lie at the limit with this effect
 */
public record LimitDeviation(
    MovementEffect effect,
    double coefficient,
    double standardError,
    String seenIn,
    double shareBefore,
    double shareAfter) {

  /**
   * Checks the words. {@inheritDoc}
   *
   * @throws NullPointerException when one is null
   */
  public LimitDeviation {
    Objects.requireNonNull(effect, "effect");
    Objects.requireNonNull(seenIn, "seenIn");
  }
}
