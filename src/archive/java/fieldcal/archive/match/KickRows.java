package fieldcal.archive.match;

import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.ball.BallState;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.calibration.CalibratedKick;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The rows of the table kicks. */
final class KickRows {
  /** How far ahead the published model is tried: as long as a pass over half a field takes, s. */
  private static final double AHEAD = 1;

  private final String log;
  private final MatchData match;

  KickRows(String log, MatchData match) {
    this.log = log;
    this.match = match;
  }

  List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    match.calibration().kicks().forEach(kick -> rows.add(row(kick)));
    return rows;
  }

  private Row row(CalibratedKick calibrated) {
    KickFit fit = calibrated.fit();
    Kick kick = fit.kick();
    Optional<RobotId> robot = kick.robot();
    boolean fitted = fit.failure().isEmpty();
    Row row =
        Tables.KICKS
            .row()
            .set("log", log)
            .set("kick", kick.id())
            .set("time", micros(fitted ? fit.estimate("t0").value() : kick.time()))
            .set("team", robot.map(r -> match.teams().get(r.team())))
            .set("colour", robot.map(r -> r.team().label()))
            .set("robot", robot.map(RobotId::number))
            .set("x", fitted ? fit.estimate("x").value() : kick.x())
            .set("y", fitted ? fit.estimate("y").value() : kick.y())
            .set("end", kick.end().id())
            .set("duration", kick.endTime() - kick.time())
            .set("from_rest", kick.fromRest())
            .set("may_spin", kick.afterDribbling())
            .set(
                "cameras",
                Arrays.stream(kick.observations().cameras()).distinct().sorted().boxed().toList())
            .set("observations", kick.observations().size())
            .set("used", fit.statistics().used())
            .set("rms_mm", fit.rmsMm())
            .set("trusted", calibrated.trusted())
            .set("selected", calibrated.selected())
            .set("not_used_because", calibrated.rejected());
    if (fitted) {
      row.set("kind", fit.kind().id());
      velocity(row, fit);
      for (Estimate e : fit.modelEstimates()) {
        String name = column(e.name());
        if (e.usable() && hasColumn(name)) {
          row.set(name, e.value()).set(name + "_error", e.standardError());
        }
      }
      row.set("published_error_1s", publishedError(fit, match.data().published().flat()));
    }
    return row;
  }

  private static boolean hasColumn(String name) {
    return Tables.KICKS.columns().stream().anyMatch(c -> c.name().equals(name));
  }

  /** As in the league's message: acc_slide for accSlide. */
  static String column(String parameter) {
    return parameter.replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
  }

  private long micros(double time) {
    return Math.floorDiv(match.data().epoch().unixNanosOf(time), 1000);
  }

  private static void velocity(Row row, KickFit fit) {
    List<String> names = fit.estimates().stream().map(Estimate::name).toList();
    List<String> axes =
        fit.kind() == KickKind.CHIP ? List.of("vx", "vy", "vz") : List.of("vx", "vy");
    double[] v = axes.stream().mapToDouble(axis -> fit.estimate(axis).value()).toArray();
    double ground = Math.hypot(v[0], v[1]);
    double up = v.length > 2 ? v[2] : 0;
    double speed = Math.hypot(ground, up);
    double variance = 0;
    for (int i = 0; i < v.length; i++) {
      for (int j = 0; j < v.length; j++) {
        variance +=
            v[i] * v[j] * fit.covariance(names.indexOf(axes.get(i)), names.indexOf(axes.get(j)));
      }
    }
    row.set("speed", speed)
        .set("speed_error", Math.sqrt(variance) / speed)
        .set("direction", Math.atan2(v[1], v[0]))
        .set("elevation", Math.atan2(up, ground));
  }

  /** NaN where there is nothing to compare. */
  static double publishedError(KickFit fit, Optional<FlatModel> published) {
    double start = fit.kind() == KickKind.FLAT ? fit.estimate("t0").value() : Double.NaN;
    if (published.isEmpty() || !(fit.kick().endTime() >= start + AHEAD)) {
      return Double.NaN;
    }
    FlatTrajectory predicted =
        FlatTrajectory.fromKick(
            published.get(),
            start,
            fit.estimate("x").value(),
            fit.estimate("y").value(),
            fit.estimate("vx").value(),
            fit.estimate("vy").value());
    BallState expected = predicted.stateAt(start + AHEAD);
    BallState was = fit.trajectory().stateAt(start + AHEAD);
    return Math.hypot(expected.x() - was.x(), expected.y() - was.y());
  }

  /** Root mean square over the kicks that are trusted; NaN without any. */
  static double publishedErrorOfAll(MatchData match) {
    return Math.sqrt(
        match.calibration().trusted().stream()
            .mapToDouble(fit -> publishedError(fit, match.data().published().flat()))
            .filter(Double::isFinite)
            .map(error -> error * error)
            .average()
            .orElse(Double.NaN));
  }
}
