package fieldcal.vision;

import java.util.EnumMap;
import java.util.Map;

/** How often each {@link DecodingProblem} occurred. Not thread-safe. */
public final class DecodingCounts {
  private final long[] counts = new long[DecodingProblem.values().length];
  private long total;

  /** Starts at zero. */
  public DecodingCounts() {}

  /**
   * Counts one occurrence.
   *
   * @param problem what happened
   */
  void add(DecodingProblem problem) {
    counts[problem.ordinal()]++;
    total++;
  }

  /**
   * How often one problem occurred.
   *
   * @param problem the problem
   * @return its count
   */
  public long of(DecodingProblem problem) {
    return counts[problem.ordinal()];
  }

  /**
   * How often anything occurred.
   *
   * @return the sum of all counts
   */
  public long total() {
    return total;
  }

  /**
   * The problems that occurred.
   *
   * @return a copy of the counts that are not zero
   */
  public Map<DecodingProblem, Long> asMap() {
    Map<DecodingProblem, Long> map = new EnumMap<>(DecodingProblem.class);
    for (DecodingProblem problem : DecodingProblem.values()) {
      if (of(problem) > 0) {
        map.put(problem, of(problem));
      }
    }
    return map;
  }
}
