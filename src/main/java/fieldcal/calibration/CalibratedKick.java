package fieldcal.calibration;

import fieldcal.fit.KickFit;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * One kick in a calibration.
 *
 * @param fit its own fit
 * @param samples its value of each parameter that it determines, used or not
 * @param distrusted why its fit is not believed as a whole: it failed, fits far worse than the others, has too many outliers, or was dropped by hand; empty
 *     when it is, even if none of its samples is averaged
 */
public record CalibratedKick(KickFit fit, List<Sample> samples, Optional<String> distrusted) {

  /**
   * Copies the samples. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public CalibratedKick {
    Objects.requireNonNull(fit, "fit");
    samples = List.copyOf(samples);
    Objects.requireNonNull(distrusted, "distrusted");
  }

  /**
   * Whether its detections are those of a ball that moved freely, as far as the calibration can see. Such a kick enters the joint fit and what
   * comes after it, also when the 2σ rule excludes some of its values: a kick that departs from the average is what a diagnosis is about.
   *
   * @return true when nothing speaks against the kick as a whole
   */
  public boolean trusted() {
    return distrusted.isEmpty();
  }

  /**
   * Whether any of its samples is averaged.
   *
   * @return true when the kick is used for the model
   */
  public boolean selected() {
    return rejected().isEmpty();
  }

  /**
   * Why none of its samples is averaged.
   *
   * @return the reason for people; empty when at least one is
   */
  public Optional<String> rejected() {
    if (distrusted.isPresent()) {
      return distrusted;
    }
    List<String> averaged = Selection.averaged(fit.kind());
    List<Sample> own = samples.stream().filter(s -> averaged.contains(s.parameter())).toList();
    if (own.isEmpty()) {
      return Optional.of("determines no parameter");
    }
    boolean any = own.stream().anyMatch(s -> s.dropped().isEmpty());
    return any ? Optional.empty() : own.get(0).dropped();
  }
}
