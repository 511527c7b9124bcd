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
import fieldcal.fit.CameraNoise;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Judges the components of a model: each is taken out, and everything else is fitted again. Immutable and thread-safe. */
public final class Decision {
  /** What no more than this many kicks show may be an error of these kicks. */
  public static final int TOO_FEW_KICKS = 2;

  private final DecisionSettings settings;
  private final ModelFitter fitter;
  private final FreshFit fresh;
  private final Alternatives alternatives;
  private final SharedSolver solver;
  private final long seed;

  /**
   * A decision.
   *
   * @param settings every number that decides
   * @param fresh fits of the kicks that start from the simple model
   * @param alternatives what else could explain the same as a component
   * @param seed of the parts of the kicks that are held out
   */
  public Decision(DecisionSettings settings, FreshFit fresh, Alternatives alternatives, long seed) {
    this.settings = settings;
    this.fresh = fresh;
    fitter = fresh.fitter();
    this.alternatives = alternatives;
    this.seed = seed;
    // A cause may have changed how often chips bounced: without it that is settled anew.
    solver = SharedSolver.withDefaults().withMaxIterations(20).settlingVariants();
  }

  /**
   * Judges.
   *
   * @param model fitted to all kicks
   * @param held how it does on kicks that were held out
   * @return one judgement for each component, in the model's order
   */
  public List<Judgement> judge(FittedModel model, HoldOut held) {
    Scales scales = scales(model, held);
    List<Judgement> all = new ArrayList<>();
    for (int i = 0; i < scales.without.size(); i++) {
      all.add(judge(scales, i));
    }
    return all.stream().anyMatch(j -> isUnprovenSpin(j, scales.left))
        ? all.stream().map(Decision::beyondSpin).toList()
        : all;
  }

  /**
   * What the components of a model are weighed with.
   *
   * @param model fitted to all kicks
   * @param without for each component the model without it, everything else fitted again
   * @param evidence by how much chi-square rises without each, in units of what is left
   * @param excess what the model leaves, in the same units; 0 when that is noise
   * @param left whether it leaves more than the noise of the cameras, whatever noise the kicks were given
   * @param curves what learned curves explain together beside a law
   * @param information what the kicks determine of each component beside the others
   * @param held how the model does on kicks that were held out
   * @param heldWithoutChance the same with the mean of what differs from kick to kick by chance; null where nothing does
   */
  private record Scales(
      FittedModel model,
      List<FittedModel> without,
      double[] evidence,
      double excess,
      boolean left,
      double curves,
      Information information,
      HoldOut held,
      HoldOut heldWithoutChance) {

    Component component(int i) {
      return model.model().components().get(i);
    }

    /** What a component's evidence is compared with: what is left, or the largest evidence of its kind; beside a law what learned curves explain together, too. */
    double largest(int i) {
      double most = component(i).isLaw() ? Math.max(excess, curves) : excess;
      for (int j = 0; j < evidence.length; j++) {
        most = isCompared(i, j) ? Math.max(most, evidence[j]) : most;
      }
      return most;
    }

    /** What has no name: what is left, the noise that kicks were given for it, or the largest evidence of a learned curve of a component's kind. */
    double unnamed(int i) {
      double most = Math.max(excess, Leftover.concealed(model));
      for (int j = 0; j < evidence.length; j++) {
        boolean curve = model.effects().get(j) instanceof LearnedTerm;
        most = curve && isCompared(i, j) ? Math.max(most, evidence[j]) : most;
      }
      return most;
    }

    /** A law is the form of everything that it takes part in; other causes only of their kind. */
    private boolean isCompared(int i, int j) {
      return component(i).isLaw() || isMotion(component(j)) == isMotion(component(i));
    }

    private static boolean isMotion(Component c) {
      return c.template() instanceof MotionEffect;
    }
  }

  private Scales scales(FittedModel model, HoldOut held) {
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
    double curves = curvesBesideLaw(model, noise);
    boolean seen = Leftover.ofSeen(model).isSignificant();
    boolean chance = model.model().components().stream().anyMatch(Component::isChance);
    return new Scales(
        model,
        without,
        evidence,
        excess,
        seen,
        curves,
        Information.of(model),
        held,
        chance ? HoldOut.withoutChance(model, seed) : null);
  }

  private Judgement judge(Scales scales, int i) {
    FittedModel model = scales.model;
    FittedModel less = scales.without.get(i);
    HoldOut without = HoldOut.of(less, scales.left, seed);
    Gains gains = Gains.of(model, scales.held, without, seed);
    if (scales.heldWithoutChance != null && !scales.component(i).isPerKick()) {
      HoldOut byMeans = HoldOut.withoutChance(less, seed);
      gains = gains.orMoreCertain(Gains.of(model, scales.heldWithoutChance, byMeans, seed));
    }
    Optional<Dependence> follows = follows(model, i);
    return new Judgement(
        scales.component(i),
        model.effects().get(i),
        model.scatter(i),
        scales.evidence[i],
        gains.seen,
        follows,
        outcome(scales, i, follows.isPresent(), without, gains));
  }

  /**
   * What a component gains on kicks that were held out.
   *
   * @param seen all kicks alike
   * @param heard with the noise that each kick was given
   */
  private record Gains(double[] seen, double[] heard) {
    static Gains of(FittedModel model, HoldOut with, HoldOut without, long seed) {
      return new Gains(
          with.gainOn(without, seed), with.heardBy(model).gainOn(without.heardBy(model), seed));
    }

    /** Root mean square of what the component changes on kicks that were held out, mm. */
    double sizeMm() {
      double before = 100 * seen[0] / seen[1];
      return Math.sqrt(Math.max(0, seen[0] * (2 * before - seen[0])));
    }

    /** The gain with the larger lower bound. Where kicks differ by chance, what acts within a kick shows if each kick has its own value, and what differs between kicks shows if all have the mean. */
    Gains orMoreCertain(Gains other) {
      return other.heard[HoldOut.LOWER] > heard[HoldOut.LOWER] ? other : this;
    }
  }

  /** Whether the kicks have spins that may not come from the kickers: something is left, of which the spins may have absorbed a part, or the spins follow from the kick. */
  private static boolean isUnprovenSpin(Judgement j, boolean left) {
    boolean spin = j.effect() instanceof SpinAtKick && j.component().isPerKick();
    return spin && j.outcome() != Outcome.NAMED && (left || j.follows().isPresent());
  }

  /** What acts through such spins gets no name either: with them it is one free number for each kick. */
  private static Judgement beyondSpin(Judgement j) {
    return j.outcome() == Outcome.NAMED && j.effect().actsThroughSpin() ? j.as(Outcome.FORM) : j;
  }

  /**
   * What would explain as much as a component that was named.
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
   * What the values of a component follow, if it has a value for each kick: all of them, or those of one kind of kick, which other devices kick and other laws move.
   *
   * @param model fitted to all kicks
   * @param i component
   * @return empty when they differ by chance, and for what all kicks share
   */
  public Optional<Dependence> follows(FittedModel model, int i) {
    if (!model.model().components().get(i).isPerKick()) {
      return Optional.empty();
    }
    KickValues all = KickValues.of(model, i);
    List<KickValues> kinds =
        Arrays.stream(KickKind.values())
            .map(all::of)
            .filter(k -> !k.kicks().isEmpty() && k.kicks().size() < all.kicks().size())
            .toList();
    return Stream.concat(Stream.of(all), kinds.stream())
        .flatMap(v -> DependenceSearch.of(v, settings.dependent(), seed).stream())
        .findFirst();
  }

  /** What learned curves explain together beside a law, in units of what is left. If this is more than the law explains, the law is only a form of it and gets no name. 0 unless there are several curves beside a law. */
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
    EffectModel start = model.resumedWith(rest);
    FittedModel fitted = fitter.fit(start, model, Weighing.ALIKE, solver);
    boolean law = out.stream().anyMatch(i -> model.model().components().get(i).isLaw());
    return law || fitted.evenCost() > fresh.simple().evenCost() ? refound(fitted) : fitted;
  }

  /** The same components fitted again from the simple model, and with each start of a law that stays. A fit that explains less than the simple model is a local minimum, and shows nothing about what was taken out. */
  private FittedModel refound(FittedModel fitted) {
    FittedModel best = fresh.orBetter(fitted);
    List<Component> all = best.started();
    for (int i = 0; i < all.size(); i++) {
      for (Effect start : all.get(i).template().starts()) {
        List<Component> with = new ArrayList<>(all);
        with.set(i, Component.of(start, start.magnitudes()));
        FittedModel tried = fresh.of(with);
        best = tried.evenCost() < best.evenCost() ? tried : best;
      }
    }
    return best;
  }

  private Outcome outcome(Scales scales, int i, boolean follows, HoldOut heldWithout, Gains gains) {
    FittedModel model = scales.model;
    double[] gain = gains.heard;
    Component c = scales.component(i);
    Proof proof = new Proof(model, i, settings);
    double evidence = scales.evidence[i];
    int size = c.magnitudeCount() + (c.isPerKick() ? 1 : 0);
    double limit = settings.beyondNoise(size);
    if (!(evidence > limit)) {
      return Outcome.CHANCE;
    }
    if (!c.isPerKick() && !c.isLaw() && !proof.isSteady(gain)) {
      return Outcome.UNSTEADY;
    }
    boolean standsOut = proof.isMostlyMean() && scales.excess < settings.formShare() * evidence;
    boolean small =
        c.isPerKick()
            && scales.left
            && !standsOut
            && (proof.isUneven() || proof.wald() < settings.formShare() * evidence);
    boolean law = follows && c.template().hasOwnMean();
    if (c.isPerKick() && (evidence < scales.excess || small || law)) {
      // A value for each kick absorbs a part of whatever is left, and does not come from a
      // kicker where it follows from the kick.
      return Outcome.UNSTEADY;
    }
    FittedModel without = scales.without.get(i);
    if (c.isPerKick() ? proof.isGainOfFewKicks(without) : proof.isToldByFewKicks(limit)) {
      return Outcome.FEW_KICKS;
    }
    if (!c.isPerKick() && proof.isTakenBack(scales.information)) {
      return Outcome.FORM;
    }
    if (c.hasPlace() && evidence < scales.unnamed(i)) {
      // A place is chosen where it absorbs most of whatever has no name.
      return Outcome.FORM;
    }
    if (!c.isPerKick() && evidence < settings.imitation() * scales.excess) {
      return Outcome.FORM;
    }
    boolean common = !c.isPerKick() && Scales.isMotion(c);
    if (scales.left && common && !(scales.held.errorFactor(heldWithout) < 1)) {
      // It helps to fit kicks, not to predict most of them: what is left may be another form of it.
      return Outcome.FORM;
    }
    // A value for each kick absorbs a part of anything: it also helps where another cause does
    // not have its true form, but then it scatters or leaves something.
    boolean own = !c.isPerKick() || standsOut && !scales.left;
    boolean helps = own && gain[1] >= 100 * settings.formGain();
    double largest = scales.largest(i);
    if (evidence < settings.formShare() * largest && !helps) {
      return Outcome.FORM;
    }
    double least = c.isPerKick() ? settings.formGain() : settings.leastGain();
    if (!(gain[1] > 100 * least && gain[HoldOut.LOWER] > 0)) {
      return Outcome.NO_GAIN;
    }
    if (gains.sizeMm() < 1000 * CameraNoise.FLOOR) {
      return Outcome.TOO_SMALL;
    }
    if (c.isPerKick() && new BallItself(model, i).isPossible()) {
      return Outcome.BALL_ITSELF;
    }
    return c.isLaw() && evidence < largest ? Outcome.FORM : Outcome.NAMED;
  }
}
