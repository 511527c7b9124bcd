package fieldcal.diagnosis.search;

import fieldcal.ball.ChipModel;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.search.SearchStep.Action;
import fieldcal.effect.Effect;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/**
 * A matching pursuit with joint refits (orthogonal matching pursuit; Pati et al. 1993): everything in a dictionary is score-tested beside the present model, the best components are added, everything is refitted, and what is no longer needed is removed (Wald test), until
 * nothing gains more than its penalty, several rounds in a row add nothing, or the model is full. Not thread-safe; used once.
 */
final class Pursuit {
  /** A component is added together with the best one only if its net gain is at least this share of that one's. What gains less may only imitate the best one, and waits for the refit. */
  private static final double TOGETHER = 0.2;

  /** How many components are added at once. With more, the columns at the old point would not describe the new one. */
  private static final int MOST_AT_ONCE = 3;

  /** Joint refits of one manner, after which early choices are neither exchanged nor moved: otherwise a recording whose physics is not in the dictionary would keep the search busy. */
  private static final int MOST_FITS = 60;

  /** Rounds in a row without an addition that end the pursuit. In 500 steps of recordings that were explained in the end, there were never more than two. After more, the equations at this point do not describe the next one, and each of the many proposals would cost a joint fit. */
  private static final int MOST_IN_VAIN = 4;

  /** How many components may replace one that is taken out: it may have imitated two causes together. */
  private static final int EXCHANGED = 2;

  /** Where a component is taken out, the first steps of the other places must regain this share of what it explained, or they are not moved further: all steps together lead about ten times as far at most. */
  private static final double REGAINED = 0.1;

  /** Least net gain, as a share of the number of residuals: three thousandths of the noise's variance are a twentieth of its standard deviation. */
  private static final double WORTH = 0.003;

  /** Where a refit gains less than this share of what the score test expects, the model is not linear there, and the component is rejected. */
  private static final double REALISED = 0.1;

  /** A law that replaces another, and a component with as many numbers as there are kicks, must explain this share of what is left: each of them absorbs a part of anything. */
  private static final double LAW_SHARE = 0.1;

  /** No component has to explain more than this share of what is left, however many numbers it has. Its penalty counts in any case. */
  private static final double MOST_ASKED = 0.5;

  private final Dictionary dictionary;
  private final int maxComponents;
  private final Refits refits;
  private final Price price;
  private final PlaceMoves places;
  private final List<SearchStep> trace;
  private final Set<String> rejected = new HashSet<>();
  private Component banned;
  private List<Component> held = List.of();
  private Predicate<Proposal> allowed = p -> true;
  private FittedModel best;

  /** What was left when laws were last tried. As long as nearly the same is left, a law that was rejected then would be rejected again. */
  private double leftByLaws = Double.POSITIVE_INFINITY;

  /** The laws of the model, and what was left, when their other forms were last tried; the same holds for forms. */
  private Set<String> lawsTried = Set.of();

  private double leftByForms = Double.POSITIVE_INFINITY;

  /**
   * @param refits with the weights of this pursuit
   * @param dictionary what may be proposed
   * @param maxComponents how many components a model may have
   * @param trace to which each step is added
   */
  Pursuit(Refits refits, Dictionary dictionary, int maxComponents, List<SearchStep> trace) {
    this.refits = refits;
    this.dictionary = dictionary;
    this.maxComponents = maxComponents;
    this.trace = trace;
    price = new Price(refits.weighing());
    places = new PlaceMoves(refits, dictionary);
  }

  /** What comes first. */
  enum Order {
    /** Whatever gains most. */
    BEST,
    /** What all kicks share, and of this first what acts everywhere: places, and values that each kick has of its own, absorb a part of anything. */
    SHARED,
    /** What differs from kick to kick and has no mean of its own. */
    RANDOM
  }

  /** Adds to a model whatever gains more than its penalty; what it already has may be removed only if {@code revises}. */
  FittedModel grown(FittedModel start, Order order, boolean revises) {
    best = start;
    held = revises ? List.of() : start.model().components();
    if (order == Order.RANDOM) {
      dictionary
          .random(start.model())
          .forEach(c -> tryAdding(c.components(), List.of(c), List.of(0.0)));
    }
    addLaws();
    if (order == Order.SHARED) {
      // A place that is chosen early absorbs a part of anything, and stays where it was needed
      // then.
      allowed = p -> isShared(p) && !p.components().get(0).hasPlace();
      addBest(MOST_AT_ONCE);
      prune();
      allowed = Pursuit::isShared;
      grow(MOST_AT_ONCE);
      allowed = p -> true;
      rejected.clear();
    }
    grow(MOST_AT_ONCE);
    return best;
  }

  /** Takes out what may only have imitated others, and lets these take its place. */
  FittedModel revised(FittedModel start) {
    best = start;
    held = List.of();
    if (revise()) {
      grow(MOST_AT_ONCE);
    }
    return best;
  }

  /** Moves what has a place to where it explains most, and takes out what was needed only because a place was wrong. */
  FittedModel settled(FittedModel start) {
    best = start;
    held = List.of();
    int i = 0;
    while (i < best.model().components().size() && refits.count() <= MOST_FITS) {
      FittedModel at = best;
      if (!at.model().components().get(i).hasPlace()) {
        i++;
        continue;
      }
      FittedModel moved = places.atBestInstant(places.relocated(at, i), i);
      FittedModel fewer = settledWithout(at, i);
      boolean idle = price.net(at, fewer) > Math.max(0, price.net(at, moved));
      best = idle ? fewer : moved;
      if (best != at) {
        Component c = at.model().components().get(i);
        Action action = idle ? Action.REMOVED : Action.MOVED;
        trace.add(new SearchStep(c.toString(), action, Double.NaN, price.gain(at, best)));
      }
      i = idle ? 0 : i + 1;
    }
    return best;
  }

  /** The model without a component, with the other places moved; after the first steps, only if these regain enough of what the component explained. */
  private FittedModel settledWithout(FittedModel from, int index) {
    List<Component> without = new ArrayList<>(from.model().components());
    without.remove(index);
    FittedModel fewer = refits.fit(from, without);
    FittedModel begun = places.allRelocated(fewer, 1);
    double lost = price.gain(fewer, from);
    return price.gain(from, fewer, begun) < REGAINED * lost
        ? begun
        : places.allRelocated(begun, PlaceMoves.MOST_STEPS);
  }

  /** Adds components in rounds. It also ends where the score test promises gains that no refit confirms. */
  private void grow(int atOnce) {
    FittedModel before = best;
    List<Component> had = before.model().components();
    int inVain = 0;
    int most = 4 * maxComponents;
    for (int round = 0; round < most && inVain < MOST_IN_VAIN && addBest(atOnce); round++) {
      if (round == 0) {
        addTogether(before);
      }
      inVain++;
      if (trace.get(trace.size() - 1).action() == Action.ADDED) {
        inVain = 0;
        movePlaces(had);
        had = best.model().components();
        if (left() < (1 - LAW_SHARE) * leftByLaws) {
          addLaws();
        }
        if (!lawsTried.equals(laws()) || left() < (1 - LAW_SHARE) * leftByForms) {
          changeLaws();
        }
        prune();
      }
    }
  }

  /**
   * Takes out each component in turn and lets others take its place, or moves it, and keeps the best exchange if it is an improvement. An early choice may have imitated two causes, or have a place where it was needed only before others were added.
   */
  private boolean revise() {
    FittedModel before = best;
    FittedModel top = null;
    double most = 0;
    String what = "";
    Set<String> tabu = Set.copyOf(rejected);
    for (Component out : before.model().components()) {
      if (refits.count() > MOST_FITS) {
        break;
      }
      best = before;
      rejected.clear();
      List<Component> without = new ArrayList<>(before.model().components());
      without.remove(out);
      exchange(out, without);
      if (out.isLaw()) {
        FittedModel restarted = restartedLaw(before, out, without);
        best = price.net(before, restarted) > price.net(before, best) ? restarted : best;
      }
      if (out.hasPlace()) {
        FittedModel moved = places.relocated(before, before.model().components().indexOf(out));
        best = price.net(before, moved) > price.net(before, best) ? moved : best;
      }
      double gain = price.net(before, best);
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

  /** Lets others take the place of a component. */
  private void exchange(Component out, List<Component> without) {
    best = refits.fit(best, without);
    banned = out;
    for (int i = 0; i < EXCHANGED && addBest(1); i++) {
      prune();
    }
    banned = null;
  }

  /** The model with a law fitted again from its starts, which may lead to another minimum. */
  private FittedModel restartedLaw(FittedModel from, Component law, List<Component> without) {
    for (Effect start : law.template().starts()) {
      List<Component> with = new ArrayList<>(without);
      with.add(Component.of(start, start.magnitudes()));
      FittedModel tried = refits.fit(from, with);
      if (price.gain(from, tried) > 0) {
        return tried;
      }
    }
    return from;
  }

  private boolean addBest(int atOnce) {
    EffectModel model = best.model();
    if (model.components().size() >= maxComponents) {
      return false;
    }
    List<Proposal> proposals =
        new Shortlist(best, dictionary, refits.weighing())
            .all(p -> !rejected.contains(p.toString()) && allowed.test(p));
    if (proposals.isEmpty()) {
      return false;
    }
    Scorer scorer = new Scorer(best, Shortlist.components(proposals), refits.weighing());
    Sweep sweep = scorer.sweep();
    List<Component> chosen = new ArrayList<>();
    List<Proposal> from = new ArrayList<>();
    double first = 0;
    double worth = WORTH * best.solution().rows();
    double left = left();
    List<Double> expected = new ArrayList<>();
    while (from.size() < atOnce && model.components().size() + chosen.size() < maxComponents) {
      Proposal top = null;
      double topNet = Math.max(worth, TOGETHER * first);
      double topGain = 0;
      for (Proposal p : proposals) {
        if (clashes(p, chosen) || banned != null && clashes(p, List.of(banned))) {
          continue;
        }
        double gain = scorer.gain(p, sweep);
        if (gain - Price.of(p) <= topNet || gain < leastShare(p) * left) {
          continue;
        }
        double net =
            gain - Price.of(p.group() ? Shortlist.members(p, scorer, sweep) : p.components());
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
      expected.add(topGain);
      from.add(top);
      List<Component> members =
          top.group() ? Shortlist.members(top, scorer, sweep) : top.components();
      for (Component c : members) {
        chosen.add(c);
        for (int column : scorer.columns(c)) {
          sweep.toggle(column);
        }
      }
      if (chosen.get(chosen.size() - 1).isPerKick()) {
        // Values that differ from kick to kick change all equations.
        break;
      }
    }
    if (chosen.isEmpty()) {
      return false;
    }
    return tryAdding(placed(chosen), from, expected);
  }

  /** The share of what is left that a proposal must explain. One with more numbers than there are kicks absorbs a part of anything, as a law does, so the share grows with the numbers. */
  private double leastShare(Proposal p) {
    double perKick = (double) p.components().get(0).magnitudeCount() / best.kickCount();
    return perKick > 1 ? Math.min(MOST_ASKED, LAW_SHARE * perKick) : 0;
  }

  /** Effects that only do something together, in place of what the score test chose, if they explain more. */
  private void addTogether(FittedModel before) {
    for (Proposal p : dictionary.together(before.model())) {
      List<Component> with = added(before.model().components(), p.components());
      if (with.size() > maxComponents) {
        continue;
      }
      FittedModel tried = refits.fit(before, with);
      double gained = price.net(before, tried);
      if (gained > price.net(before, best)) {
        trace.add(new SearchStep(p.toString(), Action.ADDED, Double.NaN, gained));
        best = tried;
        rejected.clear();
      }
    }
  }

  /** Tries components of some proposals; for each of these what the score test expects, the first alone and the others beside those before. */
  private boolean tryAdding(List<Component> chosen, List<Proposal> from, List<Double> gains) {
    double expected = gains.stream().mapToDouble(Double::doubleValue).sum();
    FittedModel next = refits.fit(best, added(best.model().components(), chosen));
    double gained = price.gain(best, next);
    double penalty = Price.of(chosen);
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
      return tryAdding(
          placed(membersOf(from.get(0), chosen)), from.subList(0, 1), gains.subList(0, 1));
    }
    rejected.add(from.get(0).toString());
    return true;
  }

  private static List<Component> membersOf(Proposal p, List<Component> chosen) {
    return chosen.stream().filter(c -> p.components().stream().anyMatch(c::isSameCause)).toList();
  }

  static List<Component> added(List<Component> had, List<Component> chosen) {
    List<Component> all = new ArrayList<>();
    for (Component h : had) {
      if (chosen.stream().noneMatch(c -> c.isSameCause(h) && Dictionary.isMore(c, h))) {
        all.add(h);
      }
    }
    all.addAll(chosen);
    return all;
  }

  static boolean clashes(Proposal p, List<Component> chosen) {
    return p.components().stream().anyMatch(c -> chosen.stream().anyMatch(c::isSameCause));
  }

  private List<Component> placed(List<Component> chosen) {
    return Shortlist.placed(best, chosen, refits.weighing());
  }

  /** Fits the places of what is in the model together with everything else, and looks for the instants of what was not there before. */
  private void movePlaces(List<Component> before) {
    if (best.model().components().stream().noneMatch(Component::hasPlace)) {
      return;
    }
    FittedModel moved = refits.fitPlaces(best);
    for (int i = 0; i < moved.model().components().size(); i++) {
      Component c = moved.model().components().get(i);
      moved = places.elsewhere(moved, i);
      moved = before.stream().anyMatch(c::isSameCause) ? moved : places.atBestInstant(moved, i);
    }
    double gained = price.gain(best, moved);
    if (gained > 0) {
      trace.add(new SearchStep("places", Action.MOVED, Double.NaN, gained));
      best = moved;
    }
  }

  /** Tries laws that replace another: they cannot be score-tested. What gains more than a law is added first, since a law with its several numbers absorbs a part of anything that happens at impacts. */
  private void addLaws() {
    while (best.model().components().size() < maxComponents) {
      FittedModel before = best;
      for (Effect law : dictionary.laws(before.model())) {
        tryLaw(law);
      }
      if (best == before) {
        break;
      }
    }
    leftByLaws = left();
  }

  private void tryLaw(Effect law) {
    FittedModel before = best;
    FittedModel top = null;
    double most = Math.max(Price.LAW, LAW_SHARE * left());
    double gained = 0;
    boolean low = hopsLow(before) && !law.forms().isEmpty();
    for (Effect start : low ? law.forms() : law.starts()) {
      Component c = Component.of(start, start.magnitudes());
      List<Component> with = added(before.model().components(), List.of(c));
      FittedModel tried = low ? refits.fitForm(before, with) : refits.fit(before, with);
      double gain = price.gain(before, tried);
      gained = Math.max(gained, gain);
      if (gain > most) {
        most = gain;
        top = tried;
      }
    }
    if (top != null && addRival() && price.net(before, best) >= price.net(before, top)) {
      return;
    }
    best = top == null ? before : top;
    Action action = top == null ? Action.REJECTED : Action.ADDED;
    trace.add(new SearchStep(law.id(), action, Double.NaN, gained));
    if (top != null) {
      rejected.clear();
    }
  }

  /** Whether the chips hop lower than in the league's models. A law then begins in the form with such low hops, because without them it would explain less. */
  private static boolean hopsLow(FittedModel model) {
    return model.solution().state().chip().lowestHop() < ChipModel.MIN_HOP_HEIGHT;
  }

  /** Adds what gains most among what all kicks share; returns whether anything was added. */
  private boolean addRival() {
    Predicate<Proposal> before = allowed;
    FittedModel from = best;
    allowed = before.and(Pursuit::isShared);
    addBest(1);
    allowed = before;
    return best != from;
  }

  private static boolean isShared(Proposal p) {
    return !p.components().get(0).isPerKick();
  }

  /** Tries the other forms of the laws that the model has. They must explain as much of what is left as a law that is added. */
  private void changeLaws() {
    for (int i = 0; i < best.model().components().size(); i++) {
      FittedModel before = best;
      double most = Math.max(Price.LAW, LAW_SHARE * left());
      for (Effect form : before.model().components().get(i).template().forms()) {
        List<Component> with = new ArrayList<>(before.model().components());
        with.set(i, Component.of(form, form.magnitudes()));
        FittedModel tried = refits.fitForm(before, with);
        double gained = price.gain(before, tried);
        if (gained > most) {
          most = gained;
          best = tried;
        }
      }
      if (best != before) {
        String form = best.model().components().get(i).toString();
        trace.add(new SearchStep(form, Action.SWAPPED, Double.NaN, most));
      }
    }
    lawsTried = laws();
    leftByForms = left();
  }

  /** The laws of the model, with their forms. */
  private Set<String> laws() {
    Set<String> laws = new HashSet<>();
    for (Component c : best.model().components()) {
      if (!c.template().forms().isEmpty()) {
        laws.add(c.toString());
      }
    }
    return laws;
  }

  /** What the model leaves beyond noise, in units of chi-square with the weights of the pursuit, as its gains are. */
  private double left() {
    double[] weights = refits.weighing().of(best);
    double left = 0;
    for (int k = 0; k < best.kickCount(); k++) {
      double beyond = Math.max(0, best.reduced(k) - 1);
      left += weights[k] * best.solution().kicks().get(k).rows() * beyond;
    }
    return left;
  }

  /** Removes what is not needed any more, the weakest first. */
  private void prune() {
    while (!best.model().components().isEmpty()) {
      List<Component> components = best.model().components();
      int weakest = -1;
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < components.size(); i++) {
        if (held.stream().anyMatch(components.get(i)::isSameCause)) {
          continue;
        }
        double loss = loss(best, i) - Price.of(List.of(components.get(i)));
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
      FittedModel next = refits.fit(best, without);
      double lost = price.gain(next, best);
      if (lost > Price.of(List.of(removed))) {
        return;
      }
      trace.add(new SearchStep(removed.toString(), Action.REMOVED, least, -lost));
      best = next;
    }
  }

  /** What the model would lose without a component, to first order; infinite where the first order does not show it. */
  static double loss(FittedModel model, int component) {
    Component c = model.model().components().get(component);
    if (c.isPerKick() || c.isLaw()) {
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
