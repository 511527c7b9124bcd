package fieldcal.app.compare;

import fieldcal.app.calibrate.CommandFile.Command;
import fieldcal.ball.BallState;
import fieldcal.diagnosis.KickResiduals;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;

/** How the kickers of both sides follow their commands, where the commands are known. */
final class Kickers {
  /** Fewest commanded kicks. */
  private static final int FEWEST = 5;

  private Kickers() {}

  static void rows(Side real, Side sim, List<Row> rows) {
    double[][] a = deviations(real);
    double[][] b = deviations(sim);
    if (a[0].length < FEWEST || b[0].length < FEWEST) {
      return;
    }
    row("kick_gain", "measured over commanded kick speed", "", mean(a[0]), mean(b[0]), rows);
    row("kick_scatter", "scatter of that", "", deviation(a[0]), deviation(b[0]), rows);
    row("kick_aim", "kicks to the left of the command", "rad", mean(a[1]), mean(b[1]), rows);
    row("kick_aim_scatter", "scatter of that", "rad", deviation(a[1]), deviation(b[1]), rows);
  }

  private static double[] mean(double[] values) {
    return new double[] {
      StatUtils.mean(values), Math.sqrt(StatUtils.variance(values) / values.length)
    };
  }

  /** The standard error of a standard deviation of normal samples is it over √(2(n − 1)). */
  private static double[] deviation(double[] values) {
    double deviation = Math.sqrt(StatUtils.variance(values));
    return new double[] {deviation, deviation / Math.sqrt(2.0 * (values.length - 1))};
  }

  private static void row(
      String id, String words, String unit, double[] a, double[] b, List<Row> rows) {
    boolean differs = Math.abs(a[0] - b[0]) > 2.58 * Math.hypot(a[1], b[1]);
    rows.add(new Row(id, words, unit, a[0], a[1], b[0], b[1], differs));
  }

  /** Speed over command, and direction off it, rad. */
  private static double[][] deviations(Side side) {
    List<double[]> all = new ArrayList<>();
    for (KickResiduals kick : side.diagnosis().diagnosis().kicks()) {
      Optional<Command> command = side.diagnosis().calibration().command(kick.kick());
      if (command.isPresent() && command.get().speed() > 0) {
        BallState s = kick.after().stateAt(kick.after().kickTime());
        double speed = Math.sqrt(s.vx() * s.vx() + s.vy() * s.vy() + s.vz() * s.vz());
        double aside = Math.atan2(s.vy(), s.vx()) - command.get().direction();
        all.add(
            new double[] {speed / command.get().speed(), Math.IEEEremainder(aside, 2 * Math.PI)});
      }
    }
    return new double[][] {
      all.stream().mapToDouble(d -> d[0]).toArray(), all.stream().mapToDouble(d -> d[1]).toArray()
    };
  }
}
