package fieldcal.archive.venue;

import java.util.List;
import java.util.Map;

/**
 * A stretch of matches at one venue, on one carpet with one kind of ball.
 *
 * @param venue its name
 * @param name of the venue, and a running number
 * @param matches on it, by their start
 * @param parameters pooled, by name
 */
public record Carpet(
    String venue, String name, List<MatchFacts> matches, Map<String, Pooled> parameters) {

  /** Copies the list. {@inheritDoc} */
  public Carpet {
    matches = List.copyOf(matches);
  }

  /**
   * A parameter over the matches on a carpet.
   *
   * @param value weighted mean
   * @param error its standard error, scatter between matches included
   * @param scatter standard deviation between matches beyond their errors
   * @param n matches that determine it
   * @param drift slope over time, per day; NaN with fewer than four matches
   * @param driftError its standard error
   * @param published median of what vision published; NaN without
   */
  public record Pooled(
      double value,
      double error,
      double scatter,
      int n,
      double drift,
      double driftError,
      double published) {}
}
