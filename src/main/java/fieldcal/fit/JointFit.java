package fieldcal.fit;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The answer to a {@link JointProblem}.
 *
 * @param flat accSlide and accRoll (m/s², negative), kSwitch (–); empty without flat kicks
 * @param chip dampingXyFirstHop, dampingXyOtherHops, dampingZ (–), accRoll (m/s², negative); empty without chips
 * @param offsets total offset of each camera that saw a kick, by id, including the offset taken out before
 * @param rmsMm root mean square of the residuals per axis over all used observations, mm
 * @param rmsFlatMm the same over flat kicks, mm; NaN without any
 * @param rmsChipMm the same over chips, mm; NaN without any
 * @param used observations in the fit
 * @param rejected outliers left out
 * @param reducedChiSquare chi-square per degree of freedom against the cameras' noise, when every kick may have values of its own about the model's
 * @param oneModel residuals of one model without such values
 * @param iterations steps taken
 * @param converged whether the last step was too small to matter
 */
public record JointFit(
    List<Estimate> flat,
    List<Estimate> chip,
    Map<Integer, Offset> offsets,
    double rmsMm,
    double rmsFlatMm,
    double rmsChipMm,
    int used,
    int rejected,
    double reducedChiSquare,
    OneModel oneModel,
    int iterations,
    boolean converged) {

  /**
   * What a camera adds to every position, relative to the mean of all cameras.
   *
   * @param x m
   * @param y m
   * @param errorX standard error, m
   * @param errorY standard error, m
   */
  public record Offset(double x, double y, double errorX, double errorY) {}

  /**
   * How well one model describes all kicks, when every kick has to follow it.
   *
   * @param rmsMm root mean square of the residuals per axis, mm
   * @param reducedChiSquare chi-square per degree of freedom against the cameras' noise (–)
   */
  public record OneModel(double rmsMm, double reducedChiSquare) {}

  /**
   * Copies the collections. {@inheritDoc}
   *
   * @throws NullPointerException when a collection or an element is null
   */
  public JointFit {
    flat = List.copyOf(flat);
    chip = List.copyOf(chip);
    offsets = Map.copyOf(offsets);
  }

  /**
   * One parameter of the flat model.
   *
   * @param name as in the model's record
   * @return empty without flat kicks
   */
  public Optional<Estimate> flat(String name) {
    return flat.stream().filter(e -> e.name().equals(name)).findFirst();
  }

  /**
   * One parameter of the chip model.
   *
   * @param name as in the model's record
   * @return empty without chips
   */
  public Optional<Estimate> chip(String name) {
    return chip.stream().filter(e -> e.name().equals(name)).findFirst();
  }
}
