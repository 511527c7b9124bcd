package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.Effect;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.List;

/** Makes and counts the joint fits of a search. The model from which a fit starts determines the weights of the kicks. Not thread-safe. */
final class Refits {
  private final ModelFitter fitter;
  private final Weighing weighing;
  private final SharedSolver solver;
  private int count;

  Refits(ModelFitter fitter, Weighing weighing, SharedSolver solver) {
    this.fitter = fitter;
    this.weighing = weighing;
    this.solver = solver;
  }

  /** How much kicks weigh. */
  Weighing weighing() {
    return weighing;
  }

  /** How many there were. */
  int count() {
    return count;
  }

  /** A model of these components; those that the other model has, or of which it has a lesser version, start from its values. */
  FittedModel fit(FittedModel from, List<Component> components) {
    return fit(from, components, solver);
  }

  /** A model with another form of a law. The chips start with as many hops as this form gives, since the numbers of hops of the other form would hold the fit near that form. */
  FittedModel fitForm(FittedModel from, List<Component> components) {
    return fit(from, components, solver.startingByRule());
  }

  private FittedModel fit(FittedModel from, List<Component> components, SharedSolver solver) {
    count++;
    List<Component> had = from.model().components();
    List<Effect> now = from.effects();
    List<Component> started = new ArrayList<>();
    for (Component c : components) {
      Component start = c;
      for (int i = 0; i < had.size(); i++) {
        Component h = had.get(i);
        if (h == c || frees(c, h)) {
          start = c.startingAt(now.get(i));
        }
      }
      started.add(start);
    }
    return fitter.fit(from.resumedWith(started), from, weighing, solver);
  }

  /** Whether a component frees numbers that a component of the model holds. One with finer detail has other numbers, and begins where the model's ended. */
  private static boolean frees(Component c, Component had) {
    return c.isSameCause(had)
        && Dictionary.isMore(c, had)
        && c.template().parameters().size() == had.template().parameters().size();
  }

  /** The same components with their places fitted together with everything else, and held there again. */
  FittedModel fitPlaces(FittedModel from) {
    count++;
    return fitter.fitPlaces(from, weighing, solver);
  }
}
