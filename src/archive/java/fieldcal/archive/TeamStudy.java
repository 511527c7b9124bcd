package fieldcal.archive;

import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.movement.Grid;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.LimitEstimator;
import fieldcal.movement.MovementCells;
import fieldcal.movement.MovementStatistics;
import fieldcal.movement.SpeedCap;
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
    List<Quantity> quantities,
    Grid.Occupied ownFrame,
    Grid.Occupied againstSpeed,
    Grid.Occupied standing,
    double standingNoise,
    long manoeuvres)
    implements Serializable {

  /** A row of the table teams; robot −1 stands for all of them, reached is null where it has no meaning. */
  record Quantity(
      String name,
      int robot,
      double value,
      double error,
      long samples,
      Boolean reached,
      String note)
      implements Serializable {}

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
        quantities(limits),
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

  private static List<Quantity> quantities(TeamLimits limits) {
    List<Quantity> all = new ArrayList<>();
    all.add(quantity("velocity_max", limits.velocity()));
    all.add(quantity("acceleration_max", limits.acceleration()));
    all.add(quantity("braking_max", limits.braking()));
    all.add(quantity("league_velocity_max", limits.leagueVelocity()));
    all.add(quantity("league_acceleration_max", limits.leagueAcceleration()));
    all.add(quantity("league_braking_max", limits.leagueBraking()));
    for (LimitDeviation effect : limits.deviations()) {
      String seen = "seen in " + effect.seenIn();
      all.add(
          new Quantity(
              effect.effect().id(),
              -1,
              effect.coefficient(),
              effect.standardError(),
              limits.manoeuvres(),
              null,
              seen));
    }
    for (SpeedCap cap : limits.speedCaps()) {
      all.add(
          new Quantity(
              "speed_cap",
              cap.robot(),
              cap.speed(),
              cap.standardError(),
              cap.samples(),
              null,
              null));
    }
    return all;
  }

  private static Quantity quantity(String name, LimitEstimate e) {
    return new Quantity(
        name,
        -1,
        e.value(),
        e.standardError(),
        e.samples(),
        e.known() ? e.reached() : null,
        e.note().isEmpty() ? null : e.note());
  }

  List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    for (Quantity q : quantities) {
      rows.add(
          Tables.TEAMS
              .row()
              .set("tournament", matches.tournament())
              .set("team", matches.team())
              .set("robot", q.robot() < 0 ? null : q.robot())
              .set("quantity", q.name())
              .set("value", q.value())
              .set("standard_error", q.error())
              .set("samples", q.samples())
              .set("reached", q.reached())
              .set("note", q.note())
              .set("matches", matches.logs().size()));
    }
    return rows;
  }
}
