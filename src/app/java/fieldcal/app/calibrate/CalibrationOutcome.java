package fieldcal.app.calibrate;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.ball.ChipModel;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.ExtendedCalibration;
import fieldcal.calibration.HandSelection;
import fieldcal.effect.Effect;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.verdict.Evidence;
import fieldcal.verdict.Finding;
import fieldcal.verdict.PublishVerdict;
import fieldcal.verdict.Reason;
import fieldcal.verdict.Surroundings;
import fieldcal.verdict.VerdictRule;
import fieldcal.vision.BallModels;
import fieldcal.vision.FieldGeometry;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A calibration and everything it was made from.
 *
 * @param logs the recordings
 * @param data what was found in them
 * @param initial the model that it started from and is compared with; may hold none
 * @param selection decisions by hand
 * @param commands what the robots were commanded; may be empty
 * @param calibration the result
 * @param extended how it came about when it was made under an extended model
 * @param surroundings where the recordings come from
 * @param forced the kind that all kicks were taken to be of; empty when each kick's path decided
 * @param finding of a diagnosis of these kicks; empty when there is none that still holds
 */
public record CalibrationOutcome(
    List<Path> logs,
    CollectedKicks data,
    BallModels initial,
    HandSelection selection,
    List<CommandFile.Command> commands,
    Calibration calibration,
    Optional<ExtendedCalibration> extended,
    Surroundings surroundings,
    Optional<KickKind> forced,
    Optional<Finding> finding) {
  /** Largest error of the finder's time of a kick from rest, measured on simulated flat kicks (3 ms) and chips (14 ms), s. */
  private static final double FINDER_ERROR = 0.015;

  /** Copies the lists. {@inheritDoc} */
  public CalibrationOutcome {
    logs = List.copyOf(logs);
    commands = List.copyOf(commands);
  }

  /**
   * The same fits under other decisions, within milliseconds; see {@link Calibrator#reselect}.
   *
   * @param decisions by hand
   * @return the changed copy
   */
  public CalibrationOutcome reselected(HandSelection decisions) {
    return new CalibrationOutcome(
        logs,
        data,
        initial,
        decisions,
        commands,
        Calibrator.reselect(calibration, data.epoch(), decisions),
        extended,
        surroundings,
        forced,
        finding);
  }

  /**
   * The same calibration, with what became known of it since.
   *
   * @param found by a diagnosis of these kicks; empty when there is none that still holds
   * @param vision what vision publishes at the moment; empty when nobody listened
   * @return the changed copy
   */
  public CalibrationOutcome knowing(Optional<Finding> found, Optional<FieldGeometry> vision) {
    return new CalibrationOutcome(
        logs,
        data,
        initial,
        selection,
        commands,
        calibration,
        extended,
        new Surroundings(surroundings.recordings(), vision),
        forced,
        found);
  }

  /**
   * Whether the model may be published; what every tool shows.
   *
   * @return the verdict with its reasons
   */
  public PublishVerdict verdict() {
    List<String> effects =
        extended.stream().flatMap(e -> e.model().effects().stream()).map(Effect::id).toList();
    return VerdictRule.judge(
        new Evidence(calibration, initial, effects, surroundings, forced, finding));
  }

  /**
   * Whether there is a model of a kind to show: not where the recordings have no kick of that kind, or where what was fitted as chips did not fly.
   *
   * @param kind flat or chip
   * @return true when its numbers mean something
   */
  public boolean shows(KickKind kind) {
    boolean none =
        kind == KickKind.CHIP
            && verdict().reasons().stream().anyMatch(r -> r instanceof Reason.NoChips);
    return calibration.tells(kind) && !none;
  }

  /**
   * The name of a kick in a {@link HandSelection}.
   *
   * @param kick one of the calibration's
   * @return its key
   */
  public String key(Kick kick) {
    return HandSelection.key(data.epoch().unixSeconds(kick.time()));
  }

  /**
   * What a kick's robot was commanded.
   *
   * @param kick one of the calibration's
   * @return the command, when there is one
   */
  public Optional<CommandFile.Command> command(Kick kick) {
    return CommandFile.of(commands, data.epoch().unixSeconds(kick.time()), kick.robot());
  }

  /**
   * Whether a camera saw any kick; of others neither noise nor offset is known.
   *
   * @param camera its id
   * @return true when it did
   */
  public boolean sawKicks(int camera) {
    return data.kicks().stream()
        .anyMatch(k -> Arrays.stream(k.observations().cameras()).anyMatch(id -> id == camera));
  }

  /**
   * When a kick was. The fit knows to a fraction of a millisecond when its model is right; where it moves the kick by more than the
   * finder can be wrong, which needs no model, it bends time to make up for what its model lacks, and the finder is believed.
   *
   * @param fit of one of the calibration's kicks
   * @return Unix time, s
   */
  public double kickTime(KickFit fit) {
    double found = fit.kick().time();
    if (fit.failure().isPresent()) {
      return data.epoch().unixSeconds(found);
    }
    double fitted = fit.estimate("t0").value();
    return data.epoch().unixSeconds(Math.abs(fitted - found) < FINDER_ERROR ? fitted : found);
  }

  /**
   * The averaged model as the league's messages carry it.
   *
   * @return with the models that are complete; a model of which these kicks leave a parameter open is not published
   */
  public BallModels models() {
    double roll =
        calibration
            .joint()
            .flatMap(j -> j.chip("accRoll"))
            .map(Estimate::value)
            .orElse(ChipModel.typical().accRoll());
    return new BallModels(
        calibration.flatModel(),
        shows(KickKind.CHIP) ? calibration.chipModel(roll) : Optional.empty());
  }
}
