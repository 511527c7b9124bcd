package fieldcal.diagnosis.decision;

import fieldcal.effect.learned.Variable;
import java.util.Objects;

/**
 * What a value that differs from kick to kick follows: a recorded quantity, and the form of the dependence.
 *
 * @param on the recorded quantity: session time, place, heading or speed of the kick
 * @param form how the value follows it
 * @param functions how many functions the form has beside a constant
 * @param place where a step is, halfway between the last kick before and the first after it, in the quantity's unit; NaN of other forms
 * @param change change of the value at a step, in the value's unit, or slope of a straight line, per unit of the quantity; NaN for a curve
 * @param lowest where the form is lowest among the kicks
 * @param highest where it is highest
 * @param explained share of the values' variance that the form explains, 0 to 1
 * @param chance that values without any order follow something as closely, given everything that was tried
 */
public record Dependence(
    Variable on,
    Form form,
    int functions,
    double place,
    double change,
    Level lowest,
    Level highest,
    double explained,
    double chance) {

  /** How a value follows a quantity. */
  public enum Form {
    /** A straight line. */
    LINE,
    /** A smooth curve, or a smooth surface over the place. */
    CURVE,
    /** One value before an instant of the session, another after it. */
    STEP
  }

  /**
   * The form at one kick.
   *
   * @param x the quantity there; of a place its x
   * @param y y of a place; 0 of all else
   * @param value the form's value there relative to the mean of all kicks, in the value's unit
   */
  public record Level(double x, double y, double value) {}

  /** Checks that nothing is missing. {@inheritDoc} */
  public Dependence {
    Objects.requireNonNull(on, "on");
    Objects.requireNonNull(form, "form");
    Objects.requireNonNull(lowest, "lowest");
    Objects.requireNonNull(highest, "highest");
  }
}
