package fieldcal.app.monitor;

import fieldcal.vision.BallModels;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * What is wanted of a monitor, wherever its frames come from.
 *
 * @param models to compare with instead of those that vision publishes
 * @param changes where to write a line of JSON per change
 * @param state where the samples of earlier matches are, and where they are kept
 */
public record MonitorRequest(
    Optional<BallModels> models, Optional<Path> changes, Optional<Path> state) {

  /** Checks that nothing is missing. {@inheritDoc} */
  public MonitorRequest {
    Objects.requireNonNull(models, "models");
    Objects.requireNonNull(changes, "changes");
    Objects.requireNonNull(state, "state");
  }
}
