package fieldcal.live;

import fieldcal.vision.BallModels;
import java.util.List;
import java.util.Objects;

/**
 * What is known of the ball.
 *
 * @param counts what became of the kicks
 * @param published the models it is compared with
 * @param parameters one estimate each, in the order of {@link BallParameter}
 * @param kicks the newest kicks, oldest first
 * @param warnings the active warnings
 */
public record BallSnapshot(
    KickCounts counts,
    BallModels published,
    List<ParameterEstimate> parameters,
    List<LiveKick> kicks,
    List<LiveWarning> warnings) {

  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public BallSnapshot {
    Objects.requireNonNull(counts, "counts");
    Objects.requireNonNull(published, "published");
    parameters = List.copyOf(parameters);
    kicks = List.copyOf(kicks);
    warnings = List.copyOf(warnings);
  }

  /**
   * One parameter.
   *
   * @param parameter which
   * @return its estimate
   */
  public ParameterEstimate of(BallParameter parameter) {
    return parameters.get(parameter.ordinal());
  }
}
