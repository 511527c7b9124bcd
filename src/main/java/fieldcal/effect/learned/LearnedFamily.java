package fieldcal.effect.learned;

import fieldcal.ball.Parameter;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.stream.Collectors;

/**
 * Learned terms that differ in their coefficients only: what they change, on what they depend, in which basis.
 *
 * @param quantity what changes
 * @param variables on what it depends, in the order of the basis' numbers
 * @param basis the functions
 * @param camera whose reports change; there for measurements, and for nothing else
 */
public record LearnedFamily(
    Quantity quantity, List<Variable> variables, Basis basis, OptionalInt camera) {

  /**
   * Checks that all fits together. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the basis is of another number of variables, a variable is not known where the quantity acts, or there is no camera where there
   *     must be one or the other way round; the message begins with the field of files
   */
  public LearnedFamily {
    Objects.requireNonNull(quantity, "quantity");
    Objects.requireNonNull(camera, "camera");
    variables = List.copyOf(variables);
    int dimension = variables.stream().mapToInt(Variable::dimension).sum();
    if (dimension != basis.dimension()) {
      throw new IllegalArgumentException(
          "basis: is of %d numbers, but depends_on has %d".formatted(basis.dimension(), dimension));
    }
    for (Variable v : variables) {
      if (!v.isKnownAt(quantity) || !quantity.canDependOn(v)) {
        throw new IllegalArgumentException(
            "depends_on: " + v.label() + " is not known for " + quantity.label());
      }
    }
    if (quantity == Quantity.FLOOR && !(basis instanceof Surface)) {
      throw new IllegalArgumentException(
          "basis: must be a surface for " + quantity.label() + ", but is " + basis.type());
    }
    if (camera.isPresent() != quantity.actsOn().equals("measurement")) {
      throw new IllegalArgumentException(
          "camera: must be "
              + (camera.isPresent() ? "missing" : "there")
              + " for "
              + quantity.label());
    }
  }

  /**
   * A family of the ball's motion.
   *
   * @param quantity what changes
   * @param variable on what it depends
   * @param basis the functions
   * @return the family
   * @throws IllegalArgumentException as the constructor
   */
  public static LearnedFamily of(Quantity quantity, Variable variable, Basis basis) {
    return new LearnedFamily(quantity, List.of(variable), basis, OptionalInt.empty());
  }

  /**
   * A family of what a camera reports.
   *
   * @param quantity what changes
   * @param variable on what it depends
   * @param basis the functions
   * @param camera whose reports
   * @return the family
   * @throws IllegalArgumentException as the constructor
   */
  public static LearnedFamily of(Quantity quantity, Variable variable, Basis basis, int camera) {
    return new LearnedFamily(quantity, List.of(variable), basis, OptionalInt.of(camera));
  }

  /**
   * A name that no other family of a library has.
   *
   * @return for example "acceleration_along/speed" or "shift/image_position/camera 2"
   */
  public String key() {
    String on = variables.stream().map(Variable::label).collect(Collectors.joining("+"));
    if (isPeriodic()) {
      // A periodic term, which repeats with each turn of the ball or in time, has another name than
      // a smooth one.
      on += "/periodic";
    }
    return quantity.label() + "/" + on + (camera.isPresent() ? "/camera " + camera.getAsInt() : "");
  }

  /**
   * Whether it is periodic in a distance or in a time. A function of an angle, which always is, does not count.
   *
   * @return true of harmonics over anything but an angle
   */
  public boolean isPeriodic() {
    return basis instanceof Harmonics && !variables.contains(Variable.HEADING);
  }

  /**
   * How many coefficients a term has.
   *
   * @return functions of the basis times components of the quantity
   */
  public int size() {
    return basis.size() * quantity.components();
  }

  /**
   * The term without any coefficient.
   *
   * @return an absent effect
   */
  public LearnedTerm absent() {
    return term(new double[size()]);
  }

  /**
   * A term.
   *
   * @param coefficients {@link #size()} finite numbers in the quantity's unit
   * @return the effect
   * @throws IllegalArgumentException when the count is wrong or a number is not finite
   */
  public LearnedTerm term(double... coefficients) {
    return switch (quantity) {
      case ACCELERATION_ALONG, ACCELERATION_ACROSS -> new LearnedAcceleration(this, coefficients);
      case FRICTION -> new LearnedFriction(this, coefficients);
      case ROLLING -> new LearnedRolling(this, coefficients);
      case SLIDING -> new LearnedSliding(this, coefficients);
      case PUSH -> new LearnedPush(this, coefficients);
      case FLOOR -> new LearnedFloor(this, coefficients);
      case NAP -> new LearnedNap(this, coefficients);
      case AIR -> new LearnedAir(this, coefficients);
      case VERTICAL_RESTITUTION, TANGENTIAL_RESTITUTION, TURN ->
          new LearnedBounce(this, coefficients);
      case SPIN -> new LearnedSpin(this, coefficients);
      case SHIFT -> new LearnedShift(this, coefficients);
      case TIME_ERROR -> new LearnedTimeError(this, coefficients);
    };
  }

  List<Parameter> parameters(double[] coefficients) {
    List<Parameter> all = new ArrayList<>(coefficients.length);
    Quantity q = quantity;
    for (int i = 0; i < coefficients.length; i++) {
      all.add(
          new Parameter(
              "c" + (i + 1),
              q.unit(),
              coefficients[i],
              q.scale(),
              -q.limit(),
              q.limit(),
              true,
              q.source()));
    }
    return all;
  }
}
