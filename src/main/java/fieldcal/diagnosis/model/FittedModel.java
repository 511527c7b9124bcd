package fieldcal.diagnosis.model;

import fieldcal.effect.Effect;
import fieldcal.fit.joint.SharedSolution;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A model fitted to the kicks. Immutable.
 *
 * @param model with the layout of its parameters
 * @param solution of the joint fit
 */
public record FittedModel(EffectModel model, SharedSolution<ModelState> solution) {

  /**
   * A kick with the value of its discrete unknown.
   *
   * @param k which
   * @return the term
   */
  public EffectKick kick(int k) {
    return (EffectKick) solution.kicks().get(k);
  }

  /**
   * How many kicks there are.
   *
   * @return their number
   */
  public int kickCount() {
    return solution.kicks().size();
  }

  /**
   * The kicks' observations.
   *
   * @return in order
   */
  public List<KickRecord> records() {
    return solution.kicks().stream().map(k -> ((EffectKick) k).record()).toList();
  }

  /**
   * The same fit for some of the kicks only, from which other fits of them start.
   *
   * @param kept records of these kicks; a record of the same kick with other detections counts as the same
   * @return the kicks in that order
   */
  public FittedModel restrictedTo(List<KickRecord> kept) {
    int[] at = new int[kept.size()];
    for (int i = 0; i < at.length; i++) {
      for (int k = 0; k < kickCount(); k++) {
        if (kick(k).record().kick() == kept.get(i).kick()) {
          at[i] = k;
        }
      }
    }
    return new FittedModel(model, solution.restrictedTo(at));
  }

  /**
   * Effects with their numbers.
   *
   * @return in the order of the components; those that differ from kick to kick at their mean
   */
  public List<Effect> effects() {
    return model.effects(solution.values());
  }

  /**
   * Standard errors of a component's parameters.
   *
   * @param component index
   * @return by name; empty when the equations are singular
   */
  public Optional<Map<String, Double>> errors(int component) {
    return errors(component, new double[model.globals().size()]);
  }

  /**
   * Standard errors of a component's parameters with something else that makes them uncertain.
   *
   * @param component index
   * @param variances that are added to those of the global parameters
   * @return by name; empty when the equations are singular
   */
  public Optional<Map<String, Double>> errors(int component, double[] variances) {
    Component c = model.components().get(component);
    return solution
        .covariance()
        .map(
            v -> {
              for (int i = 0; i < variances.length; i++) {
                v[i][i] += variances[i];
              }
              return c.errors(solution.values(), v, model.offset(component));
            });
  }

  /**
   * Scatter of a component's magnitude from kick to kick.
   *
   * @param component index
   * @return standard deviation; 0 for effects that are the same for all kicks
   */
  public double scatter(int component) {
    Component c = model.components().get(component);
    if (!c.isPerKick()) {
      return 0;
    }
    return solution.scatters()[model.random().indexOf(c)];
  }

  /**
   * Chi-square of a kick for each of its residuals.
   *
   * @param k which
   * @return about 1 where the model is right
   */
  public double reduced(int k) {
    return solution.chiSquare(k) / Math.max(1, solution.kicks().get(k).rows());
  }

  /**
   * How well one kick is explained, against the noise of the cameras alone.
   *
   * @param kick index
   * @return what {@link #reduced(int)} would be if the kick had not been given more noise
   */
  public double reducedAsSeen(int kick) {
    double times = kick(kick).record().timesNoise();
    return reduced(kick) * times * times;
  }

  /**
   * Chi-square for each degree of freedom, against the noise of the cameras alone.
   *
   * @return about 1 where the model is right, whatever noise the kicks were given
   */
  public double reducedAsSeen() {
    double given = 0;
    double seen = 0;
    for (int k = 0; k < kickCount(); k++) {
      double times = kick(k).record().timesNoise();
      given += solution.chiSquare(k);
      seen += solution.chiSquare(k) * times * times;
    }
    return given > 0 ? solution.reducedChiSquare() * seen / given : 0;
  }

  /**
   * The share of the gain in chi-square that does not come from the few kicks that gain most.
   *
   * @param over another model of the same kicks
   * @param few number of the kicks that gain most and do not count
   * @return share of the whole gain; NaN when nothing is gained
   */
  public double shareOfMost(FittedModel over, int few) {
    double[] gained = new double[kickCount()];
    for (int k = 0; k < gained.length; k++) {
      gained[k] = over.solution.chiSquare(k) - solution.chiSquare(k);
    }
    double all = Arrays.stream(gained).sum();
    Arrays.sort(gained);
    return Arrays.stream(gained).limit(Math.max(0, gained.length - few)).sum() / all;
  }

  /**
   * Cost of the fit with equal weights, whatever weights it was found with.
   *
   * @return chi-square, with the penalties of priors and of values that each kick has of its own
   */
  public double evenCost() {
    return solution.costWith(Weighing.ALIKE.of(this));
  }

  /**
   * The model starting from the values that were found, for the next fit of the same model.
   *
   * @return the same model, with the scatters as well
   */
  public EffectModel resumed() {
    return model.startingAt(solution.values(), solution.scatters());
  }

  /**
   * The model with other components, starting from the parameters that were found, for the fit of a neighbouring model. Scatters are estimated from the beginning.
   *
   * @param components of the other model, with their values
   * @return the other model
   */
  public EffectModel resumedWith(List<Component> components) {
    return model.startingAt(solution.values(), new double[0]).with(components);
  }

  /**
   * The components from the numbers that were found.
   *
   * @return in the model's order
   */
  public List<Component> started() {
    List<Effect> now = effects();
    List<Component> components = new ArrayList<>();
    for (int i = 0; i < now.size(); i++) {
      components.add(model.components().get(i).startingAt(now.get(i)));
    }
    return components;
  }
}
