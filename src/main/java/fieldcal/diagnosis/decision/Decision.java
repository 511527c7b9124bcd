package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.decision.Judgement.Outcome;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Effect;
import fieldcal.effect.MotionEffect;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.SingularMatrixException;

/** Judges the components of a model: each is taken out and all else fitted again. Immutable and thread-safe. */
public final class Decision {
  /** What only so many kicks show may be theirs. */
  private static final int TOO_FEW_KICKS = 2;

  private final DecisionSettings settings;
  private final ModelFitter fitter;
  private final Alternatives alternatives;
  private final SharedSolver solver;
  private final long seed;

  /**
   * A judge.
   *
   * @param settings every number that decides
   * @param fitter of the kicks
   * @param alternatives what else could stand for a component
   * @param seed of the parts of the kicks that are held out
   */
  public Decision(
      DecisionSettings settings, ModelFitter fitter, Alternatives alternatives, long seed) {
    this.settings = settings;
    this.fitter = fitter;
    this.alternatives = alternatives;
    this.seed = seed;
    solver = SharedSolver.withDefaults().withMaxIterations(20);
  }

  /**
   * Judges.
   *
   * @param model fitted to all kicks
   * @param held how it does on kicks that were held out
   * @return one judgement for each component, in the model's order
   */
  public List<Judgement> judge(FittedModel model, HoldOut held) {
    int n = model.model().components().size();
    List<FittedModel> without = new ArrayList<>();
    double[] evidence = new double[n];
    double noise = Math.max(1, model.solution().reducedChiSquare());
    Leftover left = Leftover.of(model);
    double excess = left.isSignificant() ? left.systematic() * model.solution().rows() / noise : 0;
    for (int i = 0; i < n; i++) {
      FittedModel w = without(model, i);
      without.add(w);
      evidence[i] = (cost(w) - cost(model)) / noise;
    }
    List<Judgement> all = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      all.add(judge(model, i, without.get(i), evidence, excess, held));
    }
    return all;
  }

  private static double cost(FittedModel model) {
    double[] ones = new double[model.kickCount()];
    Arrays.fill(ones, 1);
    return model.solution().costWith(ones);
  }

  private FittedModel without(FittedModel model, int i) {
    List<Component> rest = new ArrayList<>();
    List<Effect> now = model.effects();
    for (int j = 0; j < now.size(); j++) {
      if (j != i) {
        rest.add(model.model().components().get(j).startingAt(now.get(j)));
      }
    }
    EffectModel start =
        model.model().startingAt(model.solution().values(), new double[0]).with(rest);
    return fitter.fit(start, model, false, solver);
  }

  private Judgement judge(
      FittedModel model,
      int i,
      FittedModel without,
      double[] evidence,
      double excess,
      HoldOut held) {
    Component c = model.model().components().get(i);
    HoldOut heldWithout = HoldOut.of(without, false, seed);
    double[] gain = held.gainOn(heldWithout, seed);
    Optional<Map<String, Double>> errors = model.errors(i);
    // What is left may be another form of anything.
    double largest = excess;
    boolean law = !c.template().starts().isEmpty();
    for (int j = 0; j < evidence.length; j++) {
      // A law is the form of everything that it takes part in; other causes only of their kind.
      boolean compared = law || isMotion(model.model().components().get(j)) == isMotion(c);
      largest = compared ? Math.max(largest, evidence[j]) : largest;
    }
    Outcome outcome = outcome(model, i, without, evidence[i], largest, excess, gain);
    List<String> ties =
        outcome == Outcome.NAMED
            ? alternatives.equalTo(
                model, i, Math.max(settings.tie(), settings.tieShare() * evidence[i]))
            : List.of();
    return new Judgement(
        c,
        model.effects().get(i),
        errors.orElse(Map.of()),
        model.scatter(i),
        evidence[i],
        gain,
        ties,
        outcome);
  }

  static boolean isMotion(Component c) {
    return c.template() instanceof MotionEffect;
  }

  private Outcome outcome(
      FittedModel model,
      int i,
      FittedModel without,
      double evidence,
      double largest,
      double excess,
      double[] gain) {
    Component c = model.model().components().get(i);
    int size = c.magnitudeCount() + (c.isPerKick() ? 1 : 0);
    double chance = settings.falseAlarms() / settings.tried();
    double limit = new ChiSquaredDistribution(null, size).inverseCumulativeProbability(1 - chance);
    if (!(evidence > limit)) {
      return Outcome.CHANCE;
    }
    if (!c.isPerKick()
        && c.template().starts().isEmpty()
        && isUneven(model, i, size, settings.uneven())) {
      return Outcome.UNSTEADY;
    }
    boolean small = c.isPerKick() && excess > 0 && isUneven(model, i, 1, settings.uneven());
    if (c.isPerKick() && (evidence < excess || small || Independence.isLaw(model, i))) {
      // A value for each kick takes up something of whatever is left, and is no chance where it
      // follows from the kick.
      return Outcome.UNSTEADY;
    }
    if (isOfFewKicks(model, without)) {
      return Outcome.FEW_KICKS;
    }
    if (evidence < settings.formShare() * largest && gain[1] < 100 * settings.formGain()) {
      return Outcome.FORM;
    }
    double least = c.isPerKick() ? settings.formGain() : settings.leastGain();
    if (!(gain[1] > 100 * least)) {
      return Outcome.NO_GAIN;
    }
    boolean law = !c.template().starts().isEmpty();
    return law && evidence < largest ? Outcome.FORM : Outcome.NAMED;
  }

  /** Whether its strength differs so much from kick to kick that its mean over the kicks may be chance: Hotelling's test with the kicks as the sample. */
  private static boolean isUneven(FittedModel model, int i, int size, double chance) {
    Optional<double[][]> covariance = model.solution().covariance();
    if (covariance.isEmpty()) {
      return true;
    }
    int from = model.model().offset(i);
    double[] values = model.solution().values();
    double[][] v = new double[size][size];
    double[] theta = new double[size];
    for (int a = 0; a < size; a++) {
      theta[a] = values[from + a];
      for (int b = 0; b < size; b++) {
        v[a][b] = covariance.get()[from + a][from + b];
      }
    }
    double wald = quadratic(v, theta);
    int freedom = model.kickCount() - size;
    if (freedom < 2) {
      return true;
    }
    double limit = new FDistribution(null, size, freedom).inverseCumulativeProbability(1 - chance);
    return !(wald / size > limit);
  }

  private static double quadratic(double[][] v, double[] x) {
    double[] scale = new double[x.length];
    for (int a = 0; a < x.length; a++) {
      scale[a] = Math.sqrt(v[a][a]);
    }
    double sum = 0;
    try {
      double[][] r = new double[x.length][x.length];
      double[] z = new double[x.length];
      for (int a = 0; a < x.length; a++) {
        z[a] = x[a] / scale[a];
        for (int b = 0; b < x.length; b++) {
          r[a][b] = v[a][b] / (scale[a] * scale[b]);
        }
      }
      double[] solved =
          new LUDecomposition(new Array2DRowRealMatrix(r, false))
              .getSolver()
              .solve(new ArrayRealVector(z, false))
              .toArray();
      for (int a = 0; a < x.length; a++) {
        sum += z[a] * solved[a];
      }
    } catch (SingularMatrixException e) {
      return 0;
    }
    return sum;
  }

  private boolean isOfFewKicks(FittedModel model, FittedModel without) {
    double[] gained = new double[model.kickCount()];
    for (int k = 0; k < gained.length; k++) {
      gained[k] = without.solution().chiSquare(k) - model.solution().chiSquare(k);
    }
    double sum = Arrays.stream(gained).sum();
    Arrays.sort(gained);
    for (int i = 0; i < Math.min(TOO_FEW_KICKS, gained.length); i++) {
      sum -= gained[gained.length - 1 - i];
    }
    return sum < settings.fewKicks() * Arrays.stream(gained).sum();
  }
}
