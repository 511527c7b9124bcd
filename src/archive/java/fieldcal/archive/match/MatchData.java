package fieldcal.archive.match;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.calibration.Calibration;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.RefereeStatistics;
import fieldcal.movement.MovementObserver;
import fieldcal.vision.Team;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What one game log holds.
 *
 * @param file the log
 * @param bytes of its file
 * @param frames of all cameras
 * @param data its kicks and what is known of its cameras
 * @param calibration every kick fitted, and the model of the match
 * @param cameras how well each works
 * @param referee what the referee did; empty when it was silent
 * @param teams names of the teams, as far as the referee tells them
 * @param movement how the robots moved
 * @param trackers what teams and automatic referees say of the ball
 */
public record MatchData(
    Path file,
    long bytes,
    long frames,
    CollectedKicks data,
    Calibration calibration,
    List<CameraStatistics> cameras,
    Optional<RefereeStatistics> referee,
    Map<Team, String> teams,
    MovementObserver movement,
    TrackerWatch trackers) {

  /** Copies the collections. {@inheritDoc} */
  public MatchData {
    cameras = List.copyOf(cameras);
    teams = Map.copyOf(teams);
  }
}
