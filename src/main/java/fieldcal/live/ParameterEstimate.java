package fieldcal.live;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What is known of one parameter of the ball.
 *
 * @param parameter which
 * @param median of the newest samples, in the parameter's unit; NaN without any; an estimate only when {@link #enough}
 * @param lowerQuartile a quarter of the samples lies below, in the parameter's unit; NaN without any
 * @param upperQuartile a quarter of the samples lies above, in the parameter's unit; NaN without any
 * @param samples how many count
 * @param maybeSpun whether most of them are of kicks after dribbling, with too few others to find out whether their balls spun; then a warning begins only where they are larger than published, which backspin does not explain
 * @param published the value it is compared with, in the parameter's unit; empty when none is known
 * @param warning whether a warning is active
 * @param history medians after earlier kicks, oldest first; thinned out when there are many
 */
public record ParameterEstimate(
    BallParameter parameter,
    double median,
    double lowerQuartile,
    double upperQuartile,
    int samples,
    boolean maybeSpun,
    Optional<Double> published,
    boolean warning,
    List<MedianPoint> history) {

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws NullPointerException when the parameter, the published value or the history is null
   */
  public ParameterEstimate {
    Objects.requireNonNull(parameter, "parameter");
    Objects.requireNonNull(published, "published");
    history = List.copyOf(history);
  }

  /**
   * Whether the median is an estimate.
   *
   * @return true from {@link SampleTree#ENOUGH} samples on; with fewer it may be shown but must not be used
   */
  public boolean enough() {
    return samples >= SampleTree.ENOUGH;
  }

  /**
   * How far the median is from the published value.
   *
   * @return median/published − 1 (–), so 0.2 is 20 % more; positive when the median has the larger magnitude; NaN when one of them is not known
   */
  public double deviation() {
    return published.map(p -> median / p - 1).orElse(Double.NaN);
  }
}
