package fieldcal.diagnosis.model;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.effect.Area;
import fieldcal.effect.Arena;
import fieldcal.effect.BallKnowledge;
import fieldcal.effect.Effect;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.joint.RandomEffect;
import fieldcal.fit.joint.SharedModel;
import fieldcal.fit.joint.SharedProblem.Prior;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The simple ball model with effects: the layout of its global parameters (those of the ball first, then those of each component), and the state that results from them. Immutable.
 */
public final class EffectModel implements SharedModel<ModelState> {
  /** Global parameters of the ball: three of flat kicks, three of bounces; chips roll as flat kicks do. */
  public static final int BALL = 6;

  /** Standard deviation of the weak prior of the ball's parameters, in their scales, so that a parameter that no kick shows stays where it is. */
  private static final double BALL_EXPECTED = 300;

  /** Smallest scatter, in scales of the magnitude; the next two are the first and the largest one. */
  private static final double SMALLEST_SCATTER = 0.02;

  private static final double FIRST_SCATTER = 1;
  private static final double LARGEST_SCATTER = 20;

  private final FlatModel flat;
  private final ChipModel chip;
  private final boolean flats;
  private final boolean chips;
  private final List<Component> components;
  private final double[] scatters;
  private final List<ObservedCamera> observers;
  private final List<Parameter> globals;

  private EffectModel(
      FlatModel flat,
      ChipModel chip,
      boolean flats,
      boolean chips,
      List<Component> components,
      double[] scatters,
      List<ObservedCamera> observers) {
    this.flat = flat;
    this.chip = chip;
    this.flats = flats;
    this.chips = chips;
    this.components = List.copyOf(components);
    this.scatters = scatters;
    this.observers = observers;
    globals = makeGlobals();
  }

  /**
   * The simple model.
   *
   * @param flat where flat kicks start
   * @param chip where chips start
   * @param flats whether there are flat kicks
   * @param chips whether there are chips
   * @param observers the cameras, as published
   * @return the model without effects
   */
  public static EffectModel simple(
      FlatModel flat,
      ChipModel chip,
      boolean flats,
      boolean chips,
      List<ObservedCamera> observers) {
    return new EffectModel(flat, chip, flats, chips, List.of(), new double[0], observers);
  }

  /**
   * The same with other effects.
   *
   * @param newComponents in any order
   * @return the changed copy
   */
  public EffectModel with(List<Component> newComponents) {
    return new EffectModel(flat, chip, flats, chips, newComponents, new double[0], observers);
  }

  /**
   * The same in another recording.
   *
   * @param arena what was recorded
   * @return the changed copy, with effects as they can show there
   */
  public EffectModel in(Arena arena) {
    List<Component> there = components.stream().map(c -> c.in(arena)).toList();
    return new EffectModel(flat, chip, arena.flats(), arena.chips(), there, scatters, observers);
  }

  /**
   * The same with another lowest hop; it has no effect where a law of impacts gives its own.
   *
   * @param height height of its apex, m, positive
   * @return the changed copy
   */
  public EffectModel withLowestHop(double height) {
    return new EffectModel(
        flat, chip.withLowestHop(height), flats, chips, components, scatters, observers);
  }

  /**
   * The same for other kinds of kicks.
   *
   * @param anyFlats whether there are flat kicks
   * @param anyChips whether there are chips
   * @return the changed copy
   */
  public EffectModel forKinds(boolean anyFlats, boolean anyChips) {
    return new EffectModel(flat, chip, anyFlats, anyChips, components, scatters, observers);
  }

  /**
   * The same model, starting from a solution of it.
   *
   * @param values global parameters of this layout
   * @param newScatters of its random effects
   * @return the changed copy
   */
  public EffectModel startingAt(double[] values, double[] newScatters) {
    List<Component> moved = new ArrayList<>();
    int k = BALL;
    for (Component c : components) {
      moved.add(c.startingAt(c.effect(values, k)));
      k += c.size();
    }
    return new EffectModel(
        flat(values), chip(values), flats, chips, moved, newScatters.clone(), observers);
  }

  /**
   * The effects.
   *
   * @return in the order of their parameters
   */
  public List<Component> components() {
    return components;
  }

  /**
   * The cameras.
   *
   * @return as published
   */
  public List<ObservedCamera> observers() {
    return observers;
  }

  /**
   * Effects whose magnitude differs from kick to kick.
   *
   * @return in the order of the kicks' own parameters
   */
  public List<Component> random() {
    return components.stream().filter(Component::isPerKick).toList();
  }

  /**
   * Where a parameter stands among those that are estimated: its column in the equations.
   *
   * @param global index of the parameter
   * @return how many before it are estimated
   */
  public int freeIndex(int global) {
    return (int) globals().subList(0, global).stream().filter(Parameter::estimated).count();
  }

  /**
   * Index of a component's first global parameter.
   *
   * @param component which
   * @return index
   */
  public int offset(int component) {
    int k = BALL;
    for (int i = 0; i < component; i++) {
      k += components.get(i).size();
    }
    return k;
  }

  /**
   * The global parameters, with values to start from.
   *
   * @return ball first
   */
  public List<Parameter> globals() {
    return globals;
  }

  private List<Parameter> makeGlobals() {
    List<Parameter> all = new ArrayList<>();
    List<Parameter> ofFlat = flat.parameters();
    for (Parameter p : ofFlat) {
      boolean used = flats || chips && p.name().equals("accRoll");
      all.add(used ? p.withValue(p.clamp(p.value())).free() : p.fixed());
    }
    for (Parameter p : chip.parameters().subList(0, BALL - ofFlat.size())) {
      all.add(chips ? p.withValue(p.clamp(p.value())).free() : p.fixed());
    }
    components.forEach(c -> all.addAll(c.coordinates()));
    return List.copyOf(all);
  }

  /**
   * What is known of the global parameters before any data.
   *
   * @return one prior for each
   */
  public List<Prior> priors() {
    List<Prior> all = new ArrayList<>();
    for (Parameter p : globals().subList(0, BALL)) {
      all.add(prior(p));
    }
    components.forEach(c -> all.addAll(c.priors()));
    return all;
  }

  private Prior prior(Parameter p) {
    for (Component c : components) {
      for (BallKnowledge known : c.template().ballKnowledge()) {
        if (known.parameter().equals(p.name())) {
          return new Prior(known.mean(), 1 / (known.deviation() * known.deviation()));
        }
      }
    }
    double deviation = BALL_EXPECTED * p.scale();
    return new Prior(p.value(), 1 / (deviation * deviation));
  }

  /**
   * The random effects.
   *
   * @return in the order of {@link #random()}
   */
  public List<RandomEffect> randoms() {
    List<RandomEffect> all = new ArrayList<>();
    int k = BALL;
    for (Component c : components) {
      if (c.isPerKick()) {
        double scale = c.coordinates().get(0).scale();
        double smallest = SMALLEST_SCATTER * scale;
        double start = all.size() < scatters.length ? scatters[all.size()] : FIRST_SCATTER * scale;
        double largest = LARGEST_SCATTER * scale;
        all.add(
            new RandomEffect(k, Math.max(smallest, Math.min(largest, start)), smallest, largest));
      }
      k += c.size();
    }
    return all;
  }

  static FlatModel flat(double[] values) {
    return new FlatModel(values[0], values[1], values[2]);
  }

  private ChipModel chip(double[] values) {
    return chip.withParameters(values[3], values[4], values[5], values[1]);
  }

  @Override
  public ModelState at(double[] globals) {
    return ModelState.of(
        flat(globals), chip(globals), fixedEffects(globals), ownEffects(globals), observers);
  }

  @Override
  public ModelState stepped(ModelState here, double[] globals, int index, double step) {
    double[] moved = globals.clone();
    moved[index] += step;
    // Only the effect that changes is made again: one with many coefficients takes long to make.
    List<Effect> fixed = new ArrayList<>(here.fixed());
    Optional<Area> reach = Optional.empty();
    int k = BALL;
    int i = 0;
    for (Component c : components) {
      if (index >= k && index < k + c.size()) {
        reach = c.reach(globals, k, index - k);
        if (!c.isPerKick()) {
          fixed.set(i, c.effect(moved, k));
        }
      }
      k += c.size();
      i += c.isPerKick() ? 0 : 1;
    }
    ModelState state = here.changed(flat(moved), chip(moved), fixed, ownEffects(moved));
    return reach.map(state::differingIn).orElse(state);
  }

  private List<OwnEffect> ownEffects(double[] globals) {
    List<OwnEffect> effects = new ArrayList<>();
    int k = BALL;
    for (Component c : components) {
      if (c.isPerKick()) {
        effects.add(new OwnEffect(c, Arrays.copyOfRange(globals, k, k + c.size())));
      }
      k += c.size();
    }
    return effects;
  }

  private List<Effect> fixedEffects(double[] globals) {
    List<Effect> effects = new ArrayList<>();
    int k = BALL;
    for (Component c : components) {
      if (!c.isPerKick()) {
        effects.add(c.effect(globals, k));
      }
      k += c.size();
    }
    return effects;
  }

  /**
   * All effects at a point; those that differ from kick to kick at their means.
   *
   * @param globals values of the global parameters
   * @return in the order of the components
   */
  public List<Effect> effects(double[] globals) {
    List<Effect> effects = new ArrayList<>();
    int k = BALL;
    for (Component c : components) {
      effects.add(c.effect(globals, k));
      k += c.size();
    }
    return effects;
  }

  @Override
  public String toString() {
    return components.isEmpty() ? "simple model" : components.toString();
  }
}
