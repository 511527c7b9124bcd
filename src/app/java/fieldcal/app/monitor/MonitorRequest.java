package fieldcal.app.monitor;

import fieldcal.live.ConfiguredLimits;
import fieldcal.vision.BallModels;
import fieldcal.vision.Team;
import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What is wanted of a monitor, wherever its frames come from.
 *
 * @param models to compare with instead of those that vision publishes
 * @param changes where to write a line of JSON per change
 * @param state where the samples of earlier matches are, and where they are kept
 * @param robots what robots are configured to do, by team
 */
public record MonitorRequest(
    Optional<BallModels> models,
    Optional<Path> changes,
    Optional<Path> state,
    Map<Team, ConfiguredLimits> robots) {

  /**
   * Nothing is known of what robots are configured to do.
   *
   * @param models to compare with instead of those that vision publishes
   * @param changes where to write a line of JSON per change
   * @param state where the samples of earlier matches are, and where they are kept
   */
  public MonitorRequest(Optional<BallModels> models, Optional<Path> changes, Optional<Path> state) {
    this(models, changes, state, Map.of());
  }

  /** Checks that nothing is missing. {@inheritDoc} */
  public MonitorRequest {
    Objects.requireNonNull(models, "models");
    Objects.requireNonNull(changes, "changes");
    Objects.requireNonNull(state, "state");
    robots = Map.copyOf(robots);
  }
}
