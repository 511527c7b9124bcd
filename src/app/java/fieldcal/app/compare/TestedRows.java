package fieldcal.app.compare;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.distribution.TDistribution;

/** Rows of a table, each with the probability that it looks so different by chance. Not thread-safe. */
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

  /** A row whose standard errors are known from so many samples themselves: by the t distribution, with the degrees of freedom of Welch (1947). */
  void sampled(Row row, int first, int second) {
    double a = row.realError() * row.realError();
    double b = row.simError() * row.simError();
    double error = Math.sqrt(a + b);
    if (!(error > 0)) {
      add(row, Double.NaN);
      return;
    }
    double freedom = (a + b) * (a + b) / (a * a / (first - 1) + b * b / (second - 1));
    double t = Math.abs(row.real() - row.sim()) / error;
    add(row, 2 * new TDistribution(null, freedom).cumulativeProbability(-t));
  }

  private static double known(double error) {
    return Double.isFinite(error) ? error : 0;
  }

  /** A row with a test of its own. */
  void add(Row row, double p) {
    rows.add(row);
    probabilities.add(p);
  }

  /** Probabilities of the rows, in the order in which they came; NaN for those that are shown alone. */
  double[] probabilities() {
    return probabilities.stream().mapToDouble(v -> v).toArray();
  }

  /** All rows, in the order in which they came, by their probabilities after correction for their number. */
  List<Row> judged(double[] corrected) {
    List<Row> judged = new ArrayList<>();
    for (int i = 0; i < corrected.length; i++) {
      judged.add(rows.get(i).judged(corrected[i] < FieldComparison.ALPHA));
    }
    return judged;
  }
}
