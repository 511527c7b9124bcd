package fieldcal.calibration;

import fieldcal.fit.KickFit;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * One kick in a calibration.
 *
 * @param fit its own fit
 * @param samples what it says of each parameter that it determines, used or dropped
 * @param rejected why the whole kick is not used; empty when at least one of its samples is
 */
public record CalibratedKick(KickFit fit, List<Sample> samples, Optional<String> rejected) {

  /** Copies the samples. {@inheritDoc} */
  public CalibratedKick {
    Objects.requireNonNull(fit, "fit");
    samples = List.copyOf(samples);
    Objects.requireNonNull(rejected, "rejected");
  }

  /**
   * Whether any of its samples is averaged.
   *
   * @return true when the kick is used
   */
  public boolean selected() {
    return rejected.isEmpty();
  }
}
