package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.search.SearchStep.Action;
import fieldcal.effect.MotionEffect;
import java.util.ArrayList;
import java.util.List;

/** Takes out of a model what is not needed beside values that differ from kick to kick by chance. Not thread-safe. */
final class Chance {
  private final Refits refits;
  private final Price price;
  private final List<SearchStep> trace;

  /**
   * @param refits of the search
   * @param trace to which what is taken out is added
   */
  Chance(Refits refits, List<SearchStep> trace) {
    this.refits = refits;
    price = new Price(refits.weighing());
    this.trace = trace;
  }

  /** Takes out what costs more than it explains, the weakest first. This may be the chance itself, where the rest explains the kicks. */
  FittedModel onlyWhatIsNeeded(FittedModel model) {
    FittedModel at = model;
    while (true) {
      FittedModel next = withoutWeakest(at);
      if (next == at) {
        return at;
      }
      at = next;
    }
  }

  /** Without the component that is worth least, if that is less than its price. */
  private FittedModel withoutWeakest(FittedModel at) {
    FittedModel best = at;
    Component removed = null;
    for (Component out : candidates(at)) {
      List<Component> rest = new ArrayList<>(at.model().components());
      rest.remove(out);
      FittedModel without = refits.fit(at, rest);
      if (price.net(at, without) > Math.max(0, price.net(at, best))) {
        best = without;
        removed = out;
      }
    }
    if (best != at) {
      trace.add(
          new SearchStep(removed.toString(), Action.REMOVED, Double.NaN, price.gain(at, best)));
    }
    return best;
  }

  /** Effects on the motion that may be taken out: the one that explains least beside the rest to first order, and all that have a value for each kick, about which the first order does not decide. */
  private static List<Component> candidates(FittedModel at) {
    List<Component> all = new ArrayList<>();
    Component weakest = null;
    double least = Double.POSITIVE_INFINITY;
    List<Component> components = at.model().components();
    for (int i = 0; i < components.size(); i++) {
      Component c = components.get(i);
      if (c.isLaw() || !(c.template() instanceof MotionEffect)) {
        continue;
      }
      double net = Pursuit.loss(at, i) - Price.of(List.of(c));
      if (c.isPerKick()) {
        all.add(c);
      } else if (net < least) {
        least = net;
        weakest = c;
      }
    }
    if (weakest != null) {
      all.add(weakest);
    }
    return all;
  }
}
