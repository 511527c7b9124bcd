package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import java.util.List;

/** What components cost a model, and what one model gains on another, in units of chi-square. */
final class Price {
  /**
   * What an effect must gain at least. Of a hundred independent columns noise makes the best gain 13 (the 99 % quantile of the largest of a hundred chi-square variables); the search may be generous, since the decision judges once
   * more.
   */
  private static final double PENALTY = 8;

  /** What each coordinate must gain besides: the logarithm of the number of blocks that say something of it, some hundreds (Schwarz's criterion). */
  private static final double PENALTY_PER_COORDINATE = 6;

  /** What a law must gain that has no absence to be compared with: as an effect of two coordinates. */
  static final double LAW = PENALTY + 2 * PENALTY_PER_COORDINATE;

  private Price() {}

  /** The least that a proposal must gain; a group must gain it for each member that is needed. */
  static double of(Proposal p) {
    return of(p.group() ? p.components().subList(0, 1) : p.components());
  }

  static double of(List<Component> components) {
    double price = 0;
    for (Component c : components) {
      if (!c.template().starts().isEmpty()) {
        // A law stands in the place of another with as many numbers.
        price += PENALTY;
        continue;
      }
      // A value for each kick is paid for by the marginal likelihood; mean and scatter are two.
      int size = c.magnitudeCount() + (c.isPerKick() ? 1 : 0);
      price += PENALTY + PENALTY_PER_COORDINATE * size;
    }
    return price;
  }

  /** By how much the cost falls, kicks that the first model does not explain weighing less. */
  static double gain(FittedModel from, FittedModel to) {
    double[] weights = new double[from.kickCount()];
    for (int k = 0; k < weights.length; k++) {
      weights[k] = 1 / Math.max(1, from.reduced(k));
    }
    return from.solution().costWith(weights) - to.solution().costWith(weights);
  }

  /** The same when both pay for their components. */
  static double net(FittedModel from, FittedModel to) {
    return gain(from, to) - of(to.model().components()) + of(from.model().components());
  }
}
