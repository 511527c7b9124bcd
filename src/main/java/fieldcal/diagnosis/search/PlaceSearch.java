package fieldcal.diagnosis.search;

import fieldcal.ball.Parameter;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.Effect;
import java.util.ArrayList;
import java.util.List;

/**
 * Moves the place of a proposed component (a region, a line, an instant) to where it would gain most: a compass search (Kolda et al. 2003) on the score test, whose steps shrink when no neighbour is better. It needs no derivative with respect to the place, which
 * does not exist for an instant between two kicks.
 */
final class PlaceSearch {
  /** First step, in scales of the place parameter (1 m, 1 rad or 1 s). For regions this is half the distance of neighbouring places on a field 9 m long that is cut into nine. */
  static final double FIRST_STEP = 0.5;

  static final double SHRINK = 0.4;
  private static final int ROUNDS = 7;

  private final FittedModel model;
  private final Weighing weighing;

  PlaceSearch(FittedModel model, Weighing weighing) {
    this.model = model;
    this.weighing = weighing;
  }

  /** The component at the best place near its own. */
  Component improve(Component start) {
    Component best = start;
    double gain = Double.NaN;
    double share = FIRST_STEP;
    for (int round = 0; round < ROUNDS; round++) {
      List<Component> tried = neighbours(best, share);
      tried.add(best);
      Scorer scorer = new Scorer(model, tried, weighing);
      Sweep sweep = scorer.sweep();
      Component top = best;
      double most = scorer.gain(Proposal.of(best), sweep);
      for (Component c : tried) {
        double g = scorer.gain(Proposal.of(c), sweep);
        if (g > most * (1 + 1e-9)) {
          most = g;
          top = c;
        }
      }
      if (top == best) {
        share *= SHRINK;
      }
      best = top;
      gain = most;
    }
    return Double.isNaN(gain) ? start : best;
  }

  /** The same component at places around its own. */
  static List<Component> neighbours(Component c, double share) {
    List<Component> all = new ArrayList<>();
    Effect effect = c.template();
    for (String name : effect.places()) {
      Parameter p =
          effect.parameters().stream().filter(q -> q.name().equals(name)).findFirst().orElseThrow();
      for (double times : new double[] {-2, -1, 1, 2}) {
        double value = p.value() + times * share * p.scale();
        if (value >= p.min() && value <= p.max()) {
          all.add(c.startingAt(effect.with(name, value)));
        }
      }
    }
    return all;
  }
}
