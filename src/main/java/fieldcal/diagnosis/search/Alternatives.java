package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.Effect;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What else would explain the same as a component of a model. Immutable and thread-safe. */
public final class Alternatives {
  /** How many are tried by a joint refit, in the order of the score test. */
  private static final int TRIED = 4;

  private final ModelFitter fitter;
  private final Dictionary dictionary;
  private final SharedSolver solver;

  /**
   * Alternatives from a dictionary.
   *
   * @param fitter of the kicks
   * @param dictionary of everything that may be proposed
   */
  public Alternatives(ModelFitter fitter, Dictionary dictionary) {
    this.fitter = fitter;
    this.dictionary = dictionary;
    solver = SharedSolver.withDefaults().withMaxIterations(20).settlingVariants();
  }

  /**
   * An effect with what it would gain.
   *
   * @param effect with the numbers that the score test estimates
   * @param gain of chi-square by the score test
   */
  public record Scored(Effect effect, double gain) {}

  /**
   * What each effect of the dictionary would gain beside a model by itself.
   *
   * @param model fitted to all kicks
   * @return best first; effects that act everywhere
   */
  public List<Scored> scores(FittedModel model) {
    List<Proposal> proposals =
        dictionary.everywhere(model.model()).stream().filter(p -> !p.group()).toList();
    if (proposals.isEmpty()) {
      return List.of();
    }
    Scorer scorer =
        new Scorer(
            model,
            proposals.stream().flatMap(p -> p.components().stream()).toList(),
            Weighing.EXPLAINED_FIRST);
    List<Scored> all = new ArrayList<>();
    for (Proposal p : proposals) {
      Component c = p.components().get(0);
      Sweep sweep = scorer.sweep();
      int[] columns = scorer.columns(c);
      double gain = scorer.gain(p, sweep);
      double[] at = new double[columns.length];
      for (int column : columns) {
        sweep.toggle(column);
      }
      for (int i = 0; i < at.length; i++) {
        at[i] = sweep.contains(columns[i]) ? sweep.estimate(columns[i]) : 0;
      }
      all.add(new Scored(c.effect(at, 0), gain));
    }
    all.sort(Comparator.comparingDouble(s -> -s.gain()));
    return all;
  }

  /**
   * Those that explain as much, all else fitted again.
   *
   * @param model fitted to all kicks
   * @param i component
   * @param tolerance rise of the cost up to which they count as equal, in units of chi-square
   * @return ids of effects; of the same effect on another camera "id of camera n"
   */
  public List<String> equalTo(FittedModel model, int i, double tolerance) {
    Component own = model.model().components().get(i);
    if (own.isPerKick() || own.isLaw()) {
      return List.of();
    }
    List<Component> rest = new ArrayList<>(model.model().components());
    rest.remove(i);
    List<Proposal> proposals =
        dictionary.everywhere(model.model().with(rest)).stream()
            .filter(p -> !p.group() && !p.components().get(0).isPerKick())
            .filter(p -> !p.components().get(0).isSameCause(own))
            .filter(p -> rest.stream().noneMatch(r -> r.isSameCause(p.components().get(0))))
            .toList();
    if (proposals.isEmpty()) {
      return List.of();
    }
    Scorer scorer =
        new Scorer(
            model,
            proposals.stream().flatMap(p -> p.components().stream()).toList(),
            Weighing.EXPLAINED_FIRST);
    Sweep sweep = scorer.without(List.of(i));
    double loss = sweep.gain(scorer.modelColumns(i));
    // The score test is exact to first order only; the refit decides.
    double least = loss - Math.max(3 * tolerance, 0.1 * loss);
    List<Proposal> near =
        proposals.stream()
            .filter(p -> sweep.gain(scorer.columns(p)) > least)
            .sorted(Comparator.comparingDouble(p -> -sweep.gain(scorer.columns(p))))
            .toList();
    // Of several forms of one effect, only the best is tried.
    Map<String, Component> tried = new LinkedHashMap<>();
    for (Proposal p : near) {
      Component c = p.components().get(0);
      if (tried.size() < TRIED) {
        tried.putIfAbsent(c.template().id() + c.template().subject(), c);
      }
    }
    double noise = Math.max(1, model.solution().reducedChiSquare());
    Set<String> equal = new LinkedHashSet<>();
    for (Component c : tried.values()) {
      FittedModel other = swapped(model, i, scorer.estimated(c, sweep));
      if (other.evenCost() - model.evenCost() < tolerance * noise) {
        equal.add(name(c, own));
      }
    }
    return List.copyOf(equal);
  }

  private static String name(Component c, Component own) {
    String id = c.template().id();
    boolean same = id.equals(own.template().id());
    return same && c.camera().isPresent() ? id + " of camera " + c.camera().getAsInt() : id;
  }

  private FittedModel swapped(FittedModel model, int i, Component c) {
    List<Component> all = new ArrayList<>();
    List<Effect> now = model.effects();
    for (int j = 0; j < now.size(); j++) {
      all.add(j == i ? c : model.model().components().get(j).startingAt(now.get(j)));
    }
    EffectModel start = model.resumedWith(all);
    return fitter.fit(start, model, Weighing.ALIKE, solver);
  }
}
