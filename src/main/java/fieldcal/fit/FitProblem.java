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
 * @param flat accSlide, accRoll (m/s²), kSwitch (–), in this order: initial value, bounds, and whether it is estimated
 * @param chip dampingXyFirstHop, dampingXyOtherHops, dampingZ (–), accRoll (m/s²), in this order: initial value, bounds, and whether it is estimated
 */
public record FitProblem(
    Kick kick, CameraViews cameras, List<Parameter> flat, List<Parameter> chip) {

  /**
   * Copies the lists and checks their length. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   * @throws IllegalArgumentException when there are not three flat and four chip parameters
   */
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
   * The problem with all parameters free, starting from a model; an initial value beyond a bound is moved to that bound.
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
   * The same problem with the accRoll of chips held at a value, usually that of the flat kicks.
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
