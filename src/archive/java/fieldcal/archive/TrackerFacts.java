package fieldcal.archive;

import java.io.Serializable;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * What a tracker says of the ball against the fits of the kicks, in one match or, pooled, in several: the columns of the table {@code trackers}. What nothing is known of is NaN.
 *
 * @param source what the tracker calls itself; may be empty
 * @param logs in which it sent; one that was started again in a match has several rows of one log
 * @param samples frames with a ball during kicks whose fit is trusted
 * @param delay s
 * @param position root mean square error with the delay taken out, m
 * @param velocity root mean square error, m/s
 * @param kicks that it reports
 * @param matched of the known kicks
 * @param missed of the known kicks
 * @param invented of the reported kicks
 * @param speedBias m/s
 * @param speedScatter m/s
 * @param stops resting places that were compared
 * @param stopPosition root mean square error, m
 * @param stopTime root mean square error, s
 */
record TrackerFacts(
    String source,
    Set<String> logs,
    long samples,
    double delay,
    double position,
    double velocity,
    long kicks,
    long matched,
    long missed,
    long invented,
    double speedBias,
    double speedScatter,
    long stops,
    double stopPosition,
    double stopTime)
    implements Serializable {

  /** Copies the set. */
  TrackerFacts {
    logs = new HashSet<>(logs);
  }

  /** Matches in which it sent. */
  int matches() {
    return logs.size();
  }

  /** A weighted sum of what is known. */
  private static final class Sum {
    private double weights;
    private double sum;

    void add(double weight, double value) {
      if (weight > 0 && Double.isFinite(value)) {
        weights += weight;
        sum += weight * value;
      }
    }

    double mean() {
      return weights > 0 ? sum / weights : Double.NaN;
    }
  }

  /** The same tracker in several matches: counts are added, means and mean squares weighted with what they rest on. */
  static TrackerFacts pooled(List<TrackerFacts> all) {
    Sum delay = new Sum();
    Sum position = new Sum();
    Sum velocity = new Sum();
    Sum bias = new Sum();
    Sum squares = new Sum();
    Sum place = new Sum();
    Sum time = new Sum();
    for (TrackerFacts t : all) {
      delay.add(t.samples, t.delay);
      position.add(t.samples, t.position * t.position);
      velocity.add(t.samples, t.velocity * t.velocity);
      bias.add(t.matched, t.speedBias);
      double within = t.matched < 2 ? 0 : (t.matched - 1) * t.speedScatter * t.speedScatter;
      squares.add(t.matched, within / t.matched + t.speedBias * t.speedBias);
      place.add(t.stops, t.stopPosition * t.stopPosition);
      time.add(t.stops, t.stopTime * t.stopTime);
    }
    long matched = all.stream().mapToLong(TrackerFacts::matched).sum();
    double variance = Math.max(0, squares.mean() - bias.mean() * bias.mean());
    return new TrackerFacts(
        all.get(0).source,
        all.stream().flatMap(t -> t.logs.stream()).collect(Collectors.toSet()),
        all.stream().mapToLong(TrackerFacts::samples).sum(),
        delay.mean(),
        Math.sqrt(position.mean()),
        Math.sqrt(velocity.mean()),
        all.stream().mapToLong(TrackerFacts::kicks).sum(),
        matched,
        all.stream().mapToLong(TrackerFacts::missed).sum(),
        all.stream().mapToLong(TrackerFacts::invented).sum(),
        bias.mean(),
        matched < 2 ? Double.NaN : Math.sqrt(variance * matched / (matched - 1)),
        all.stream().mapToLong(TrackerFacts::stops).sum(),
        Math.sqrt(place.mean()),
        Math.sqrt(time.mean()));
  }
}
