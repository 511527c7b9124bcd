package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import java.util.List;

/**
 * What components cost a model, and what one model gains on another, in units of chi-square.
 *
 * @param weighing of kicks that the first of two models does not explain
 */
public record Price(Weighing weighing) {
  /**
   * Penalty of a component; with one coordinate it must gain 14. Noise lets the best of a hundred independent columns gain 15 in one of a hundred recordings (the 99 % quantile of the largest of a hundred chi-square variables). The search may be generous, since the decision judges
   * again.
   */
  private static final double PENALTY = 8;

  /** What each coordinate must gain in addition: the logarithm of the number of blocks that determine it, some hundreds (Schwarz's criterion). */
  public static final double PENALTY_PER_COORDINATE = 6;

  /** What a law must gain when it replaces another: as an effect of two coordinates. */
  static final double LAW = PENALTY + 2 * PENALTY_PER_COORDINATE;

  /** The least that a proposal must gain; a group must gain it for each member that is needed. */
  static double of(Proposal p) {
    return of(p.group() ? p.components().subList(0, 1) : p.components());
  }

  /**
   * The price of components.
   *
   * @param components of one model
   * @return what they must gain together, in units of chi-square
   */
  public static double of(List<Component> components) {
    double price = 0;
    for (Component c : components) {
      if (c.isLaw()) {
        // A law stands in the place of another with as many numbers.
        price += PENALTY;
        continue;
      }
      // The marginal likelihood contains the penalty of a value for each kick; mean and scatter are
      // two.
      int size = c.magnitudeCount() + (c.isPerKick() ? 1 : 0);
      price += PENALTY + PENALTY_PER_COORDINATE * size;
    }
    return price;
  }

  /** By how much the cost falls. */
  double gain(FittedModel from, FittedModel to) {
    return gain(from, from, to);
  }

  /** The same with the weights that a third model gives. */
  double gain(FittedModel weighted, FittedModel from, FittedModel to) {
    double[] weights = weighing.of(weighted);
    return from.solution().costWith(weights) - to.solution().costWith(weights);
  }

  /** The same less the difference of the prices of their components. */
  double net(FittedModel from, FittedModel to) {
    return gain(from, to) - of(to.model().components()) + of(from.model().components());
  }

  /**
   * The total cost of a model: for each kick the logarithm of its chi-square, as if the kick's noise were unknown, and the price of the components. It compares models that were found with different weights.
   *
   * @param model any
   * @return in units of chi-square
   */
  public static double total(FittedModel model) {
    double sum = model.evenCost() + of(model.model().components());
    for (int k = 0; k < model.kickCount(); k++) {
      sum -= model.solution().chiSquare(k);
      sum += model.solution().kicks().get(k).rows() * Math.log(Math.max(1, model.reduced(k)));
    }
    return sum;
  }
}
