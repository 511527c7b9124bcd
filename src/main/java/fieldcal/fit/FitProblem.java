package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.kick.Kick;
import java.util.List;
import java.util.Objects;

/**
 * Which kick is to be explained, by which model, through which cameras.
 *
 * @param kick the observations
 * @param cameras geometry, offset and noise of the cameras
 * @param flat start, bounds and freedom of accSlide, accRoll, kSwitch
 * @param chip start, bounds and freedom of dampingXyFirstHop, dampingXyOtherHops, dampingZ, accRoll
 */
public record FitProblem(
    Kick kick, CameraViews cameras, List<Parameter> flat, List<Parameter> chip) {

  /** Copies the lists and checks their length. {@inheritDoc} */
  public FitProblem {
    Objects.requireNonNull(kick, "kick");
    Objects.requireNonNull(cameras, "cameras");
    flat = List.copyOf(flat);
    chip = List.copyOf(chip);
    if (flat.size() != 3 || chip.size() != 4) {
      throw new IllegalArgumentException(
          "3 flat and 4 chip parameters are needed, not " + flat.size() + " and " + chip.size());
    }
  }

  /**
   * Everything free, starting from a model; an initial value outside of what an estimator may answer starts on the bound.
   *
   * @param kick the observations
   * @param cameras geometry, offset and noise of the cameras
   * @param flat start of the flat model
   * @param chip start of the chip model, its accRoll included
   * @return the problem
   */
  public static FitProblem of(Kick kick, CameraViews cameras, FlatModel flat, ChipModel chip) {
    return new FitProblem(kick, cameras, within(flat.parameters()), within(chip.parameters()));
  }

  private static List<Parameter> within(List<Parameter> parameters) {
    return parameters.stream().map(p -> p.withValue(p.clamp(p.value()))).toList();
  }

  /**
   * The same of another kick, or of a part of it.
   *
   * @param other kick, seen by the same cameras
   * @return the changed copy
   */
  public FitProblem with(Kick other) {
    return new FitProblem(other, cameras, flat, chip);
  }

  /**
   * The same with accRoll of chips held at the value of the flat kicks.
   *
   * @param accRoll m/s², negative
   * @return the changed copy
   */
  public FitProblem withChipRollFixed(double accRoll) {
    Parameter roll = chip.get(3).withValue(accRoll).fixed();
    return new FitProblem(
        kick, cameras, flat, List.of(chip.get(0), chip.get(1), chip.get(2), roll));
  }
}
