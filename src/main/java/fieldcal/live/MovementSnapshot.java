package fieldcal.live;

import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Map;

/**
 * What is known of how the robots move.
 *
 * @param limits newest estimate of each team; a team is missing before its first
 * @param beforeBreak last estimate before the last break, when counting began again; empty before the first
 * @param countingSince when counting began, Unix time, s; NaN before the first frame
 * @param estimatedAt end of the data behind the newest estimate, Unix time, s; NaN without one
 * @param breaks how often counting began again
 * @param counted number of detections since then while movements counted
 * @param refused number of detections since then that cannot have been the robot they name
 * @param warnings limits that are not as configured, see {@link LiveMonitor#configured}
 * @param noiseMm noise of one coordinate of a driving robot's detections, mm; NaN when not measured yet
 */
public record MovementSnapshot(
    Map<Team, TeamLimits> limits,
    Map<Team, TeamLimits> beforeBreak,
    double countingSince,
    double estimatedAt,
    int breaks,
    long counted,
    long refused,
    List<LimitWarning> warnings,
    double noiseMm) {

  /**
   * Copies the collections. {@inheritDoc}
   *
   * @throws NullPointerException when a collection or an element is null
   */
  public MovementSnapshot {
    limits = Map.copyOf(limits);
    beforeBreak = Map.copyOf(beforeBreak);
    warnings = List.copyOf(warnings);
  }
}
