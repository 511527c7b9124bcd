package fieldcal.live;

import java.util.Arrays;
import java.util.List;

/**
 * Older and newer samples of a parameter as they would be, had all balls been equally fast.
 *
 * <p>A parameter that depends on the ball's speed (accRoll does on every carpet: a = a₀ + b·v²) scatters from kick to kick, and its median wanders with the mix of slow and fast kicks. The slope b is the median of the
 * slopes between all pairs within the older and within the newer samples (Theil and Sen), so that a step between the two does not move it and single wrong samples do not either.
 */
final class EqualSpeeds {
  /** Squared speeds of a pair must differ by this, m²/s²: with less, its slope shows nothing but noise. */
  private static final double APART = 1;

  /** With fewer such pairs the slope is not known: half of what six samples have. */
  private static final int FEWEST_PAIRS = 15;

  private final double[] values;
  private final double[] squares;
  private final int older;
  private double leverage;

  /** The first {@code older} samples are one part, the others the other; values are for a ball of the given squared speed, m²/s². */
  EqualSpeeds(List<BallSample> samples, int older, double usual) {
    this.older = older;
    values = samples.stream().mapToDouble(BallSample::value).toArray();
    squares = samples.stream().mapToDouble(s -> s.speed() * s.speed()).toArray();
    if (Double.isNaN(usual) || Arrays.stream(squares).anyMatch(Double::isNaN)) {
      return;
    }
    double[] slopes = slopes();
    if (slopes.length >= FEWEST_PAIRS) {
      double slope = median(slopes, 0, slopes.length);
      leverage = leverage();
      for (int i = 0; i < values.length; i++) {
        values[i] -= slope * (squares[i] - usual);
      }
    }
  }

  private double[] slopes() {
    double[] slopes = new double[values.length * values.length / 2];
    int n = 0;
    for (int i = 0; i < values.length; i++) {
      for (int j = i < older ? 0 : older; j < i; j++) {
        double apart = squares[i] - squares[j];
        if (Math.abs(apart) > APART) {
          slopes[n++] = (values[i] - values[j]) / apart;
        }
      }
    }
    return Arrays.copyOf(slopes, n);
  }

  /** Difference between the squared speeds of the two parts, over the root of the sum of their squared deviations. Times the scatter of the values it is the error of the step that comes from the slope. */
  private double leverage() {
    double first = median(squares, 0, older);
    double second = median(squares, older, squares.length);
    double spread = 0;
    for (int i = 0; i < squares.length; i++) {
      double d = squares[i] - (i < older ? first : second);
      spread += d * d;
    }
    return Math.abs(second - first) / Math.sqrt(spread);
  }

  double median() {
    return median(values, 0, values.length);
  }

  /** Standard error of the median of all, from their deviations from it. */
  double errorOfMedian() {
    double middle = median();
    double[] deviations = Arrays.stream(values).map(v -> Math.abs(v - middle)).toArray();
    return WarningRule.MEDIAN_ERROR * WarningRule.scatter(deviations) / Math.sqrt(values.length);
  }

  double medianOfOlder() {
    return median(values, 0, older);
  }

  double medianOfNewer() {
    return median(values, older, values.length);
  }

  /** Standard error of the difference of both medians, from all deviations from their own median. */
  double errorOfStep() {
    double first = medianOfOlder();
    double second = medianOfNewer();
    double[] deviations = new double[values.length];
    for (int i = 0; i < deviations.length; i++) {
      deviations[i] = Math.abs(values[i] - (i < older ? first : second));
    }
    double scatter = WarningRule.scatter(deviations);
    return Math.hypot(
        WarningRule.errorOfDifference(scatter, older, values.length - older),
        WarningRule.MEDIAN_ERROR * scatter * leverage);
  }

  private static double median(double[] all, int from, int to) {
    double[] part = Arrays.copyOfRange(all, from, to);
    Arrays.sort(part);
    return 0.5 * (part[(part.length - 1) / 2] + part[part.length / 2]);
  }
}
