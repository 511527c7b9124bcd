package fieldcal.movement;

/**
 * How round one kind of corner is in the paths of a team, since no robot's acceleration begins or ends at once. Jerk limits, motors that lag, and controllers that creep up to their target all spread the change of the acceleration over
 * some time.
 *
 * <p>Whatever the shape of that spreading, if its variance is σ², the path beyond the corner is shifted by κ·Δa, κ = σ²/2, against that of a sharp corner (the acceleration convolved with a symmetric kernel, to second order). A fit with
 * sharp corners takes this for a smaller acceleration: 2 % of it where 80 ms of jerk limit begin and end a manoeuvre of 0.4 s. So κ is fitted at each corner, about the team's mean with the team's scatter, which are learnt from all
 * manoeuvres; that costs little precision.
 *
 * <p>A running mean in constant memory. For one thread.
 */
final class Rounding {
  /** What is assumed before anything is learnt, s²: an acceleration that changes evenly within 35 ms … */
  private static final double USUAL = 5e-5;

  /** … or within up to some 80 ms. */
  private static final double USUAL_SCATTER = 2e-4;

  /** Least scatter of corners of one kind, s²: a measured scatter below that of changes within 0 to 60 ms is due to chance. */
  private static final double LEAST_SCATTER = 1.5e-4;

  /** A corner further from the mean, in standard deviations, counts as one there (Huber 1964): pieces that were cut wrongly show any rounding, mostly too large ones. */
  private static final double CLIPPED = 1.5;

  /** Fewest corners whose mean is used. */
  private static final int FEWEST = 30;

  /** Narrower corners are taken to be so wide, s: a frame and a half. */
  private static final double NARROWEST = 0.02;

  private double weights;
  private double sum;
  private double squares;
  private double errors;
  private long samples;

  /** Mean κ, s². */
  double mean() {
    return samples < FEWEST ? USUAL : Math.max(0, sum / weights);
  }

  /** Scatter of κ from corner to corner, s². */
  double scatter() {
    if (samples < FEWEST) {
      return USUAL_SCATTER;
    }
    double mean = sum / weights;
    double variance = squares / weights - mean * mean - errors / weights;
    return Math.sqrt(Math.max(LEAST_SCATTER * LEAST_SCATTER, variance));
  }

  /** Time in which the acceleration changes evenly from one value to the other, s: a box of that width has the variance 2κ. */
  double width() {
    return Math.max(NARROWEST, Math.sqrt(24 * mean()));
  }

  /** Learns from a corner: κ as its detections alone determine it, s², and its variance, s⁴. */
  void add(double rounding, double variance) {
    double expected = variance + USUAL_SCATTER * USUAL_SCATTER;
    double most = CLIPPED * Math.sqrt(expected);
    double now = mean();
    double r = Math.max(now - most, Math.min(now + most, rounding));
    double weight = 1 / expected;
    weights += weight;
    sum += weight * r;
    squares += weight * r * r;
    errors += weight * variance;
    samples++;
  }
}
