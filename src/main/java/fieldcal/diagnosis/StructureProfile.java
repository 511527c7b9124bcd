package fieldcal.diagnosis;

import java.util.List;
import java.util.Objects;

/**
 * How residuals depend on one variable.
 *
 * @param variable on what
 * @param bins in ascending order of the variable
 * @param share of the systematic part of the residuals that the bins' means make up, 0 to 1
 * @param deviation by how much the bins' means together exceed what noise makes of them, in standard deviations of noise
 */
public record StructureProfile(
    StructureVariable variable, List<Bin> bins, double share, double deviation) {

  /**
   * Mean residual, seen minus predicted, over a range of the variable. It is given along and across the path of the ball, but for the variables camera, image column and image row along x and y of
   * the field.
   *
   * @param at mean of the variable over the bin's observations, in the unit of the variable; for cameras the id, for robots the number, plus 100 for blue ones
   * @param alongMm along the path or x, mm
   * @param acrossMm across the path, positive to its left, or along y, mm
   * @param errorMm standard error of both for the cameras' noise alone, mm
   * @param count how many observations
   */
  public record Bin(double at, double alongMm, double acrossMm, double errorMm, int count) {}

  /** Copies the bins. {@inheritDoc} */
  public StructureProfile {
    Objects.requireNonNull(variable, "variable");
    bins = List.copyOf(bins);
  }
}
