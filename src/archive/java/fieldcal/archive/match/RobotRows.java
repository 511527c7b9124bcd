package fieldcal.archive.match;

import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.LimitEstimator;
import fieldcal.movement.MovementCells;
import fieldcal.movement.SpeedCap;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;

/** The rows of the tables robots and limits_histograms. */
final class RobotRows {
  private final String log;
  private final MatchData match;

  RobotRows(String log, MatchData match) {
    this.log = log;
    this.match = match;
  }

  List<Row> robots() {
    List<Row> rows = new ArrayList<>();
    for (Team team : Team.values()) {
      TeamLimits limits = LimitEstimator.estimate(team, match.movement().statistics().of(team));
      rows.add(row(team, "velocity_max", limits.velocity()));
      rows.add(row(team, "acceleration_max", limits.acceleration()));
      rows.add(row(team, "braking_max", limits.braking()));
      rows.add(row(team, "league_velocity_max", limits.leagueVelocity()));
      rows.add(row(team, "league_acceleration_max", limits.leagueAcceleration()));
      rows.add(row(team, "league_braking_max", limits.leagueBraking()));
      for (LimitDeviation effect : limits.deviations()) {
        rows.add(
            row(team)
                .set("quantity", effect.effect().id())
                .set("value", effect.coefficient())
                .set("standard_error", effect.standardError())
                .set("samples", limits.manoeuvres())
                .set("note", "seen in " + effect.seenIn()));
      }
      for (SpeedCap cap : limits.speedCaps()) {
        rows.add(
            row(team)
                .set("robot", cap.robot())
                .set("quantity", "speed_cap")
                .set("value", cap.speed())
                .set("standard_error", cap.standardError())
                .set("samples", cap.samples()));
      }
    }
    return rows;
  }

  private Row row(Team team) {
    return Tables.ROBOTS
        .row()
        .set("log", log)
        .set("colour", team.label())
        .set("team", match.teams().get(team));
  }

  private Row row(Team team, String quantity, LimitEstimate estimate) {
    return row(team)
        .set("quantity", quantity)
        .set("value", estimate.value())
        .set("standard_error", estimate.standardError())
        .set("samples", estimate.samples())
        .set("reached", estimate.known() ? estimate.reached() : null)
        .set("note", estimate.note().isEmpty() ? null : estimate.note());
  }

  List<Row> histograms() {
    List<Row> rows = new ArrayList<>();
    MovementCells.of(
        match.movement().statistics(),
        cell ->
            rows.add(
                Tables.LIMITS_HISTOGRAMS
                    .row()
                    .set("log", log)
                    .set("colour", cell.team().map(Team::label))
                    .set("team", cell.team().map(team -> match.teams().get(team)))
                    .set("histogram", cell.histogram())
                    .set("robot", cell.robot())
                    .set("cell", cell.number())
                    .set("x", cell.x())
                    .set("y", cell.y())
                    .set("count", cell.count())));
    return rows;
  }
}
