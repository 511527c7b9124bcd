package fieldcal.app.statistics;

import java.util.Collections;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * One number of a recording, as samples of kicks or of stretches of time.
 *
 * @param id for files: a name, and the camera or the range after a dot
 * @param words what it is, in words, with the camera or the range
 * @param unit its unit; empty when it has none
 * @param comparison how two recordings are compared in it
 * @param samples by kick or stretch
 */
public record Statistic(
    String id, String words, String unit, How comparison, Map<String, Double> samples) {

  /** How two recordings are compared. */
  public enum How {
    /** The same kick in both, and the median of the differences: Wilcoxon's signed-rank test. */
    PAIRED,
    /** All samples of one against all of the other: the rank-sum test of Mann and Whitney. */
    LEVEL,
    /** How far samples lie from their median: the rank-sum test of these distances (Levene's idea, on ranks). */
    SCATTER
  }

  /** Leaves samples out that are not finite, and copies. {@inheritDoc} */
  public Statistic {
    Objects.requireNonNull(id, "id");
    Objects.requireNonNull(words, "words");
    Objects.requireNonNull(unit, "unit");
    Objects.requireNonNull(comparison, "comparison");
    Map<String, Double> finite = new TreeMap<>();
    samples.forEach(
        (key, value) -> {
          if (Double.isFinite(value)) {
            finite.put(key, value);
          }
        });
    samples = Collections.unmodifiableMap(finite);
  }

  /**
   * The samples.
   *
   * @return a new array, in the order of their keys
   */
  public double[] values() {
    return samples.values().stream().mapToDouble(v -> v).toArray();
  }
}
