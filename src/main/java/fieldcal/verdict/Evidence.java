package fieldcal.verdict;

import fieldcal.calibration.Calibration;
import fieldcal.kick.KickKind;
import fieldcal.vision.BallModels;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * All that a verdict is made from.
 *
 * @param calibration with its kicks
 * @param published the model in use; may hold none
 * @param effects ids of the effects that the parameters are valid together with; empty for the simple model
 * @param surroundings where the recordings come from
 * @param forced the kind that all kicks were taken to be of, whatever they look like; empty when the path of each decided
 * @param finding of a diagnosis of these kicks; empty when there is none that still holds
 */
public record Evidence(
    Calibration calibration,
    BallModels published,
    List<String> effects,
    Surroundings surroundings,
    Optional<KickKind> forced,
    Optional<Finding> finding) {
  /**
   * Copies the list and checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public Evidence {
    Objects.requireNonNull(calibration, "calibration");
    Objects.requireNonNull(published, "published");
    effects = List.copyOf(effects);
    Objects.requireNonNull(surroundings, "surroundings");
    Objects.requireNonNull(forced, "forced");
    Objects.requireNonNull(finding, "finding");
  }

  /**
   * A calibration alone.
   *
   * @param calibration with its kicks
   * @param published the model in use; may hold none
   * @return evidence of the simple model, without a diagnosis and without knowledge of the recordings
   */
  public static Evidence of(Calibration calibration, BallModels published) {
    return new Evidence(
        calibration,
        published,
        List.of(),
        Surroundings.UNKNOWN,
        Optional.empty(),
        Optional.empty());
  }
}
