package fieldcal.archive.match;

import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.calibration.CalibratedKick;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import java.util.ArrayList;
import java.util.List;

/** The rows of the table trackers. */
final class TrackerRows {
  private TrackerRows() {}

  static List<Row> of(String log, MatchData match) {
    List<TrackerAudit.KnownKick> kicks =
        match.calibration().kicks().stream().map(TrackerRows::known).toList();
    List<Row> rows = new ArrayList<>();
    for (TrackerWatch.Source source : match.trackers().sources()) {
      TrackerAudit audit = TrackerAudit.of(source, kicks);
      rows.add(
          Tables.TRACKERS
              .row()
              .set("log", log)
              .set("source", source.name())
              .set("uuid", source.uuid())
              .set("frames", (long) source.frames())
              .set("samples", audit.samples())
              .set("delay", audit.delay())
              .set("position_error", audit.positionError())
              .set("position_error_without_delay", audit.positionErrorWithoutDelay())
              .set("velocity_error", audit.velocityError())
              .set("kicks", audit.reported())
              .set("matched", audit.matched())
              .set("missed", audit.missed())
              .set("invented", audit.invented())
              .set("speed_bias", audit.speedBias())
              .set("speed_scatter", audit.speedScatter())
              .set("stops", audit.stops())
              .set("stop_position_error", audit.stopPositionError())
              .set("stop_time_error", audit.stopTimeError()));
    }
    return rows;
  }

  private static TrackerAudit.KnownKick known(CalibratedKick calibrated) {
    KickFit fit = calibrated.fit();
    Kick kick = fit.kick();
    if (!calibrated.trusted() || fit.failure().isPresent()) {
      return new TrackerAudit.KnownKick(
          kick.time(), kick.endTime(), kick.x(), kick.y(), Double.NaN, false, false, null);
    }
    double up =
        fit.estimates().stream().anyMatch(e -> e.name().equals("vz"))
            ? fit.estimate("vz").value()
            : 0;
    return new TrackerAudit.KnownKick(
        fit.estimate("t0").value(),
        kick.endTime(),
        fit.estimate("x").value(),
        fit.estimate("y").value(),
        Math.hypot(Math.hypot(fit.estimate("vx").value(), fit.estimate("vy").value()), up),
        true,
        kick.end() == KickEnd.STOPPED,
        fit.trajectory());
  }
}
