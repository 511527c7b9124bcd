package fieldcal.app.limits;

import fieldcal.app.recording.DataProblem;
import fieldcal.movement.LimitEstimator;
import fieldcal.movement.MovementStatistics;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * What was found in recordings.
 *
 * @param logs the recordings that were read, in the order they were named
 * @param names of the teams, as the referee says; of the first recording that tells
 * @param recordedUnix when the earliest begins, Unix time in s; NaN when none has a message
 * @param duration of all together, s
 * @param statistics all that was counted
 * @param noiseMm noise of one coordinate of a moving robot's detection, mm, the median of the recordings; NaN when none was measured
 * @param yellow limits
 * @param blue limits
 * @param problems what was wrong with the data
 */
public record LimitsOutcome(
    List<Path> logs,
    Map<Team, String> names,
    double recordedUnix,
    double duration,
    MovementStatistics statistics,
    double noiseMm,
    TeamLimits yellow,
    TeamLimits blue,
    List<DataProblem> problems) {

  /** Copies the collections. {@inheritDoc} */
  public LimitsOutcome {
    Objects.requireNonNull(statistics, "statistics");
    logs = List.copyOf(logs);
    names = Map.copyOf(names);
    problems = List.copyOf(problems);
  }

  static LimitsOutcome of(
      List<Path> logs,
      Map<Team, String> names,
      double recordedUnix,
      double duration,
      MovementStatistics statistics,
      double noiseMm,
      List<DataProblem> problems) {
    return new LimitsOutcome(
        logs,
        names,
        recordedUnix,
        duration,
        statistics,
        noiseMm,
        LimitEstimator.estimate(Team.YELLOW, statistics.of(Team.YELLOW)),
        LimitEstimator.estimate(Team.BLUE, statistics.of(Team.BLUE)),
        problems);
  }

  /**
   * What to call a team.
   *
   * @param team which
   * @return its colour, and its name if that is known
   */
  public String nameOf(Team team) {
    String name = names.get(team);
    return name == null || name.equalsIgnoreCase(team.label())
        ? team.label()
        : team.label() + " (" + name + ")";
  }

  /**
   * The limits of a team.
   *
   * @param team which
   * @return its limits
   */
  public TeamLimits limits(Team team) {
    return team == Team.YELLOW ? yellow : blue;
  }
}
