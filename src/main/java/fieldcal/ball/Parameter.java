package fieldcal.ball;

import java.util.Locale;
import java.util.Objects;

/**
 * One number of a model: its name, its value, and what an estimator may do with it.
 *
 * <p>The bounds limit what an estimator may answer, not what somebody may publish: a value from outside may lie beyond them;
 * {@link #clamp} brings it back before a search starts. Immutable: an estimate is a new parameter ({@link #withValue}).
 *
 * @param name the field's name for it, as in the model's record
 * @param unit its unit, empty when it has none
 * @param value its value, finite
 * @param scale a change of this size is about equally noticeable for every parameter; a solver divides by it; positive
 * @param min the smallest value an estimator may answer
 * @param max the largest value an estimator may answer, above {@code min}
 * @param estimated true when it is to be estimated, false when it is held at its value
 * @param source where the default and the bounds come from
 */
public record Parameter(
    String name,
    String unit,
    double value,
    double scale,
    double min,
    double max,
    boolean estimated,
    String source) {

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a number is not finite, the scale is not positive, or the bounds are empty
   */
  public Parameter {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(unit, "unit");
    Objects.requireNonNull(source, "source");
    Checks.finite(name, value);
    Checks.positive("scale of " + name, scale);
    Checks.finite("min of " + name, min);
    Checks.finite("max of " + name, max);
    if (max <= min) {
      throw new IllegalArgumentException(
          "bounds of " + name + " are empty: min " + min + ", max " + max);
    }
  }

  /**
   * The name of a parameter in files, which is that of the league's messages.
   *
   * @param name as in the model's record, for example {@code accSlide}
   * @return for example {@code acc_slide}
   */
  public static String inFiles(String name) {
    return name.replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
  }

  /**
   * The same parameter with another value.
   *
   * @param newValue the value, finite
   * @return the changed copy
   * @throws IllegalArgumentException when the value is not finite
   */
  public Parameter withValue(double newValue) {
    return new Parameter(name, unit, newValue, scale, min, max, estimated, source);
  }

  /**
   * The same parameter with other bounds.
   *
   * @param newMin the smallest value an estimator may answer
   * @param newMax the largest value an estimator may answer, above {@code newMin}
   * @return the changed copy
   * @throws IllegalArgumentException when a bound is not finite or the bounds are empty
   */
  public Parameter withBounds(double newMin, double newMax) {
    return new Parameter(name, unit, value, scale, newMin, newMax, estimated, source);
  }

  /**
   * The same parameter, held at its value.
   *
   * @return the changed copy
   */
  public Parameter fixed() {
    return new Parameter(name, unit, value, scale, min, max, false, source);
  }

  /**
   * The same parameter, to be estimated.
   *
   * @return the changed copy
   */
  public Parameter free() {
    return new Parameter(name, unit, value, scale, min, max, true, source);
  }

  /**
   * The nearest number within the bounds.
   *
   * @param candidate any number but NaN
   * @return {@code candidate}, or the bound that it exceeds
   * @throws IllegalArgumentException when {@code candidate} is NaN
   */
  public double clamp(double candidate) {
    if (Double.isNaN(candidate)) {
      throw new IllegalArgumentException("candidate for " + name + " must be a number, but is NaN");
    }
    return Math.max(min, Math.min(max, candidate));
  }

  /**
   * Whether the value lies within the bounds, the bounds included.
   *
   * @return true when {@code min ≤ value ≤ max}
   */
  public boolean isWithinBounds() {
    return value >= min && value <= max;
  }
}
