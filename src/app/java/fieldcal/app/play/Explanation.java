package fieldcal.app.play;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.diagnosis.model.Component;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.KickerEffect;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffect.ImpactLaw;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.fit.joint.ScoreSystem;
import fieldcal.fit.joint.SharedModel;
import fieldcal.fit.joint.SharedProblem;
import fieldcal.fit.joint.SharedProblem.Prior;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * One explanation of recorded kicks: a ball model with effects, how well the kicks determine its numbers, and what it predicts of others. Each kick has position, velocity and time of its own, and the magnitude of what differs
 * from kick to kick; the model's parameters and the other effects' magnitudes are shared by all. Brought to the kernel as {@link ExpectedKick}s. Immutable.
 */
final class Explanation implements SharedModel<ExpectedKick.State> {
  /** What is known of a parameter of the ball beforehand, as a share of its value. */
  private static final double KNOWN = 0.5;

  /** Steps until a rival explains the same kicks as well as it can. */
  private static final int STEPS = 8;

  private final ExtendedModel base;
  private final List<ObservedCamera> observers;
  private final List<Parameter> ball = new ArrayList<>();
  private final List<Effect> held = new ArrayList<>();
  private final List<Component> shared = new ArrayList<>();
  private final List<Component> ofEachKick = new ArrayList<>();
  private final List<Parameter> globals = new ArrayList<>();
  private final List<Prior> priors = new ArrayList<>();
  private final ExpectedKick.State centre;
  private final RealMatrix information;

  /**
   * At values of the shared numbers.
   *
   * @param at null where the model has them
   * @param information on the shared numbers; null when only what is known beforehand
   */
  private Explanation(
      ExtendedModel base, List<ObservedCamera> observers, double[] at, RealMatrix information) {
    this.base = base;
    this.observers = observers;
    for (Parameter p : base.flat().orElseThrow().parameters()) {
      ball.add(p);
    }
    for (Parameter p : base.chip().orElseThrow().parameters()) {
      ball.add(p);
    }
    for (Parameter p : ball) {
      globals.add(p.withValue(p.clamp(p.value())).free());
      double width = KNOWN * p.value();
      priors.add(new Prior(p.value(), 1 / (width * width)));
    }
    for (Effect effect : base.effects()) {
      add(effect);
    }
    for (int k = 0; at != null && k < at.length; k++) {
      globals.set(k, globals.get(k).withValue(at[k]));
    }
    this.information = information == null ? beforehand() : information;
    centre = at(globals.stream().mapToDouble(Parameter::value).toArray());
  }

  /** Only magnitudes that the explanation uses may move. */
  private void add(Effect effect) {
    List<String> used =
        effect.magnitudes().stream().filter(name -> effect.value(name) != 0).toList();
    boolean perKick = effect.differsFromKickToKick() && effect instanceof MotionEffect;
    if (effect instanceof KickerEffect || isForm(effect) || used.isEmpty() || perKick) {
      held.add(effect);
      if (perKick) {
        ofEachKick.add(Component.perKick(effect.withNone()));
      }
      return;
    }
    Component component = Component.of(effect, used);
    shared.add(component);
    globals.addAll(component.coordinates());
    priors.addAll(component.priors());
  }

  /**
   * An explanation of which nothing is known but its numbers.
   *
   * @param model a part that no kick told anything of is taken to be typical
   */
  static Explanation of(ExtendedModel model, List<ObservedCamera> observers) {
    ExtendedModel whole =
        new ExtendedModel(
            Optional.of(model.flat().orElse(FlatModel.typical())),
            Optional.of(model.chip().orElse(ChipModel.typical())),
            model.effects(),
            model.sessionStart());
    return new Explanation(whole, observers, null, null);
  }

  /** A learned curve or a law of impacts is the form of the model: it holds as it is. */
  private static boolean isForm(Effect effect) {
    return effect instanceof LearnedTerm || effect instanceof ImpactLaw;
  }

  private RealMatrix beforehand() {
    RealMatrix known = MatrixUtils.createRealMatrix(priors.size(), priors.size());
    for (int k = 0; k < priors.size(); k++) {
      known.setEntry(k, k, priors.get(k).precision());
    }
    return known;
  }

  @Override
  public ExpectedKick.State at(double[] values) {
    double[] v = new double[ball.size()];
    for (int k = 0; k < v.length; k++) {
      v[k] = ball.get(k).clamp(values[k]);
    }
    List<Effect> effects = new ArrayList<>(held);
    int from = v.length;
    for (Component component : shared) {
      effects.add(component.effect(values, from));
      from += component.size();
    }
    ExtendedModel model = new ExtendedModel(base.flat(), base.chip(), effects, base.sessionStart());
    return new ExpectedKick.State(
        base.flat().orElseThrow().withParameters(v[0], v[1], v[2]),
        base.chip().orElseThrow().withParameters(v[3], v[4], v[5], v[6]),
        model.motion(),
        MeasurementEffects.of(observers, model.measurement()),
        model.sessionStart());
  }

  /** Kicks that went as another explanation has them. */
  private SharedProblem<ExpectedKick.State> problem(List<SeenKick> kicks, Explanation right) {
    List<ExpectedKick> terms = new ArrayList<>();
    List<double[]> starts = new ArrayList<>();
    for (SeenKick kick : kicks) {
      ExpectedKick term = new ExpectedKick(kick, right.centre, ofEachKick);
      terms.add(term);
      starts.add(term.start());
    }
    double[] weights =
        Collections.nCopies(kicks.size(), 1.0).stream().mapToDouble(d -> d).toArray();
    return new SharedProblem<>(this, terms, starts, globals, priors, List.of(), weights);
  }

  /** The same, knowing what these kicks tell of its numbers. */
  Explanation knowing(List<SeenKick> kicks) {
    RealMatrix known = beforehand();
    if (!kicks.isEmpty()) {
      known = known.add(curvature(ScoreSystem.at(problem(kicks, this))));
    }
    double[] values = globals.stream().mapToDouble(Parameter::value).toArray();
    return new Explanation(base, observers, values, known);
  }

  /** With the numbers that explain kicks best which went as another explanation has them. */
  Explanation fittedTo(Explanation other, List<SeenKick> kicks) {
    if (kicks.isEmpty()) {
      return this;
    }
    double[] better =
        SharedSolver.withDefaults().withMaxIterations(STEPS).solve(problem(kicks, other)).values();
    return new Explanation(base, observers, better, null).knowing(kicks);
  }

  /**
   * By how much chi-square would be larger under this explanation, refitted, than under another that is right, once a kick is made: the leading term of Box and Hill's
   * expected discrimination (Technometrics 9, 1967, p. 57).
   */
  double misfit(SeenKick kick, Explanation right) {
    ScoreSystem e = ScoreSystem.at(problem(List.of(kick), right));
    RealVector slope = new ArrayRealVector(e.size());
    for (int k = 0; k < e.size(); k++) {
      slope.setEntry(k, e.slope(k));
    }
    RealVector step =
        new CholeskyDecomposition(information.add(curvature(e)), 1e-6, 0).getSolver().solve(slope);
    return Math.max(0, e.cost(0) - slope.dotProduct(step));
  }

  private static RealMatrix curvature(ScoreSystem system) {
    RealMatrix curvature = MatrixUtils.createRealMatrix(system.size(), system.size());
    for (int i = 0; i < system.size(); i++) {
      for (int j = 0; j < system.size(); j++) {
        curvature.setEntry(i, j, system.curvature(i, j));
      }
    }
    return curvature;
  }
}
