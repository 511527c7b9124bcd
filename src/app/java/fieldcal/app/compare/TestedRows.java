package fieldcal.app.compare;

import fieldcal.app.statistics.Holm;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.distribution.NormalDistribution;

/** Rows of a table, each with the probability that it looks so different by chance, which pay together for their number. Not thread-safe. */
final class TestedRows {
  private final List<Row> rows = new ArrayList<>();
  private final List<Double> probabilities = new ArrayList<>();

  /** A row that is shown alone. */
  void untested(String id, String words, String unit, double a, double b) {
    add(new Row(id, words, unit, a, Double.NaN, b, Double.NaN, false), Double.NaN);
  }

  /** A row whose difference is normally distributed with the two standard errors; where one is not known, that of the other alone counts. */
  void tested(Row row) {
    double error = Math.hypot(known(row.realError()), known(row.simError()));
    double sigmas = Math.abs(row.real() - row.sim()) / error;
    add(row, error > 0 ? 2 * new NormalDistribution().cumulativeProbability(-sigmas) : Double.NaN);
  }

  private static double known(double error) {
    return Double.isFinite(error) ? error : 0;
  }

  /** A row with a test of its own. */
  void add(Row row, double p) {
    rows.add(row);
    probabilities.add(p);
  }

  /** All of them, in the order in which they came. */
  List<Row> judged() {
    double[] p = Holm.corrected(probabilities.stream().mapToDouble(v -> v).toArray());
    List<Row> judged = new ArrayList<>();
    for (int i = 0; i < p.length; i++) {
      judged.add(rows.get(i).judged(p[i] < FieldComparison.ALPHA));
    }
    return judged;
  }
}
