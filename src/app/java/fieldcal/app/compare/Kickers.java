package fieldcal.app.compare;

import fieldcal.app.calibrate.CommandedKick;
import java.util.List;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.inference.TestUtils;

/** How the kickers of both sides follow their commands, where the commands are known. */
final class Kickers {
  /** Fewest commanded kicks. */
  private static final int FEWEST = 5;

  private Kickers() {}

  static void rows(Side real, Side sim, TestedRows rows) {
    double[][] a = deviations(real);
    double[][] b = deviations(sim);
    if (a[0].length < FEWEST || b[0].length < FEWEST) {
      return;
    }
    mean("kick_gain", "measured over commanded kick speed", "", a[0], b[0], rows);
    scatter("kick_scatter", "scatter of this ratio", "", a[0], b[0], rows);
    mean("kick_aim", "angle to the left of the command", "rad", a[1], b[1], rows);
    scatter("kick_aim_scatter", "scatter of this angle", "rad", a[1], b[1], rows);
  }

  /** By the t test of Welch. */
  private static void mean(
      String id, String words, String unit, double[] a, double[] b, TestedRows rows) {
    Row row =
        new Row(
            id,
            words,
            unit,
            StatUtils.mean(a),
            Math.sqrt(StatUtils.variance(a) / a.length),
            StatUtils.mean(b),
            Math.sqrt(StatUtils.variance(b) / b.length),
            false);
    rows.add(row, row.realError() + row.simError() > 0 ? TestUtils.tTest(a, b) : Double.NaN);
  }

  /** By the F test. The standard error of a standard deviation of normal samples is it over √(2(n − 1)). */
  private static void scatter(
      String id, String words, String unit, double[] a, double[] b, TestedRows rows) {
    double first = Math.sqrt(StatUtils.variance(a));
    double second = Math.sqrt(StatUtils.variance(b));
    Row row =
        new Row(
            id,
            words,
            unit,
            first,
            first / Math.sqrt(2.0 * (a.length - 1)),
            second,
            second / Math.sqrt(2.0 * (b.length - 1)),
            false);
    double below =
        new FDistribution(a.length - 1, b.length - 1)
            .cumulativeProbability(first * first / (second * second));
    rows.add(row, second > 0 ? 2 * Math.min(below, 1 - below) : Double.NaN);
  }

  /** Speed over command, and direction off it, rad. */
  private static double[][] deviations(Side side) {
    List<CommandedKick> all =
        CommandedKick.of(side.diagnosis().calibration(), side.diagnosis().diagnosis().kicks());
    return new double[][] {
      all.stream().mapToDouble(CommandedKick::gain).toArray(),
      all.stream().mapToDouble(CommandedKick::yaw).toArray()
    };
  }
}
