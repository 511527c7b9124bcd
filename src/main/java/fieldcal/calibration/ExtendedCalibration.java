package fieldcal.calibration;

import fieldcal.effect.ExtendedModel;
import java.util.Objects;

/**
 * A calibration whose simple parameters are valid together with given effects.
 *
 * @param calibration the parameters; its kicks are the corrected ones, what the cameras would have reported without the effects
 * @param model whose effects were taken out; its own simple parameters play no part
 * @param rounds how often all kicks were corrected
 * @param lastMoveMm by how much the last round moved the detections of the kick that it moved most, root mean square, mm
 * @param settled whether that is within the tolerance
 */
public record ExtendedCalibration(
    Calibration calibration, ExtendedModel model, int rounds, double lastMoveMm, boolean settled) {

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when the calibration or the model is null
   */
  public ExtendedCalibration {
    Objects.requireNonNull(calibration, "calibration");
    Objects.requireNonNull(model, "model");
  }
}
