package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.search.SearchStep.Action;
import fieldcal.effect.Effect;
import fieldcal.effect.MotionEffect;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A matching pursuit with joint refits (orthogonal matching pursuit; Pati et al. 1993): everything in a dictionary is score-tested beside the present model, the best are added, all is refitted, what is not needed any more is removed (Wald), until
 * nothing gains more than its penalty. Evidence is not divided by what is still unexplained, or the second of two strong causes would never look worth it; instead a kick that the present model does not explain weighs less, so that those that are
 * explained decide. Not thread-safe; used once.
 */
public final class CauseSearch {
  /**
   * What an effect must gain at least, in units of chi-square. Of a hundred independent columns noise makes the best gain 13 (the 99 % quantile of the largest of a hundred chi-square variables); the search may be generous, since the decision
   * judges once more.
   */
  private static final double PENALTY = 8;

  /** What each coordinate must gain besides: the logarithm of the number of blocks that say something of it, some hundreds (Schwarz's criterion). */
  private static final double PENALTY_PER_COORDINATE = 6;

  /** What else may come at once with the best: that share of its gain. What gains less may be its shadow, and waits for the refit. */
  private static final double TOGETHER = 0.2;

  /** How many come at once: beyond that, columns at the old point say little of the new one. */
  private static final int MOST_AT_ONCE = 3;

  /** Places of a family that take part in a round. */
  private static final int PLACES_KEPT = 2;

  /** A reduced chi-square below that is a tenth more than the noise, and not worth another search. */
  private static final double EXPLAINED = 1.2;

  /** Share of the kicks that must be explained. */
  private static final double MOST_KICKS = 0.85;

  /** Odds of a hundred to one, in units of chi-square, that a law of physics holds rather than that all kicks have the same fault. */
  private static final double LAW_PREFERRED = 9;

  /** How many simpler ones are refitted, best by the score test first. */
  private static final int SIMPLER_TRIED = 3;

  /** Three standard deviations, squared. */
  private static final double UNUSUAL = 9;

  /** Difference, as a share of what is explained, that errors of the model make between equals. */
  private static final double EQUAL = 0.002;

  /** The same where the simpler one is not also the more usual. */
  private static final double NEARLY_EQUAL = 5e-4;

  /** What explains less than that of each residual's variance may be a shadow of a law that is not quite where it belongs. */
  private static final double LITTLE = 0.2;

  /** A simpler component may look that much worse to first order, as a share of what it explains, and be tried all the same. */
  private static final double FIRST_ORDER = 0.02;

  /** Rounds of revision; each is as long as a search. */
  private static final int MOST_REVISIONS = 1;

  /** Joint refits after which early choices are not questioned any more: a recording whose physics the dictionary does not have would keep the search busy. */
  private static final int MOST_FITS = 60;

  /** How many others may come for one that is taken out: a shadow may hide two causes. */
  private static final int EXCHANGED = 2;

  /** Share of all residuals' variance that is worth having: three thousandths of the noise's variance are a twentieth of a millimetre. */
  private static final double WORTH = 0.003;

  /** A refit that gains less than that share of what the score test expects has met something that is not linear, and is not worth a place. */
  private static final double REALISED = 0.1;

  /** A law that replaces another must explain that share of what is left, or its shadow on other effects would be taken for it. */
  private static final double LAW_SHARE = 0.1;

  private final ModelFitter fitter;
  private final Dictionary dictionary;
  private final int maxComponents;
  private final SharedSolver solver;
  private final List<SearchStep> trace = new ArrayList<>();
  private final Set<String> rejected = new HashSet<>();
  private int fits;
  private Component banned;
  private FittedModel best;

  /**
   * A search.
   *
   * @param fitter of the kicks
   * @param dictionary what may be proposed
   * @param maxComponents how many components a model may have
   * @param solver of the refits
   */
  public CauseSearch(
      ModelFitter fitter, Dictionary dictionary, int maxComponents, SharedSolver solver) {
    this.fitter = fitter;
    this.dictionary = dictionary;
    this.maxComponents = maxComponents;
    this.solver = solver;
  }

  /**
   * What was tried.
   *
   * @return in order
   */
  public List<SearchStep> trace() {
    return List.copyOf(trace);
  }

  /**
   * Searches.
   *
   * @param start the model to begin with, fitted to the same kicks
   * @param revises whether early choices are questioned when something is left, and simpler ones looked for; what is in the model already stays otherwise
   * @return the best model found
   */
  public FittedModel search(FittedModel start, boolean revises) {
    best = start;
    addLaws();
    grow(MOST_AT_ONCE);
    for (int i = 0; revises && i < MOST_REVISIONS && !isExplained(best) && revise(); i++) {
      grow(MOST_AT_ONCE);
    }
    if (revises) {
      simplify();
    } else {
      lawForOther();
    }
    return best;
  }

  /**
   * Only lets simpler components stand for others, and laws for what they explain.
   *
   * @param model the model to begin with
   * @return the model, or a simpler one that explains as much
   */
  public FittedModel simplified(FittedModel model) {
    best = model;
    simplify();
    return best;
  }

  /** Each round adds something, or rejects or removes it. */
  private void grow(int atOnce) {
    for (int round = 0; round < 4 * maxComponents && addBest(atOnce); round++) {
      if (trace.get(trace.size() - 1).action() == Action.ADDED) {
        movePlaces();
        addLaws();
        prune();
      }
    }
  }

  /** Whether what is left is hardly more than noise in all kicks but a few, which may be none of the ball's free flights. */
  private static boolean isExplained(FittedModel model) {
    int well = 0;
    for (int k = 0; k < model.kickCount(); k++) {
      well += model.reduced(k) < EXPLAINED * EXPLAINED ? 1 : 0;
    }
    return model.solution().reducedChiSquare() < EXPLAINED || well > MOST_KICKS * model.kickCount();
  }

  /**
   * An early choice may have been the shadow of two causes. Takes out each component in turn and lets others take its place; keeps the best exchange if it is better than what was.
   */
  private boolean revise() {
    FittedModel before = best;
    FittedModel top = null;
    double most = 0;
    String what = "";
    Set<String> tabu = Set.copyOf(rejected);
    for (Component out : before.model().components()) {
      if (fits > MOST_FITS) {
        break;
      }
      best = before;
      rejected.clear();
      List<Component> without = new ArrayList<>(before.model().components());
      without.remove(out);
      if (out.template().starts().isEmpty()) {
        best = fitted(without);
        banned = out;
        for (int i = 0; i < EXCHANGED && addBest(1); i++) {
          prune();
        }
        banned = null;
      } else {
        restartLaw(out, without);
      }
      double gain =
          weightedGain(before, best)
              - penalty(best.model().components())
              + penalty(before.model().components());
      if (gain > most) {
        most = gain;
        top = best;
        what = out.toString();
      }
    }
    best = top == null ? before : top;
    rejected.clear();
    if (top == null) {
      rejected.addAll(tabu);
      return false;
    }
    trace.add(new SearchStep(what, Action.SWAPPED, Double.NaN, most));
    return true;
  }

  /** Lets a simpler component stand for one or for several of a kind wherever it explains as much. */
  private void simplify() {
    for (int round = 0; round < maxComponents; round++) {
      if (!simplifyOnce()) {
        return;
      }
    }
  }

  /** Whether a law, begun again, explains what another component was needed for: the two may share what the law alone would have. */
  private boolean lawForOther() {
    List<Component> had = best.model().components();
    for (Component out : had) {
      if (!(out.template() instanceof MotionEffect) || !out.template().starts().isEmpty()) {
        continue;
      }
      List<Component> rest = new ArrayList<>(had);
      rest.remove(out);
      List<Effect> laws = new ArrayList<>(dictionary.laws(best.model()));
      for (Component c : had) {
        if (!c.template().starts().isEmpty()) {
          laws.add(c.template());
          rest.remove(c);
        }
      }
      boolean small = weakness(out) < LITTLE;
      for (Effect law : small || out.isPerKick() ? laws : List.<Effect>of()) {
        for (Effect start : law.starts()) {
          Component c = Component.of(start, start.magnitudes());
          FittedModel next = fitted(added(rest, List.of(c)));
          double gain = weightedGain(best, next) + penalty(List.of(out)) + LAW_PREFERRED;
          if (gain > 0) {
            trace.add(new SearchStep(c + " for " + out, Action.SWAPPED, Double.NaN, gain));
            best = next;
            return true;
          }
        }
      }
    }
    return false;
  }

  /** What a component of the model explains, as a share of all residuals. */
  private double weakness(Component c) {
    return loss(best, best.model().components().indexOf(c)) / best.solution().rows();
  }

  private boolean simplifyOnce() {
    if (lawForOther()) {
      return true;
    }
    List<Component> had = best.model().components();
    List<Effect> now = best.effects();
    List<Proposal> proposals = dictionary.everywhere(best.model().with(List.of()));
    proposals =
        proposals.stream().filter(p -> !p.group() && !p.components().get(0).isPerKick()).toList();
    Scorer scorer = new Scorer(best, components(proposals));
    for (List<Integer> set : sets(had)) {
      List<Component> removed = set.stream().map(i -> had.get(i).startingAt(now.get(i))).toList();
      Sweep sweep = scorer.without(set);
      int[] columns =
          set.stream().flatMapToInt(i -> Arrays.stream(scorer.modelColumns(i))).toArray();
      double kept = sweep.gain(columns) - penalty(removed);
      List<Component> rest = new ArrayList<>(had);
      set.forEach(i -> rest.remove(had.get(i)));
      double cost = penalty(removed);
      double unusual = removed.stream().mapToDouble(CauseSearch::unusual).sum();
      // What is far beyond any usual size gives way to an equal of usual size, even if that has
      // more numbers.
      boolean odd = unusual > UNUSUAL;
      double least = kept - FIRST_ORDER * Math.abs(kept);
      List<Proposal> simpler =
          proposals.stream()
              .filter(p -> !clashes(p, rest))
              .filter(p -> penalty(p.components()) < cost + (odd ? unusual : 0))
              .filter(p -> net(p, scorer, sweep) > least)
              .sorted(Comparator.comparingDouble(p -> -net(p, scorer, sweep)))
              .limit(SIMPLER_TRIED)
              .toList();
      for (Proposal p : simpler) {
        List<Component> all = new ArrayList<>(rest);
        all.add(scorer.estimated(p.components().get(0), sweep));
        FittedModel next = fitted(all);
        double gain = weightedGain(best, next) + cost - penalty(p.components());
        double allowed = (odd ? EQUAL : NEARLY_EQUAL) * Math.abs(kept);
        int last = all.size() - 1;
        Component found = next.model().components().get(last).startingAt(next.effects().get(last));
        boolean usual = unusual(found) < (odd ? 0.5 * unusual : UNUSUAL);
        if (gain > -allowed && usual) {
          trace.add(
              new SearchStep(
                  p + " for " + removed, Action.SWAPPED, net(p, scorer, sweep) - kept, gain));
          best = next;
          return true;
        }
      }
    }
    return false;
  }

  private static double net(Proposal p, Scorer scorer, Sweep sweep) {
    return sweep.gain(scorer.columns(p)) - penalty(p.components());
  }

  /** Squared distance of a component's numbers from none, in standard deviations of what is expected beforehand. */
  private static double unusual(Component c) {
    double sum = 0;
    for (int j = 0; j < c.magnitudeCount(); j++) {
      double value = c.coordinates().get(j).value();
      sum += value * value * c.priors().get(j).precision();
    }
    return sum;
  }

  /** All components of one effect together first, then each alone; not those that are no linear parameters. */
  private static List<List<Integer>> sets(List<Component> components) {
    List<List<Integer>> sets = new ArrayList<>();
    for (int i = 0; i < components.size(); i++) {
      List<Integer> same = new ArrayList<>();
      for (int j = 0; j < components.size(); j++) {
        if (components.get(j).template().id().equals(components.get(i).template().id())) {
          same.add(j);
        }
      }
      if (isLinear(components.get(i))) {
        if (same.size() > 1 && same.get(0) == i) {
          sets.add(0, same);
        }
        sets.add(List.of(i));
      }
    }
    return sets;
  }

  private static boolean isLinear(Component c) {
    return !c.isPerKick() && c.template().starts().isEmpty();
  }

  private void restartLaw(Component law, List<Component> without) {
    FittedModel before = best;
    for (Effect start : law.template().starts()) {
      List<Component> with = new ArrayList<>(without);
      with.add(Component.of(start, start.magnitudes()));
      best = before;
      FittedModel tried = fitted(with);
      best = weightedGain(before, tried) > 0 ? tried : before;
      if (best != before) {
        return;
      }
    }
  }

  private boolean addBest(int atOnce) {
    EffectModel model = best.model();
    if (model.components().size() >= maxComponents) {
      return false;
    }
    List<Proposal> proposals = new ArrayList<>(dictionary.everywhere(model));
    proposals.addAll(bestPlaces(model));
    proposals.removeIf(p -> rejected.contains(p.toString()));
    if (proposals.isEmpty()) {
      return false;
    }
    Scorer scorer = new Scorer(best, components(proposals));
    Sweep sweep = scorer.sweep();
    List<Component> chosen = new ArrayList<>();
    List<Proposal> from = new ArrayList<>();
    double first = 0;
    double worth = WORTH * best.solution().rows();
    double expected = 0;
    while (from.size() < atOnce && model.components().size() + chosen.size() < maxComponents) {
      Proposal top = null;
      double topNet = Math.max(worth, TOGETHER * first);
      double topGain = 0;
      for (Proposal p : proposals) {
        if (clashes(p, chosen) || banned != null && clashes(p, List.of(banned))) {
          continue;
        }
        double gain = scorer.gain(p, sweep);
        if (gain - penalty(p) <= topNet) {
          continue;
        }
        double net = gain - penalty(p.group() ? members(p, scorer, sweep) : p.components());
        if (net > topNet) {
          topNet = net;
          topGain = gain;
          top = p;
        }
      }
      if (top == null) {
        break;
      }
      first = Math.max(first, topNet);
      expected += topGain;
      from.add(top);
      List<Component> members = top.group() ? members(top, scorer, sweep) : top.components();
      for (Component c : members) {
        chosen.add(c);
        for (int column : scorer.columns(c)) {
          sweep.toggle(column);
        }
      }
      if (chosen.get(chosen.size() - 1).isPerKick()) {
        // Values of each kick's own change all equations.
        break;
      }
    }
    if (chosen.isEmpty()) {
      return false;
    }
    return tryAdding(placed(chosen), from, expected);
  }

  /** The components of a group that are needed, best first, until what the others would add is not worth it. */
  private List<Component> members(Proposal group, Scorer scorer, Sweep at) {
    Sweep sweep = at.copy();
    List<Component> members = new ArrayList<>();
    List<Component> left = new ArrayList<>(group.components());
    while (!left.isEmpty()) {
      Component top = null;
      double most = 0;
      for (Component c : left) {
        double gain = sweep.gain(scorer.columns(c));
        if (gain > most) {
          most = gain;
          top = c;
        }
      }
      if (top == null || !members.isEmpty() && most < penalty(List.of(top))) {
        break;
      }
      members.add(top);
      left.remove(top);
      for (int column : scorer.columns(top)) {
        sweep.toggle(column);
      }
    }
    return members;
  }

  private boolean tryAdding(List<Component> chosen, List<Proposal> from, double expected) {
    FittedModel next = fitted(added(best.model().components(), chosen));
    double gained = weightedGain(best, next);
    double penalty = penalty(chosen);
    boolean good = gained > penalty && gained > REALISED * expected;
    trace.add(
        new SearchStep(chosen.toString(), good ? Action.ADDED : Action.REJECTED, expected, gained));
    if (good) {
      best = next;
      rejected.clear();
      return true;
    }
    if (from.size() > 1) {
      // Together they may be too much at once.
      return tryAdding(placed(membersOf(from.get(0), chosen)), from.subList(0, 1), expected);
    }
    rejected.add(from.get(0).toString());
    return true;
  }

  private static List<Component> membersOf(Proposal p, List<Component> chosen) {
    return chosen.stream().filter(c -> p.components().stream().anyMatch(c::isSameCause)).toList();
  }

  private static List<Component> added(List<Component> had, List<Component> chosen) {
    List<Component> all = new ArrayList<>();
    for (Component h : had) {
      if (chosen.stream().noneMatch(c -> c.isSameCause(h) && Dictionary.isMore(c, h))) {
        all.add(h);
      }
    }
    all.addAll(chosen);
    return all;
  }

  private FittedModel fitted(List<Component> components) {
    fits++;
    double[] none = new double[0];
    EffectModel start =
        best.model().startingAt(best.solution().values(), none).with(started(components));
    return fitter.fit(start, best, true, solver);
  }

  /** Components that the present model has start from its values. */
  private List<Component> started(List<Component> components) {
    List<Component> had = best.model().components();
    List<Effect> now = best.effects();
    List<Component> all = new ArrayList<>();
    for (Component c : components) {
      int i = had.indexOf(c);
      all.add(i < 0 ? c : c.startingAt(now.get(i)));
    }
    return all;
  }

  /** By how much the cost falls, kicks that the first model does not explain weighing less. */
  static double weightedGain(FittedModel from, FittedModel to) {
    double[] weights = new double[from.kickCount()];
    for (int k = 0; k < weights.length; k++) {
      weights[k] = 1 / Math.max(1, from.reduced(k));
    }
    return from.solution().costWith(weights) - to.solution().costWith(weights);
  }

  /** The least that a proposal must gain; a group must gain it for each member that is needed. */
  static double penalty(Proposal p) {
    return penalty(p.group() ? p.components().subList(0, 1) : p.components());
  }

  static double penalty(List<Component> components) {
    double penalty = 0;
    for (Component c : components) {
      if (!c.template().starts().isEmpty()) {
        // A law stands in the place of another with as many numbers.
        penalty += PENALTY;
        continue;
      }
      // A value for each kick is paid for by the marginal likelihood; mean and scatter are two.
      int size = c.magnitudeCount() + (c.isPerKick() ? 1 : 0);
      penalty += PENALTY + PENALTY_PER_COORDINATE * size;
    }
    return penalty;
  }

  private static boolean clashes(Proposal p, List<Component> chosen) {
    return p.components().stream().anyMatch(c -> chosen.stream().anyMatch(c::isSameCause));
  }

  private static Set<Component> components(List<Proposal> proposals) {
    Set<Component> all = new LinkedHashSet<>();
    proposals.forEach(p -> all.addAll(p.components()));
    return all;
  }

  /** Of each family that has a place the best few places. */
  private List<Proposal> bestPlaces(EffectModel model) {
    List<List<Proposal>> families = dictionary.placed(model);
    if (families.isEmpty()) {
      return List.of();
    }
    List<Proposal> all = families.stream().flatMap(List::stream).toList();
    Scorer scorer = new Scorer(best, components(all));
    Sweep sweep = scorer.sweep();
    List<Proposal> kept = new ArrayList<>();
    for (List<Proposal> family : families) {
      family.stream()
          .sorted(Comparator.comparingDouble((Proposal p) -> -scorer.gain(p, sweep)))
          .limit(PLACES_KEPT)
          .forEach(kept::add);
    }
    return kept;
  }

  private List<Component> placed(List<Component> chosen) {
    List<Component> better = new ArrayList<>();
    for (Component c : chosen) {
      better.add(c.hasPlace() ? new PlaceSearch(best).improve(c) : c);
    }
    return better;
  }

  /** Fits the places of what is in the model together with everything else. */
  private void movePlaces() {
    List<Component> components = best.model().components();
    if (components.stream().noneMatch(Component::hasPlace)) {
      return;
    }
    List<Component> freed = new ArrayList<>();
    for (Component c : started(components)) {
      freed.add(c.hasPlace() ? c.withPlaceFree() : c);
    }
    FittedModel moved = fitted(freed);
    double gained = weightedGain(best, moved);
    if (gained > 0) {
      trace.add(new SearchStep("places", Action.MOVED, Double.NaN, gained));
      List<Component> held = new ArrayList<>();
      for (int i = 0; i < freed.size(); i++) {
        held.add(freed.get(i).startingAt(moved.effects().get(i)).withPlaceHeld());
      }
      EffectModel model =
          best.model().startingAt(best.solution().values(), new double[0]).with(held);
      best = fitter.fit(model, moved, true, solver);
    }
  }

  /** Tries laws that replace another: they cannot be score-tested. */
  private void addLaws() {
    if (best.model().components().size() >= maxComponents) {
      return;
    }
    for (Effect law : dictionary.laws(best.model())) {
      FittedModel top = null;
      double most = 0;
      for (Effect start : law.starts()) {
        Component c = Component.of(start, start.magnitudes());
        FittedModel tried = fitted(added(best.model().components(), List.of(c)));
        double gain = weightedGain(best, tried);
        if (gain > most) {
          most = gain;
          top = tried;
        }
      }
      double left = 0;
      for (int k = 0; k < best.kickCount(); k++) {
        left += best.solution().kicks().get(k).rows() * (1 - 1 / Math.max(1, best.reduced(k)));
      }
      boolean good =
          top != null && most > PENALTY + 2 * PENALTY_PER_COORDINATE && most > LAW_SHARE * left;
      trace.add(new SearchStep(law.id(), good ? Action.ADDED : Action.REJECTED, Double.NaN, most));
      if (good) {
        best = top;
        rejected.clear();
      }
    }
  }

  /** Removes what is not needed any more, the weakest first. */
  private void prune() {
    while (!best.model().components().isEmpty()) {
      List<Component> components = best.model().components();
      int weakest = -1;
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < components.size(); i++) {
        double loss = loss(best, i) - penalty(List.of(components.get(i)));
        if (loss < least) {
          least = loss;
          weakest = i;
        }
      }
      if (least > 0) {
        return;
      }
      List<Component> without = new ArrayList<>(components);
      Component removed = without.remove(weakest);
      FittedModel next = fitted(without);
      double lost = weightedGain(next, best);
      if (lost > penalty(List.of(removed))) {
        return;
      }
      trace.add(new SearchStep(removed.toString(), Action.REMOVED, least, -lost));
      best = next;
    }
  }

  /** What the model would lose without a component, to first order; infinite where that says nothing. */
  static double loss(FittedModel model, int component) {
    Component c = model.model().components().get(component);
    if (c.isPerKick() || !c.template().starts().isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    int from = model.model().offset(component);
    int[] indices = new int[c.magnitudeCount()];
    for (int i = 0; i < indices.length; i++) {
      indices[i] = from + i;
    }
    double loss = model.solution().waldLoss(indices);
    return Double.isNaN(loss) ? Double.POSITIVE_INFINITY : loss;
  }
}
