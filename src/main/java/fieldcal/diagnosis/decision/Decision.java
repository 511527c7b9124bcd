package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.decision.Judgement.Outcome;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.FreshFit;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Effect;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffect.SpinAtKick;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.fit.joint.ScoreSystem;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.SingularMatrixException;

/** Judges the components of a model: each is taken out and all else fitted again. Immutable and thread-safe. */
public final class Decision {
  /** What only so many kicks show may be theirs. */
  public static final int TOO_FEW_KICKS = 2;

  /** Hotelling's test needs more kicks than that times the numbers; with fewer it has little power. */
  private static final int KICKS_PER_NUMBER = 2;

  /** A curve that takes back that share of what a cause does leaves less of it than it takes. */
  private static final double TAKEN_BACK = 0.5;

  private final DecisionSettings settings;
  private final ModelFitter fitter;
  private final FreshFit fresh;
  private final Alternatives alternatives;
  private final SharedSolver solver;
  private final long seed;

  /**
   * A judge.
   *
   * @param settings every number that decides
   * @param fresh fits of the kicks from the simple model on
   * @param alternatives what else could stand for a component
   * @param seed of the parts of the kicks that are held out
   */
  public Decision(DecisionSettings settings, FreshFit fresh, Alternatives alternatives, long seed) {
    this.settings = settings;
    this.fresh = fresh;
    fitter = fresh.fitter();
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
    double excess = left.isSignificant() ? left.chiSquare() / noise : 0;
    for (int i = 0; i < n; i++) {
      FittedModel w = without(model, Set.of(i));
      without.add(w);
      evidence[i] = (w.evenCost() - model.evenCost()) / noise;
    }
    Information information = Information.of(model);
    double curves = curvesBesideLaw(model, noise);
    List<Judgement> all = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      boolean law = model.model().components().get(i).isLaw();
      double beside = law ? Math.max(excess, curves) : excess;
      all.add(judge(model, information, i, without.get(i), evidence, excess, beside, held));
    }
    return excess > 0 && all.stream().anyMatch(Decision::isUnprovenSpin)
        ? all.stream().map(Decision::beyondSpin).toList()
        : all;
  }

  /** Whether kicks have spins of which nobody can say that they are the kickers'. */
  private static boolean isUnprovenSpin(Judgement j) {
    boolean spin = j.effect() instanceof SpinAtKick && j.component().isPerKick();
    return spin && j.outcome() != Outcome.NAMED;
  }

  /** What acts through such spins is no better proven: both together are a free number for each kick. */
  private static Judgement beyondSpin(Judgement j) {
    return j.outcome() == Outcome.NAMED && j.effect().actsThroughSpin() ? j.as(Outcome.FORM) : j;
  }

  /**
   * What would explain the same as a component that was named.
   *
   * @param model fitted to all kicks
   * @param i component
   * @param judgement of it
   * @return ids of effects, or an id with its camera
   */
  public List<String> ties(FittedModel model, int i, Judgement judgement) {
    double tolerance = Math.max(settings.tie(), settings.tieShare() * judgement.evidence());
    return alternatives.equalTo(model, i, tolerance);
  }

  /**
   * What the values of a component follow that has one for each kick.
   *
   * @param model fitted to all kicks
   * @param i component
   * @return empty when they differ by chance, and for what all kicks share
   */
  public Optional<Dependence> follows(FittedModel model, int i) {
    return model.model().components().get(i).isPerKick()
        ? DependenceSearch.of(KickValues.of(model, i), settings.dependent(), seed)
        : Optional.empty();
  }

  /** What learned curves explain together beside a law, which is a form of that and has no name where it is more: each curve may be a part of one thing. 0 where there are not several of them beside a law. */
  private double curvesBesideLaw(FittedModel model, double noise) {
    List<Effect> effects = model.effects();
    Set<Integer> curves = new HashSet<>();
    for (int i = 0; i < effects.size(); i++) {
      if (effects.get(i) instanceof LearnedTerm) {
        curves.add(i);
      }
    }
    boolean law = model.model().components().stream().anyMatch(Component::isLaw);
    return law && curves.size() > 1
        ? (without(model, curves).evenCost() - model.evenCost()) / noise
        : 0;
  }

  private FittedModel without(FittedModel model, Set<Integer> out) {
    List<Component> rest = new ArrayList<>();
    List<Effect> now = model.effects();
    for (int j = 0; j < now.size(); j++) {
      if (!out.contains(j)) {
        rest.add(model.model().components().get(j).startingAt(now.get(j)));
      }
    }
    EffectModel start =
        model.model().startingAt(model.solution().values(), new double[0]).with(rest);
    FittedModel fitted = fitter.fit(start, model, Weighing.ALIKE, solver);
    boolean law = out.stream().anyMatch(i -> model.model().components().get(i).isLaw());
    return law ? fresh.orBetter(fitted) : fitted;
  }

  private Judgement judge(
      FittedModel model,
      Information information,
      int i,
      FittedModel without,
      double[] evidence,
      double excess,
      double beside,
      HoldOut held) {
    Component c = model.model().components().get(i);
    HoldOut heldWithout = HoldOut.of(without, false, seed);
    double[] gain = held.gainOn(heldWithout, seed);
    Optional<Map<String, Double>> errors = model.errors(i);
    // What is left may be another form of anything.
    double largest = beside;
    double unexplained = excess;
    for (int j = 0; j < evidence.length; j++) {
      // A law is the form of everything that it takes part in; other causes only of their kind.
      boolean compared = c.isLaw() || isMotion(model.model().components().get(j)) == isMotion(c);
      largest = compared ? Math.max(largest, evidence[j]) : largest;
      if (compared && model.effects().get(j) instanceof LearnedTerm) {
        unexplained = Math.max(unexplained, evidence[j]);
      }
    }
    Optional<Dependence> follows = follows(model, i);
    boolean law = follows.isPresent() && c.template().hasOwnMean();
    Rivals rivals = new Rivals(largest, excess, unexplained);
    Outcome outcome = outcome(model, information, i, without, evidence[i], rivals, law, gain);
    return new Judgement(
        c,
        model.effects().get(i),
        errors.orElse(Map.of()),
        model.scatter(i),
        evidence[i],
        gain,
        follows,
        outcome);
  }

  /**
   * What a component's evidence is compared with, in units of chi-square.
   *
   * @param largest evidence of its kind, or what is left
   * @param left what the model leaves
   * @param unnamed what is left, or the largest evidence of a learned curve of its kind
   */
  private record Rivals(double largest, double left, double unnamed) {}

  static boolean isMotion(Component c) {
    return c.template() instanceof MotionEffect;
  }

  private Outcome outcome(
      FittedModel model,
      Information information,
      int i,
      FittedModel without,
      double evidence,
      Rivals rivals,
      boolean law,
      double[] gain) {
    Component c = model.model().components().get(i);
    int size = c.magnitudeCount() + (c.isPerKick() ? 1 : 0);
    double chance = settings.falseAlarms() / settings.tried();
    double limit = new ChiSquaredDistribution(null, size).inverseCumulativeProbability(1 - chance);
    if (!(evidence > limit)) {
      return Outcome.CHANCE;
    }
    if (!c.isPerKick() && !c.isLaw() && !isSteady(model, i, gain)) {
      return Outcome.UNSTEADY;
    }
    boolean small =
        c.isPerKick()
            && rivals.left > 0
            && (isUneven(model, i, settings.uneven())
                || wald(model, i) < settings.formShare() * evidence);
    if (c.isPerKick() && (evidence < rivals.left || small || law)) {
      // A value for each kick takes up something of whatever is left, and is no kicker's doing
      // where it follows from the kick.
      return Outcome.UNSTEADY;
    }
    if (c.isPerKick() ? isGainOfFewKicks(model, without) : isToldByFewKicks(model, i, limit)) {
      return Outcome.FEW_KICKS;
    }
    if (!c.isPerKick() && isTakenBack(model, information, i)) {
      return Outcome.FORM;
    }
    if (c.hasPlace() && evidence < rivals.unnamed) {
      // A place is chosen where it takes up most of whatever has no name.
      return Outcome.FORM;
    }
    // A value for each kick takes up something of anything: it helps, too, where another cause has
    // not its true form.
    boolean helps = !c.isPerKick() && gain[1] >= 100 * settings.formGain();
    if (evidence < settings.formShare() * rivals.largest && !helps) {
      return Outcome.FORM;
    }
    double least = c.isPerKick() ? settings.formGain() : settings.leastGain();
    if (!(gain[1] > 100 * least)) {
      return Outcome.NO_GAIN;
    }
    return c.isLaw() && evidence < rivals.largest ? Outcome.FORM : Outcome.NAMED;
  }

  /** Whether learned curves undo most of what a cause does: together they are one curve, and its size is a matter of taste. */
  private static boolean isTakenBack(FittedModel model, Information information, int i) {
    List<Effect> effects = model.effects();
    int[] curves =
        IntStream.range(0, effects.size())
            .filter(j -> effects.get(j) instanceof LearnedTerm)
            .toArray();
    return !(effects.get(i) instanceof LearnedTerm) && information.shared(i, curves) < -TAKEN_BACK;
  }

  /** Whether all kicks share its strength. A curve may have too many numbers for a test of them; kicks that were held out must then follow it. */
  private boolean isSteady(FittedModel model, int i, double[] gain) {
    return isTestable(model, i) ? !isUneven(model, i, settings.uneven()) : gain[HoldOut.LOWER] > 0;
  }

  private static boolean isTestable(FittedModel model, int i) {
    int size = model.model().components().get(i).magnitudeCount();
    return model.kickCount() > KICKS_PER_NUMBER * size;
  }

  /** Whether its strength differs so much from kick to kick that its mean over the kicks may be chance: Hotelling's test with the kicks as the sample. */
  private static boolean isUneven(FittedModel model, int i, double chance) {
    int size = model.model().components().get(i).magnitudeCount();
    if (model.solution().covariance().isEmpty() || !isTestable(model, i)) {
      return true;
    }
    double limit =
        new FDistribution(null, size, model.kickCount() - size)
            .inverseCumulativeProbability(1 - chance);
    return !(wald(model, i) / size > limit);
  }

  /** Squared distance of its numbers from zero, in their errors; 0 where these are not known. */
  private static double wald(FittedModel model, int i) {
    int size = model.model().components().get(i).magnitudeCount();
    Optional<double[][]> covariance = model.solution().covariance();
    if (covariance.isEmpty()) {
      return 0;
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
    return quadratic(v, theta);
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

  /**
   * Whether the kicks other than the two most informative ones would not show a cause of that size. What counts is what the equations let each kick tell, not by how much it was wrong: a kick that is metres wrong bends what all kicks share, and then
   * others gain, too.
   */
  private static boolean isToldByFewKicks(FittedModel model, int i, double limit) {
    double[] ones = Weighing.ALIKE.of(model);
    ScoreSystem equations = model.solution().scores(List.of(), new double[0], ones);
    int from = model.model().offset(i);
    int size = model.model().components().get(i).magnitudeCount();
    double[] values = model.solution().values();
    double[] told = new double[model.kickCount()];
    for (int a = from; a < from + size; a++) {
      for (int b = from; b < from + size; b++) {
        int row = model.model().freeIndex(a);
        int column = model.model().freeIndex(b);
        for (int k = 0; k < told.length; k++) {
          told[k] += values[a] * equations.curvature(k, row, column) * values[b];
        }
      }
    }
    Arrays.sort(told);
    double others = Arrays.stream(told).limit(Math.max(0, told.length - TOO_FEW_KICKS)).sum();
    return !(others > limit * Math.max(1, model.solution().reducedChiSquare()));
  }

  /** The same of values that each kick has of its own, whose mean may be nothing. */
  private boolean isGainOfFewKicks(FittedModel model, FittedModel without) {
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
