package fieldcal.archive.match;

import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.movement.LimitEstimator;
import fieldcal.movement.MovementCells;
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
      TeamQuantity.of(limits).forEach(quantity -> rows.add(quantity.fill(row(team))));
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
