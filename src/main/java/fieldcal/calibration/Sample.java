package fieldcal.calibration;

import fieldcal.ball.Parameter;
import java.util.Objects;
import java.util.Optional;

/**
 * One parameter as one kick determines it, and whether it is used.
 *
 * @param kickId running number of the kick
 * @param parameter name as in the model's record
 * @param value in the parameter's unit
 * @param standardError of the value, in the same unit
 * @param dropped why it is not averaged, for people; empty when it is
 * @param exclusion what is not averaged; empty when it is
 */
public record Sample(
    int kickId,
    String parameter,
    double value,
    double standardError,
    Optional<String> dropped,
    Optional<Exclusion> exclusion) {

  /** What is not averaged. */
  public enum Exclusion {
    /** This value alone, by the 2σ rule. */
    VALUE,
    /** All values of its kick, because of its fit or by hand. */
    KICK
  }

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when the parameter, the reason or the exclusion is null
   * @throws IllegalArgumentException when there is a reason without an exclusion, or an exclusion without a reason
   */
  public Sample {
    Objects.requireNonNull(parameter, "parameter");
    Objects.requireNonNull(dropped, "dropped");
    Objects.requireNonNull(exclusion, "exclusion");
    if (dropped.isPresent() != exclusion.isPresent()) {
      throw new IllegalArgumentException("dropped: " + dropped + ", but excluded: " + exclusion);
    }
  }

  /**
   * A sample that is used, or dropped with its whole kick.
   *
   * @param kickId running number of the kick
   * @param parameter name as in the model's record
   * @param value in the parameter's unit
   * @param standardError of the value, in the same unit
   * @param dropped why its kick is not averaged; empty when it is
   */
  public Sample(
      int kickId, String parameter, double value, double standardError, Optional<String> dropped) {
    this(kickId, parameter, value, standardError, dropped, dropped.map(r -> Exclusion.KICK));
  }

  /**
   * Whether it was dropped by the 2σ rule and not with its whole kick.
   *
   * @return true when its value is the reason
   */
  public boolean leftForItsValue() {
    return exclusion.filter(e -> e == Exclusion.VALUE).isPresent();
  }

  /** The parameter's name in the league's message, for people: {@code acc_slide}. */
  String fieldName() {
    return Parameter.inFiles(parameter);
  }

  /**
   * The same sample, used.
   *
   * @return the changed copy
   */
  Sample taken() {
    return new Sample(kickId, parameter, value, standardError, Optional.empty());
  }

  /**
   * The same sample, not used, as all of its kick.
   *
   * @param reason for people
   * @return the changed copy
   */
  public Sample drop(String reason) {
    return new Sample(kickId, parameter, value, standardError, Optional.of(reason));
  }

  /** The same sample, not used by the 2σ rule. */
  Sample dropForItsValue(String reason) {
    return new Sample(
        kickId, parameter, value, standardError, Optional.of(reason), Optional.of(Exclusion.VALUE));
  }
}
