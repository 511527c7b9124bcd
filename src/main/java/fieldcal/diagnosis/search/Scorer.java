package fieldcal.diagnosis.search;

import fieldcal.ball.Parameter;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.fit.joint.Probe;
import fieldcal.fit.joint.ScoreSystem;
import fieldcal.fit.joint.SharedProblem.Prior;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** Score tests of components on a fitted model: the equations with one column for each of their coordinates. Immutable. */
final class Scorer {
  /** A step for a derivative, in scales of the coordinate. */
  private static final double STEP = 0.05;

  /** Scatters at which a random effect is tried, in scales. */
  private static final double[] SCATTERS = {0.3, 1, 3};

  /** Largest share of the squares of values that differ by chance that a proposal is taken to explain. */
  private static final double MOST_SHARE = 0.9;

  private final FittedModel model;
  private final ScoreSystem system;
  private final double[] precisions;
  private final Sweep sweep;
  private final Map<Component, int[]> columns = new IdentityHashMap<>();

  /**
   * @param model the centre
   * @param components whose columns are wanted
   * @param weighing of kicks that the model does not explain
   */
  Scorer(FittedModel model, Collection<Component> components, Weighing weighing) {
    this.model = model;
    ModelState centre = model.solution().state();
    List<Probe<ModelState>> probes = new ArrayList<>();
    List<Prior> priors = new ArrayList<>();
    int base = freeCount(model);
    for (Component c : components) {
      if (columns.containsKey(c)) {
        continue;
      }
      int[] of = new int[c.size()];
      for (int j = 0; j < of.length; j++) {
        of[j] = base + probes.size();
        probes.add(probe(centre, c, j));
        priors.add(c.priors().get(j));
      }
      columns.put(c, of);
    }
    system = model.solution().scores(probes, weighing.of(model));
    precisions = new double[system.size()];
    List<Prior> known = model.model().priors();
    int free = 0;
    for (int g = 0; g < known.size(); g++) {
      if (model.model().globals().get(g).estimated()) {
        precisions[free++] = known.get(g).precision();
      }
    }
    for (int i = 0; i < priors.size(); i++) {
      precisions[base + i] = priors.get(i).precision();
    }
    sweep = new Sweep(system, precisions);
    for (int i = 0; i < base; i++) {
      sweep.toggle(i);
    }
  }

  /** Central differences where the coordinate may be negative. With one-sided ones, an effect that hardly differs from the ball's own parameters would seem to explain the curvature of the path. */
  private static Probe<ModelState> probe(ModelState centre, Component c, int coordinate) {
    Parameter p = c.coordinates().get(coordinate);
    double h = STEP * p.scale();
    ModelState ahead = stepped(centre, c, coordinate, h);
    return -h < p.min()
        ? new Probe<>(null, ahead, h)
        : new Probe<>(stepped(centre, c, coordinate, -h), ahead, 2 * h);
  }

  private static ModelState stepped(ModelState centre, Component c, int coordinate, double step) {
    double[] at = new double[c.size()];
    at[coordinate] = step;
    return centre.plus(List.of(c.effect(at, 0)));
  }

  private static int freeCount(FittedModel model) {
    return (int) model.model().globals().stream().filter(p -> p.estimated()).count();
  }

  /** The equations with the model's own parameters swept in, to which components can be added one by one. */
  Sweep sweep() {
    return sweep.copy();
  }

  /** The equations at the point where some components of the model are absent, without their columns. */
  Sweep without(Collection<Integer> components) {
    double[] removed = new double[system.size()];
    boolean[] out = new boolean[system.size()];
    double[] values = model.solution().values();
    for (int component : components) {
      int from = model.model().offset(component);
      for (int column : modelColumns(component)) {
        out[column] = true;
      }
      for (int j = 0; j < model.model().components().get(component).size(); j++) {
        removed[model.model().freeIndex(from + j)] = values[from + j];
      }
    }
    Sweep moved = new Sweep(system, precisions, removed);
    for (int i = 0; i < system.base(); i++) {
      if (!out[i]) {
        moved.toggle(i);
      }
    }
    return moved;
  }

  /** Columns of a component of the model. */
  int[] modelColumns(int component) {
    int from = model.model().offset(component);
    int[] columns = new int[model.model().components().get(component).size()];
    for (int j = 0; j < columns.length; j++) {
      columns[j] = model.model().freeIndex(from + j);
    }
    return columns;
  }

  /** All columns of a proposal. */
  int[] columns(Proposal p) {
    return p.components().stream().flatMapToInt(c -> Arrays.stream(columns.get(c))).toArray();
  }

  /** A component with the numbers that it would have beside what is swept in. */
  Component estimated(Component c, Sweep at) {
    Sweep with = at.copy();
    int[] of = columns(c);
    for (int column : of) {
      with.toggle(column);
    }
    double[] values = new double[of.length];
    for (int i = 0; i < of.length; i++) {
      double v = with.contains(of[i]) ? with.estimate(of[i]) : 0;
      values[i] = c.coordinates().get(i).clamp(v);
    }
    return c.startingAt(c.effect(values, 0));
  }

  int[] columns(Component c) {
    return columns.get(c);
  }

  /** What a proposal would gain beside what is swept in, including its values for each kick. */
  double gain(Proposal p, Sweep at) {
    int[] of = columns(p);
    Component first = p.components().get(0);
    double gain;
    if (of.length == 1) {
      // Drag that accelerates the ball would explain much and cannot be.
      Parameter coordinate = first.coordinates().get(0);
      gain = at.gain(of[0], coordinate.min(), coordinate.max());
    } else {
      gain = at.gain(of);
    }
    return first.isPerKick()
        ? gain + randomGain(columns(first)[0], first, at)
        : gain + gainOfScatters(gain);
  }

  /** What components of one coordinate each would gain beside what is swept in if all had the same number. */
  double gainTogether(List<Component> parts, Sweep at) {
    int[] of = parts.stream().mapToInt(c -> columns.get(c)[0]).toArray();
    double alone = 0;
    for (int i : of) {
      for (int j : of) {
        alone += system.curvature(i, j);
      }
    }
    // The number is one, and so is its prior.
    double repeated = (of.length - 1) * precisions[of[0]];
    Parameter coordinate = parts.get(0).coordinates().get(0);
    double gain = at.gainTogether(of, alone, repeated, coordinate.min(), coordinate.max());
    return gain + gainOfScatters(gain);
  }

  /**
   * What is gained in addition because values that differ from kick to kick differ less beside a proposal that explains a part of them: the equations hold their scatter, which then falls. A share s of the squares of n values is worth n·s while the scatter is held, and
   * −n·ln(1 − s) once it is estimated again.
   */
  private double gainOfScatters(double gain) {
    int n = system.kicks();
    if (model.model().random().isEmpty() || !(gain > 0)) {
      return 0;
    }
    double share = Math.min(MOST_SHARE, gain / n);
    return n * (-Math.log1p(-share) - share);
  }

  /** What the values for each kick gain when the mean and everything swept in have been fitted again. */
  private double randomGain(int column, Component c, Sweep at) {
    Sweep with = at.copy();
    with.toggle(column);
    double[] information = new double[system.kicks()];
    double[] slope = new double[system.kicks()];
    for (int k = 0; k < slope.length; k++) {
      information[k] = system.curvature(k, column, column);
      slope[k] = system.slope(k, column);
      for (int j = 0; j < system.size(); j++) {
        if (with.contains(j)) {
          slope[k] -= system.curvature(k, column, j) * with.estimate(j);
        }
      }
    }
    double best = Double.NEGATIVE_INFINITY;
    for (double share : SCATTERS) {
      double scatter = share * c.coordinates().get(0).scale();
      double gain = 0;
      for (int k = 0; k < slope.length; k++) {
        gain += slope[k] * slope[k] / (information[k] + 1 / (scatter * scatter));
        gain -= Math.log1p(information[k] * scatter * scatter);
      }
      best = Math.max(best, gain);
    }
    return best;
  }
}
