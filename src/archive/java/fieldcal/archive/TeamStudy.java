package fieldcal.archive;

import fieldcal.archive.match.TeamQuantity;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.movement.Grid;
import fieldcal.movement.LimitEstimator;
import fieldcal.movement.MovementCells;
import fieldcal.movement.MovementStatistics;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * How a team's robots moved in a tournament.
 *
 * @param matches of the team
 * @param quantities what was estimated
 * @param ownFrame accelerations in the robot's own frame
 * @param againstSpeed change of speed against speed
 * @param standing deviations of standing robots, of both teams in these matches
 * @param standingNoise m; NaN when none stood
 * @param manoeuvres that were fitted
 */
record TeamStudy(
    TeamMatches matches,
    List<TeamQuantity> quantities,
    Grid.Occupied ownFrame,
    Grid.Occupied againstSpeed,
    Grid.Occupied standing,
    double standingNoise,
    long manoeuvres)
    implements Serializable {

  /** Adds the histograms of all matches, whichever colour the team had, and estimates. */
  static TeamStudy of(TeamMatches matches, ArchiveFolder folder) throws IOException {
    MovementStatistics all = new MovementStatistics();
    for (LogFile log : matches.logs()) {
      for (Row row : folder.rows(Tables.LIMITS_HISTOGRAMS, log)) {
        String team = row.text("team");
        boolean shared = row.text("colour") == null;
        if (shared || matches.team().equals(team)) {
          add(all, row, shared);
        }
      }
    }
    TeamLimits limits = LimitEstimator.estimate(Team.YELLOW, all.of(Team.YELLOW));
    return new TeamStudy(
        matches,
        TeamQuantity.of(limits),
        all.of(Team.YELLOW).ownFrame().occupied(),
        all.of(Team.YELLOW).againstSpeed().occupied(),
        all.standing().occupied(),
        all.standingNoiseMm() / 1000,
        limits.manoeuvres());
  }

  private static void add(MovementStatistics all, Row row, boolean shared) throws IOException {
    MovementCells.Cell cell =
        new MovementCells.Cell(
            shared ? Optional.empty() : Optional.of(Team.YELLOW),
            row.text("histogram"),
            Optional.ofNullable((Integer) row.get("robot")),
            (int) row.whole("cell"),
            Double.NaN,
            Double.NaN,
            row.whole("count"));
    if (!MovementCells.add(all, cell)) {
      throw new IOException("limits_histograms: there is no such cell: " + cell);
    }
  }

  List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    for (TeamQuantity quantity : quantities) {
      rows.add(
          quantity
              .fill(Tables.TEAMS.row())
              .set("tournament", matches.tournament())
              .set("team", matches.team())
              .set("matches", matches.logs().size()));
    }
    return rows;
  }
}
