package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.search.SearchStep.Action;
import fieldcal.effect.Effect;
import fieldcal.effect.MotionEffect;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/** Replaces components by simpler ones, or by a law that explains the same. Not thread-safe. */
final class Simplification {
  /** Prior odds in favour of a law over another cause, in units of chi-square: a hundred to one, since a law of physics is more likely than the same fault in all kicks. */
  private static final double LAW_PREFERRED = 9;

  /** How many simpler ones are refitted, best by the score test first. */
  private static final int SIMPLER_TRIED = 3;

  /** A component whose numbers are farther than this from zero is unusual, as a squared multiple of what is expected beforehand: three standard deviations. */
  private static final double UNUSUAL = 9;

  /** By how much less an equal explanation may explain, as a share: errors of the model make such a difference. */
  private static final double EQUAL = 0.002;

  /** The same where what is replaced is not unusual. */
  private static final double NEARLY_EQUAL = 5e-4;

  /** A component that explains less than this share of the residuals' variance may only make up for a law whose numbers are not quite right. */
  private static final double LITTLE = 0.2;

  /** By how much worse a simpler component may seem to first order and still be tried, as a share of what is explained. In chips that bounce often first order is far off: a slope of the restitution that explained as much as a curve seemed to explain 11 % less. Twice that; the fit decides. */
  private static final double FIRST_ORDER = 0.2;

  private final Refits refits;
  private final Price price;
  private final Dictionary dictionary;
  private final List<SearchStep> trace;

  Simplification(Refits refits, Dictionary dictionary, List<SearchStep> trace) {
    this.refits = refits;
    price = new Price(refits.weighing());
    this.dictionary = dictionary;
    this.trace = trace;
  }

  /** Lets a simpler component stand for one or for several of a kind wherever it explains as much. */
  FittedModel simplified(FittedModel model, int rounds) {
    FittedModel best = model;
    for (int round = 0; round < rounds; round++) {
      FittedModel at = best;
      Optional<FittedModel> simpler =
          withLawForOther(at, List.of()).or(() -> once(at, set -> true));
      if (simpler.isEmpty()) {
        return best;
      }
      best = simpler.get();
    }
    return best;
  }

  /** Lets effects stand for such components wherever they explain as much. */
  FittedModel without(Predicate<Component> which, FittedModel model) {
    FittedModel best = model;
    while (true) {
      Optional<FittedModel> simpler = once(best, set -> set.stream().allMatch(which));
      if (simpler.isEmpty()) {
        return best;
      }
      best = simpler.get();
    }
  }

  /**
   * The model with a law in place of another component, if the law, fitted again from its starts, explains as much; empty if none does. Before, the two may have shared what the law alone explains.
   *
   * @param held components whose laws are not tried again
   */
  Optional<FittedModel> withLawForOther(FittedModel best, List<Component> held) {
    List<Component> had = best.model().components();
    List<Component> replaceable =
        had.stream()
            .filter(c -> c.template() instanceof MotionEffect && !c.isLaw())
            .filter(c -> c.isPerKick() || weakness(best, c) < LITTLE)
            .toList();
    if (replaceable.isEmpty()) {
      return Optional.empty();
    }
    List<Effect> laws = new ArrayList<>(dictionary.laws(best.model()));
    had.stream()
        .filter(c -> c.isLaw() && held.stream().noneMatch(c::isSameCause))
        .map(Component::template)
        .forEach(laws::add);
    return laws.stream()
        .flatMap(law -> law.starts().stream())
        .flatMap(start -> withLawForOther(best, replaceable, start).stream())
        .findFirst();
  }

  /** The same for one start of one law. Beside everything else the law explains at least as much as in the place of a component, so that one fit may show that it can take no place. */
  private Optional<FittedModel> withLawForOther(
      FittedModel best, List<Component> replaceable, Effect start) {
    Component law = Component.of(start, start.magnitudes());
    List<Component> had = new ArrayList<>(best.model().components());
    had.removeIf(Component::isLaw);
    FittedModel beside = refits.fit(best, Pursuit.added(had, List.of(law)));
    double most = price.gain(best, beside) + LAW_PREFERRED;
    for (Component out : replaceable) {
      double saved = Price.of(List.of(out));
      if (most + saved <= 0) {
        continue;
      }
      List<Component> rest = new ArrayList<>(had);
      rest.remove(out);
      FittedModel next = refits.fit(best, Pursuit.added(rest, List.of(law)));
      double gain = price.gain(best, next) + saved + LAW_PREFERRED;
      if (gain > 0) {
        trace.add(new SearchStep(law + " for " + out, Action.SWAPPED, Double.NaN, gain));
        return Optional.of(next);
      }
    }
    return Optional.empty();
  }

  /** What a component of the model explains, as a share of all residuals. */
  private static double weakness(FittedModel best, Component c) {
    return Pursuit.loss(best, best.model().components().indexOf(c)) / best.solution().rows();
  }

  /** Lets one component stand for one of the sets that may be replaced; empty if none explains as much. */
  private Optional<FittedModel> once(FittedModel best, Predicate<List<Component>> mayBeReplaced) {
    List<Component> had = best.model().components();
    List<Effect> now = best.effects();
    List<Proposal> proposals = dictionary.everywhere(best.model().with(List.of()));
    proposals =
        proposals.stream().filter(p -> !p.group() && !p.components().get(0).isPerKick()).toList();
    Scorer scorer = new Scorer(best, Shortlist.components(proposals), refits.weighing());
    for (List<Integer> set : sets(had)) {
      List<Component> removed = set.stream().map(i -> had.get(i).startingAt(now.get(i))).toList();
      if (!mayBeReplaced.test(removed)) {
        continue;
      }
      Sweep sweep = scorer.without(set);
      int[] columns =
          set.stream().flatMapToInt(i -> Arrays.stream(scorer.modelColumns(i))).toArray();
      double kept = sweep.gain(columns) - Price.of(removed);
      List<Component> rest = new ArrayList<>(had);
      set.forEach(i -> rest.remove(had.get(i)));
      double cost = Price.of(removed);
      double unusual = removed.stream().mapToDouble(Simplification::unusual).sum();
      // What is far beyond any usual size gives way to an equal of usual size, even if that has
      // more numbers.
      boolean odd = unusual > UNUSUAL;
      double least = kept - FIRST_ORDER * Math.abs(kept);
      List<Proposal> simpler =
          proposals.stream()
              .filter(p -> !Pursuit.clashes(p, rest))
              .filter(p -> Price.of(p.components()) < cost + (odd ? unusual : 0))
              .filter(p -> net(p, scorer, sweep) > least)
              .sorted(Comparator.comparingDouble(p -> -net(p, scorer, sweep)))
              .limit(SIMPLER_TRIED)
              .toList();
      for (Proposal p : simpler) {
        List<Component> all = new ArrayList<>(rest);
        all.add(scorer.estimated(p.components().get(0), sweep));
        FittedModel next = refits.fit(best, all);
        double gain = price.gain(best, next) + cost - Price.of(p.components());
        double allowed = (odd ? EQUAL : NEARLY_EQUAL) * Math.abs(kept);
        int last = all.size() - 1;
        Component found = next.model().components().get(last).startingAt(next.effects().get(last));
        boolean usual = unusual(found) < (odd ? 0.5 * unusual : UNUSUAL);
        if (gain > -allowed && usual) {
          trace.add(
              new SearchStep(
                  p + " for " + removed, Action.SWAPPED, net(p, scorer, sweep) - kept, gain));
          return Optional.of(next);
        }
      }
    }
    return Optional.empty();
  }

  private static double net(Proposal p, Scorer scorer, Sweep sweep) {
    return sweep.gain(scorer.columns(p)) - Price.of(p.components());
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

  /** All components of one effect or of one camera together first, then each alone; without laws and values that each kick has of its own, which are not linear. */
  private static List<List<Integer>> sets(List<Component> components) {
    Set<List<Integer>> together = new LinkedHashSet<>();
    List<List<Integer>> alone = new ArrayList<>();
    for (Component c : components) {
      if (isLinear(c)) {
        together.add(alike(components, o -> o.template().id().equals(c.template().id())));
        together.add(alike(components, o -> sameCamera(o, c)));
        alone.add(List.of(components.indexOf(c)));
      }
    }
    together.removeIf(set -> set.size() < 2);
    List<List<Integer>> sets = new ArrayList<>(together);
    sets.addAll(alone);
    return sets;
  }

  private static List<Integer> alike(List<Component> components, Predicate<Component> which) {
    return IntStream.range(0, components.size())
        .filter(i -> isLinear(components.get(i)) && which.test(components.get(i)))
        .boxed()
        .toList();
  }

  private static boolean sameCamera(Component a, Component b) {
    return a.camera().isPresent() && a.camera().equals(b.camera());
  }

  private static boolean isLinear(Component c) {
    return !c.isPerKick() && !c.isLaw();
  }
}
