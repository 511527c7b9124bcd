package fieldcal.diagnosis.model;

import fieldcal.fit.joint.SharedSolver;
import java.util.List;

/**
 * Fits models starting from the simple model, whatever another search had found. A law that takes the place of another bends the ball's parameters, the numbers of flights and the places of other causes; once it is removed, these hold each other in a local minimum.
 * Immutable and thread-safe.
 *
 * @param fitter of the kicks
 * @param simple the simple model, fitted to the same kicks
 * @param solver how
 */
public record FreshFit(ModelFitter fitter, FittedModel simple, SharedSolver solver) {

  /**
   * Fits a model of these components, with their places.
   *
   * @param components with the numbers to start from
   * @return the fit with equal weights
   */
  public FittedModel of(List<Component> components) {
    SharedSolver settling = solver.settlingVariants();
    EffectModel start = simple.resumedWith(components);
    FittedModel fitted = fitter.fit(start, simple, Weighing.ALIKE, settling);
    return fitter.fitPlaces(fitted, Weighing.ALIKE, settling);
  }

  /**
   * The better of a fit and of the same components fitted afresh.
   *
   * @param fitted a fit that another search ended with
   * @return the one that leaves less
   */
  public FittedModel orBetter(FittedModel fitted) {
    FittedModel fresh = of(fitted.started());
    return fresh.evenCost() < fitted.evenCost() ? fresh : fitted;
  }
}
