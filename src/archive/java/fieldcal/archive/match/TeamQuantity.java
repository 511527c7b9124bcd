package fieldcal.archive.match;

import fieldcal.archive.table.Row;
import fieldcal.movement.Envelope;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.SpeedCap;
import fieldcal.movement.TeamLimits;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What was estimated of a team or of one of its robots: a row of the tables robots and teams.
 *
 * @param name of the quantity
 * @param robot number; null for all robots together
 * @param direction of a limit by direction, rad from the front to the left; null for others
 * @param value SI; NaN when undetermined
 * @param error standard error; NaN when unknown
 * @param samples observations that it rests on
 * @param reached whether the robots were seen at it; null where that has no meaning
 * @param note in words; null without
 */
public record TeamQuantity(
    String name,
    Integer robot,
    Double direction,
    double value,
    double error,
    long samples,
    Boolean reached,
    String note)
    implements Serializable {

  /**
   * All quantities of a team.
   *
   * @param limits what was estimated
   * @return always in the same order
   */
  public static List<TeamQuantity> of(TeamLimits limits) {
    List<TeamQuantity> all = new ArrayList<>();
    all.add(limit("velocity_max", limits.velocity()));
    all.add(limit("acceleration_max", limits.acceleration()));
    all.add(limit("braking_max", limits.braking()));
    all.add(limit("angular_velocity_max", limits.turning().velocity()));
    all.add(limit("angular_acceleration_max", limits.turning().acceleration()));
    all.add(limit("angular_braking_max", limits.turning().braking()));
    all.add(limit("league_velocity_max", limits.leagueVelocity()));
    all.add(limit("league_acceleration_max", limits.leagueAcceleration()));
    all.add(limit("league_braking_max", limits.leagueBraking()));
    for (LimitDeviation effect : limits.deviations()) {
      all.add(
          new TeamQuantity(
              effect.effect().id(),
              null,
              null,
              effect.coefficient(),
              effect.standardError(),
              limits.manoeuvres(),
              null,
              "seen in " + effect.seenIn()));
    }
    for (Envelope envelope : limits.envelopes()) {
      String note = envelope.shaped() ? "one limit for all directions does not describe it" : null;
      for (Envelope.Point point : envelope.points()) {
        all.add(
            new TeamQuantity(
                envelope.seenIn() + "_by_direction",
                null,
                point.angle(),
                point.value(),
                point.standardError(),
                Math.round(point.manoeuvres()),
                null,
                note));
      }
    }
    for (SpeedCap cap : limits.speedCaps()) {
      all.add(
          new TeamQuantity(
              "speed_cap",
              cap.robot(),
              null,
              cap.speed(),
              cap.standardError(),
              cap.samples(),
              null,
              null));
    }
    for (RobotDifference robot : limits.robots()) {
      all.add(
          new TeamQuantity(
              "robot_" + robot.quantity(),
              robot.robot(),
              null,
              robot.value(),
              robot.standardError(),
              robot.manoeuvres(),
              null,
              String.format(Locale.ROOT, "%.0f %% of its team mates'", 100 * robot.ratio())));
    }
    return all;
  }

  private static TeamQuantity limit(String name, LimitEstimate e) {
    return new TeamQuantity(
        name,
        null,
        null,
        e.value(),
        e.standardError(),
        e.samples(),
        e.known() ? e.reached() : null,
        e.note().isEmpty() ? null : e.note());
  }

  /**
   * Fills its columns of a row.
   *
   * @param row of the tables robots or teams
   * @return the same row
   */
  public Row fill(Row row) {
    return row.set("robot", robot)
        .set("quantity", name)
        .set("direction", direction)
        .set("value", value)
        .set("standard_error", error)
        .set("samples", samples)
        .set("reached", reached)
        .set("note", note);
  }
}
