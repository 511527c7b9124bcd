package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.Decision;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.decision.Judgement.Outcome;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.FreshFit;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.CauseSearch;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.fit.CameraNoise;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * Chooses which of the components that a search found stay in the model: those with a name, and those that improve how closely it follows held-out kicks. Not thread-safe.
 */
final class ModelChoice {
  /** Components can replace each other if together they explain at least this many times the sum of what each explains beside the others. */
  private static final double MUTUAL = 2;

  /** A component that fails and explains at most this share of what the largest one explains is taken out together with the weakest. */
  private static final double LITTLE = 0.05;

  private final FreshFit fresh;
  private final ModelFitter fitter;
  private final Dictionary dictionary;
  private final DecisionSettings settings;
  private final Decision decision;
  private final HoldOut heldBase;
  private final int maxCauses;
  private final long seed;
  private final SharedSolver solver;
  private final List<SearchStep> trace;
  private final Consumer<String> progress;

  /**
   * @param problem the screened kicks and what may explain them
   * @param heldBase how the simple model does on kicks that were held out
   * @param trace to which simplifications are added
   * @param progress told in words which part of the choice begins
   */
  ModelChoice(
      DiagnosisCase problem, HoldOut heldBase, List<SearchStep> trace, Consumer<String> progress) {
    this.heldBase = heldBase;
    this.trace = trace;
    this.progress = progress;
    fresh = problem.fresh();
    fitter = problem.fitter();
    dictionary = problem.dictionary();
    settings = problem.settings();
    solver = problem.solver();
    maxCauses = problem.problem().maxCauses();
    seed = problem.seed();
    decision = problem.decision();
  }

  /** The best model. A value for each kick helps to follow a kick that has been seen, and may harm the prediction; then the model without such values is taken. */
  Weighed of(FittedModel found) {
    Weighed weighed = weigh(found);
    if (!weighed.held.predictsWorseThan(heldBase, seed)) {
      return weighed;
    }
    Weighed same = weigh(withoutPerKick(weighed.model));
    return same.held.predictsWorseThan(heldBase, seed) ? weighed : same;
  }

  private FittedModel withoutPerKick(FittedModel found) {
    List<Component> kept = new ArrayList<>();
    List<Effect> effects = found.effects();
    for (int i = 0; i < effects.size(); i++) {
      Component c = found.model().components().get(i);
      if (!c.isPerKick()) {
        kept.add(c.startingAt(effects.get(i)));
      }
    }
    return fitter.fit(found.resumedWith(kept), found, Weighing.ALIKE, solver);
  }

  /** A model with the judgements of its components, and how it does on held-out kicks. */
  record Weighed(FittedModel model, List<Judgement> judged, HoldOut held) {
    /** Whether this follows held-out kicks as well, except for a share of its residual. No closed form is more accurate than the floor of the cameras' noise. */
    boolean isAsGoodAs(Weighed other, double share) {
      return held.rmsMm() * (1 - share) <= Math.max(1000 * CameraNoise.FLOOR, other.held.rmsMm());
    }

    /** Whether this follows held-out kicks as well, except for a share of its residual, and predicts them no worse. */
    boolean mayReplace(Weighed other, double share, long seed) {
      return isAsGoodAs(other, share) && !held.predictsWorseThan(other.held, seed);
    }

    /** Whether this follows held-out kicks better beyond chance. With more values for each kick than the other, it must also predict better, since such values may fit what they do not help to predict; otherwise it must not predict worse. */
    boolean isBetterThan(Weighed other, long seed) {
      boolean sound =
          valuesPerKick() > other.valuesPerKick()
              ? predictsBetterThan(other, seed)
              : !held.predictsWorseThan(other.held, seed);
      return sound && held.gainOn(other.held, seed)[HoldOut.LOWER] > 0;
    }

    /** The same without the names of some components. */
    Weighed nameless(Predicate<Judgement> which) {
      List<Judgement> all = new ArrayList<>(judged);
      all.replaceAll(j -> j.isName() && which.test(j) ? j.as(Outcome.FORM) : j);
      return new Weighed(model, all, held);
    }

    private long valuesPerKick() {
      return model.model().components().stream().filter(Component::isPerKick).count();
    }

    /** Whether this predicts most held-out kicks better beyond chance, and is worse by no measure. How closely a model follows kicks that are seen to their end does not show how well it predicts. */
    boolean foretellsMoreThan(Weighed other, long seed) {
      boolean worse =
          held.predictsWorseThan(other.held, seed) || held.predictsMostWorseThan(other.held, seed);
      return !worse && other.held.predictsMostWorseThan(held, seed);
    }

    /** How many components have a name. */
    long names() {
      return judged.stream().filter(Judgement::isName).count();
    }

    /** Whether this predicts held-out kicks better beyond chance, and at no horizon worse. */
    boolean predictsBetterThan(Weighed other, long seed) {
      return other.held.predictsWorseThan(held, seed) && !held.predictsWorseThan(other.held, seed);
    }
  }

  /**
   * Takes out what fails the decision, the weakest first: without it the others may pass. A law is taken out last, since others may have taken its place. What has no name may still be needed: of the models on the way, the simplest is taken that
   * follows held-out kicks as well as the best of them, if it is better than the last one beyond chance.
   */
  private Weighed weigh(FittedModel found) {
    List<Weighed> way = new ArrayList<>();
    // A search for curves does not ask which named effect explains as much as what it adds. Where
    // nothing is left, one may; once everything else that it needs has been taken out, none would.
    boolean explained = hasCurve(found) && !Leftover.of(found).isSignificant();
    FittedModel at =
        explained
            ? replaced(found, (search, model) -> search.without(ModelChoice::isCurve, model))
            : found;
    boolean simplified = false;
    while (true) {
      progress.accept("judging " + counted(at.model().components().size()));
      HoldOut held = HoldOut.of(at, true, seed);
      List<Judgement> judged = decision.judge(at, held);
      way.add(new Weighed(at, judged, held));
      List<Judgement> failed = judged.stream().filter(j -> !stays(j)).toList();
      boolean spent = fitter.effort().isSpent();
      if (!failed.isEmpty()) {
        at = spent ? without(at, judged, failed) : withoutWeakest(at, judged, failed);
        continue;
      }
      FittedModel simpler = simplified || spent ? at : replaced(at, CauseSearch::simplified);
      simplified = true;
      if (simpler == at) {
        Weighed best = best(way);
        return best == way.get(way.size() - 1) ? best : simplified(best);
      }
      at = simpler;
    }
  }

  /** A model with simpler components in place of others, if it follows held-out kicks as well. Beside a curve that only helps to follow the kicks, a cause no longer has to explain what the curve does. */
  private Weighed simplified(Weighed weighed) {
    FittedModel simpler =
        fitter.effort().isSpent()
            ? weighed.model
            : replaced(weighed.model, CauseSearch::simplified);
    if (simpler == weighed.model) {
      return weighed;
    }
    HoldOut held = HoldOut.of(simpler, true, seed);
    Weighed other = new Weighed(simpler, decision.judge(simpler, held), held);
    return other.mayReplace(weighed, settings.formGain(), seed) ? other : weighed;
  }

  private static boolean hasCurve(FittedModel model) {
    return model.model().components().stream().anyMatch(ModelChoice::isCurve);
  }

  private static boolean isCurve(Component c) {
    return c.template() instanceof LearnedTerm;
  }

  /** With simpler components in place of others that explain no more; the same if there are none. */
  private FittedModel replaced(
      FittedModel model, BiFunction<CauseSearch, FittedModel, FittedModel> how) {
    progress.accept("looking for simpler models");
    CauseSearch search = new CauseSearch(fitter, dictionary, maxCauses, solver, progress);
    FittedModel simpler = how.apply(search, model);
    if (simpler == model) {
      return model;
    }
    trace.addAll(search.trace());
    return fitter.fit(simpler.resumed(), simpler, Weighing.ALIKE, solver);
  }

  private static String counted(int components) {
    return components == 1 ? "one effect" : components + " effects";
  }

  /** Without the weakest that failed, and without others that failed and explain little, unless these can replace each other. */
  private FittedModel withoutWeakest(
      FittedModel at, List<Judgement> judged, List<Judgement> failed) {
    List<Judgement> others = failed.stream().filter(j -> !j.component().isLaw()).toList();
    List<Judgement> leaving = others.isEmpty() ? failed : others;
    Judgement weakest =
        leaving.stream().min(Comparator.comparingDouble(Judgement::evidence)).orElseThrow();
    double largest = judged.stream().mapToDouble(Judgement::evidence).max().orElse(0);
    List<Judgement> going =
        leaving.stream().filter(j -> j == weakest || j.evidence() <= LITTLE * largest).toList();
    FittedModel next = without(at, judged, going);
    double noise = Math.max(1, at.solution().reducedChiSquare());
    double lost = (next.evenCost() - at.evenCost()) / noise;
    double expected = going.stream().mapToDouble(Judgement::evidence).sum();
    if (going.size() == 1 || lost < MUTUAL * Math.max(0, expected)) {
      return next;
    }
    return without(at, judged, List.of(weakest));
  }

  /** The same model without some of its components, all others fitted again. */
  FittedModel without(FittedModel at, List<Judgement> judged, List<Judgement> going) {
    List<Component> kept = new ArrayList<>();
    for (Judgement j : judged) {
      if (!going.contains(j)) {
        kept.add(j.component().startingAt(j.effect()));
      }
    }
    EffectModel start = at.resumedWith(kept);
    FittedModel next = fitter.fit(start, at, Weighing.ALIKE, solver);
    return going.stream().anyMatch(j -> j.component().isLaw()) ? fresh.orBetter(next) : next;
  }

  /** Of the models on the way, the last that follows held-out kicks as well as any, without unnamed components that do not improve this. If it is not better than the last model, the one without names that predicts best, if it predicts better than the last; otherwise the last. */
  private Weighed best(List<Weighed> way) {
    Weighed last = way.get(way.size() - 1);
    List<Weighed> sound =
        way.stream().filter(w -> !w.held.predictsWorseThan(heldBase, seed)).toList();
    Weighed top = sound.stream().min(Comparator.comparingDouble(w -> w.held.rmsMm())).orElse(last);
    Weighed best = top;
    for (Weighed w : sound) {
      best = w.isAsGoodAs(top, settings.formGain()) ? w : best;
    }
    if (best == last || !best.isBetterThan(last, seed)) {
      return sound.stream()
          .filter(w -> w.names() == 0 && w.foretellsMoreThan(last, seed))
          .min(Comparator.comparingDouble(w -> w.held.errorFactor(last.held)))
          .orElse(last);
    }
    Weighed lean = best;
    while (true) {
      List<Judgement> idle = lean.judged.stream().filter(this::isIdle).toList();
      // What makes held-out kicks worse may well explain those that it was fitted to.
      Optional<Judgement> worst = idle.stream().min(Comparator.comparingDouble(j -> j.gain()[1]));
      if (worst.isEmpty()) {
        return lean;
      }
      Weighed all = reweighed(lean, idle);
      Weighed next =
          all.isAsGoodAs(best, settings.formGain()) ? all : reweighed(lean, List.of(worst.get()));
      if (!next.isAsGoodAs(best, settings.formGain())) {
        return lean;
      }
      lean = next;
    }
  }

  /** A model with a law in place of values, or beside them where its form is not quite right. Beside a value for each kick a law explains nothing, but it predicts. So every component stays, the law is credited with what the first of the values gained, and the values are not named. */
  Weighed withLaw(FittedModel model, Weighed before, List<Judgement> values) {
    HoldOut held = HoldOut.of(model, true, seed);
    List<Judgement> judged = new ArrayList<>();
    for (Judgement j : decision.judge(model, held)) {
      boolean known = isAmong(before.judged, j);
      boolean same = isAmong(values, j);
      judged.add(same ? j.as(Outcome.FORM) : known ? j : j.inPlaceOf(values.get(0)));
    }
    return new Weighed(model, judged, held);
  }

  private static boolean isAmong(List<Judgement> all, Judgement j) {
    return all.stream().anyMatch(k -> k.component().isSameCause(j.component()));
  }

  private Weighed reweighed(Weighed from, List<Judgement> going) {
    FittedModel model = without(from.model, from.judged, going);
    HoldOut held = HoldOut.of(model, true, seed);
    return new Weighed(model, decision.judge(model, held), held);
  }

  /** Whether a component has neither a name nor a sufficient gain on held-out kicks. */
  private boolean isIdle(Judgement j) {
    boolean pays = j.gain()[HoldOut.LOWER] > 0 && j.gain()[1] > 100 * settings.formGain();
    return j.outcome() != Outcome.NAMED && !pays;
  }

  /** Whether a component stays: a cause or a learned term that passed, values that may be due to the ball itself, and a law that is only the form of something else. */
  private static boolean stays(Judgement j) {
    return switch (j.outcome()) {
      case NAMED, BALL_ITSELF -> true;
      case FORM -> j.component().isLaw();
      default -> false;
    };
  }
}
