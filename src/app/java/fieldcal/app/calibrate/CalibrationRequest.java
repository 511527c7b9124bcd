package fieldcal.app.calibrate;

import fieldcal.calibration.HandSelection;
import fieldcal.effect.ExtendedModel;
import fieldcal.kick.KickKind;
import fieldcal.vision.BallModels;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What an operator asks of a calibration.
 *
 * @param logs at least one recording
 * @param kind when present, all kicks are of that kind
 * @param initial where to start; without it, from what the recordings publish, or typical values
 * @param model effects under which the parameters are to hold; those that grow with time do so from the beginning of the recordings
 * @param selection decisions by hand
 * @param commands what the robots were commanded; may be empty
 */
public record CalibrationRequest(
    List<Path> logs,
    Optional<KickKind> kind,
    Optional<BallModels> initial,
    Optional<ExtendedModel> model,
    HandSelection selection,
    List<CommandFile.Command> commands) {

  /** Copies the lists and checks that nothing is missing. {@inheritDoc} */
  public CalibrationRequest {
    logs = List.copyOf(logs);
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(initial, "initial");
    Objects.requireNonNull(model, "model");
    Objects.requireNonNull(selection, "selection");
    commands = List.copyOf(commands);
  }

  /**
   * A calibration of the simple model from what the recordings hold.
   *
   * @param logs at least one recording
   * @param selection decisions by hand
   * @param commands what the robots were commanded; may be empty
   * @return the request
   */
  public static CalibrationRequest of(
      List<Path> logs, HandSelection selection, List<CommandFile.Command> commands) {
    return new CalibrationRequest(
        logs, Optional.empty(), Optional.empty(), Optional.empty(), selection, commands);
  }
}
