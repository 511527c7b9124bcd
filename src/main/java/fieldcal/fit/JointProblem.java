package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;

/**
 * Many kicks, of both kinds, that share one model and the offsets of the cameras.
 *
 * @param fits each kick fitted on its own, which gives the start, the observations to use and the number of flights; failed fits are left out
 * @param cameras geometry, noise and the offsets already taken out; must be those of the fits
 * @param flat start of the flat model
 * @param chip start of the chip model
 * @param chipRoll accRoll at which chips are held, m/s², negative; free when absent
 * @param offsets whether the cameras' offsets are estimated, too
 */
public record JointProblem(
    List<KickFit> fits,
    CameraViews cameras,
    FlatModel flat,
    ChipModel chip,
    OptionalDouble chipRoll,
    boolean offsets) {

  /**
   * Leaves failed fits out and checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public JointProblem {
    fits = fits.stream().filter(f -> f.failure().isEmpty()).toList();
    Objects.requireNonNull(cameras, "cameras");
    Objects.requireNonNull(flat, "flat");
    Objects.requireNonNull(chip, "chip");
    Objects.requireNonNull(chipRoll, "chipRoll");
  }

  /** The same kicks, chips with bounces that are all alike. */
  JointProblem withEvenBounces() {
    return new JointProblem(
        fits.stream().map(KickFit::withEvenBounces).toList(),
        cameras,
        flat,
        chip,
        chipRoll,
        offsets);
  }
}
