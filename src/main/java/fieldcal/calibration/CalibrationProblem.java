package fieldcal.calibration;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.fit.CameraViews;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.vision.Epoch;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What a calibration is made from.
 *
 * @param kicks all that were found, of one recording or several with the same epoch
 * @param epoch of their times
 * @param cameras geometry of the cameras; noise and offsets are estimated
 * @param flat start of the flat model: the published one, or the typical
 * @param chip start of the chip model
 * @param kind when present, all kicks are taken to be of that kind
 * @param selection decisions by hand
 */
public record CalibrationProblem(
    List<Kick> kicks,
    Epoch epoch,
    CameraViews cameras,
    FlatModel flat,
    ChipModel chip,
    Optional<KickKind> kind,
    HandSelection selection) {

  /**
   * Copies the kicks and checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public CalibrationProblem {
    kicks = List.copyOf(kicks);
    Objects.requireNonNull(epoch, "epoch");
    Objects.requireNonNull(cameras, "cameras");
    Objects.requireNonNull(flat, "flat");
    Objects.requireNonNull(chip, "chip");
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(selection, "selection");
  }

  /**
   * The same with other kicks.
   *
   * @param newKicks as many, in the same order
   * @return the changed copy
   */
  public CalibrationProblem withKicks(List<Kick> newKicks) {
    return new CalibrationProblem(newKicks, epoch, cameras, flat, chip, kind, selection);
  }
}
