package fieldcal.effect.learned;

import fieldcal.ball.Parameter;
import fieldcal.effect.Area;
import fieldcal.effect.Arena;
import fieldcal.effect.BallMotion;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.apache.commons.math3.util.MathArrays;

/**
 * A smooth term that describes what no named effect explains: a {@linkplain LearnedFamily family} with its coefficients c1 … cK, all of which are magnitudes. Also
 * a {@link fieldcal.effect.MotionEffect} or a {@link fieldcal.effect.MeasurementEffect}. Immutable.
 */
public abstract sealed class LearnedTerm implements Effect
    permits LearnedAcceleration,
        LearnedRolling,
        LearnedSliding,
        LearnedPush,
        LearnedFloor,
        LearnedNap,
        LearnedAir,
        LearnedBounce,
        LearnedSpin,
        LearnedShift,
        LearnedTimeError {
  /** The id of all learned terms. */
  public static final String ID = "learned";

  private final LearnedFamily family;
  private final double[] coefficients;
  private final Basis.Curve[] curves;
  private final Variable first;

  /** Where the second number of the basis comes from: the same variable when that is a place, null when there is none. */
  private final Variable second;

  LearnedTerm(LearnedFamily family, double[] coefficients) {
    this.family = family;
    this.coefficients = EffectParameters.require(ID, coefficients, family.size()).clone();
    curves = new Basis.Curve[family.quantity().components()];
    for (int i = 0; i < curves.length; i++) {
      curves[i] = family.basis().curve(this.coefficients, i * family.basis().size());
    }
    List<Variable> variables = family.variables();
    first = variables.get(0);
    second = variables.size() > 1 ? variables.get(1) : null;
  }

  /**
   * What it changes, on what it depends, in which basis.
   *
   * @return the family
   */
  public final LearnedFamily family() {
    return family;
  }

  /**
   * Where it acts.
   *
   * @return "ground", "impact", "kick" or "measurement"
   */
  public final String actsOn() {
    return family.quantity().actsOn();
  }

  /**
   * On what it depends.
   *
   * @return names of {@linkplain Variable variables}, in the order of the basis' numbers
   */
  @Override
  public final List<String> dependsOn() {
    return family.variables().stream().map(Variable::label).toList();
  }

  /**
   * Whose reports it changes.
   *
   * @return camera id; empty for the motion of the ball
   */
  public final OptionalInt camera() {
    return family.camera();
  }

  /**
   * The coefficients.
   *
   * @return a copy, in the quantity's unit
   */
  public final double[] coefficients() {
    return coefficients.clone();
  }

  /**
   * Its value for given variables.
   *
   * @param component 0, or 1 for the second component of a quantity that has two (see {@link Quantity})
   * @param u first number of the basis
   * @param v second number; not used when there is one
   * @return in the quantity's unit
   */
  public final double valueAt(int component, double u, double v) {
    return curves[component].at(u, v);
  }

  /** Its value at an instant of the motion, or a component of it. */
  final double valueAt(int component, BallMotion m) {
    double v = second == null ? first.second(m) : second.first(m);
    return curves[component].at(first.first(m), v);
  }

  /** The longest step over which it hardly changes, s. */
  final double longestStepFor(BallMotion m) {
    Basis basis = family.basis();
    double longest = basis.resolution(0) / first.rate(m);
    if (basis.dimension() == 2) {
      double rate = second == null ? first.rate(m) : second.rate(m);
      longest = Math.min(longest, basis.resolution(1) / rate);
    }
    return longest;
  }

  /** Whether it depends on a variable. */
  final boolean dependsOn(Variable variable) {
    return family.variables().contains(variable);
  }

  /** {@inheritDoc} With what it changes, on what it depends, and the number of its coefficients. */
  @Override
  public final String label() {
    return ID + " " + family.key() + " of " + coefficients.length;
  }

  /** {@inheritDoc} It has more functions. */
  @Override
  public final Optional<Effect> finer() {
    return family.basis().finer().map(this::in);
  }

  private LearnedTerm in(Basis finer) {
    Basis coarse = family.basis();
    double[] all = new double[0];
    for (int i = 0; i < curves.length; i++) {
      all = MathArrays.concatenate(all, coarse.inFiner(coefficients, i * coarse.size()));
    }
    return new LearnedFamily(family.quantity(), family.variables(), finer, family.camera())
        .term(all);
  }

  @Override
  public abstract LearnedTerm withParameters(double... values);

  @Override
  public final String subject() {
    return family.key();
  }

  @Override
  public final String id() {
    return ID;
  }

  @Override
  public final String sentence() {
    String on = String.join(" and ", dependsOn()).replace('_', ' ');
    String what = family.quantity().label().replace('_', ' ');
    String who = camera().isPresent() ? " of camera " + camera().getAsInt() : "";
    return "The data show a change of " + what + who + " that depends on " + on + ".";
  }

  @Override
  public final List<Parameter> parameters() {
    return family.parameters(coefficients);
  }

  @Override
  public final List<String> magnitudes() {
    return parameters().stream().map(Parameter::name).toList();
  }

  @Override
  public final LearnedTerm withNone() {
    return family.absent();
  }

  @Override
  public final boolean isAbsent() {
    for (double c : coefficients) {
      if (c != 0) {
        return false;
      }
    }
    return true;
  }

  @Override
  public final Optional<Area> reach() {
    return first == Variable.PLACE && family.basis() instanceof Surface s
        ? s.support(coefficients)
        : Optional.empty();
  }

  @Override
  public final boolean changesWithTime() {
    return dependsOn(Variable.SESSION_TIME);
  }

  @Override
  public final boolean canShowIn(Arena arena) {
    return switch (actsOn()) {
      case "impact" -> arena.chips();
      case "kick" -> arena.flats();
      case "measurement" -> arena.cameras().stream().anyMatch(c -> c.id() == camera().getAsInt());
      default -> true;
    };
  }

  @Override
  public final boolean equals(Object other) {
    return this == other
        || other instanceof LearnedTerm term
            && family.equals(term.family)
            && Arrays.equals(coefficients, term.coefficients);
  }

  @Override
  public final int hashCode() {
    return 31 * family.hashCode() + Arrays.hashCode(coefficients);
  }

  @Override
  public final String toString() {
    return "learned " + family.key() + " " + Arrays.toString(coefficients);
  }
}
