package fieldcal.calibration;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

/**
 * One parameter as one kick determines it, and whether it is used.
 *
 * @param kickId running number of the kick
 * @param parameter name as in the model's record
 * @param value in the parameter's unit
 * @param standardError of the value, in the same unit
 * @param dropped why it is not averaged; empty when it is
 */
public record Sample(
    int kickId, String parameter, double value, double standardError, Optional<String> dropped) {

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when the parameter or the reason is null
   */
  public Sample {
    Objects.requireNonNull(parameter, "parameter");
    Objects.requireNonNull(dropped, "dropped");
  }

  /**
   * Whether it was dropped by the 2σ rule and not with its whole kick.
   *
   * @return true when its value is the reason
   */
  public boolean leftForItsValue() {
    return dropped.isPresent() && dropped.get().startsWith(fieldName() + " ");
  }

  /** The parameter's name in the league's message, for people: {@code acc_slide}. */
  String fieldName() {
    return parameter.replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
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
   * The same sample, not used.
   *
   * @param reason for people
   * @return the changed copy
   */
  public Sample drop(String reason) {
    return new Sample(kickId, parameter, value, standardError, Optional.of(reason));
  }
}
