package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.Decision;
import fieldcal.diagnosis.decision.Dependence;
import fieldcal.diagnosis.decision.Dependence.Form;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.learned.LearnedFamily;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Spline;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Replaces values that differ from kick to kick by a law, if they follow something. Beside a value for each kick a curve has nothing left to explain, so a search that has found the values does not find their law.
 * The values show the form of the law: how many functions it needs, or where a step is. Immutable.
 */
final class LawForValues {
  /** How many more knots than functions of a polynomial a curve may have: a centred spline has one function fewer than knots, and does not bend as a polynomial does. */
  private static final int[] MORE_KNOTS = {2, 4};

  /** Kicks for each knot of a curve, at least. */
  private static final int KICKS_PER_KNOT = 2;

  private final ModelFitter fitter;
  private final Decision decision;
  private final Arena arena;
  private final List<? extends Effect> catalogue;
  private final SharedSolver solver;
  private final long seed;

  /**
   * @param fitter of the kicks
   * @param decision which finds what values follow
   * @param arena what was recorded
   * @param catalogue of effects with names
   * @param solver of the fits
   * @param seed of the parts of the kicks that are held out
   */
  LawForValues(
      ModelFitter fitter,
      Decision decision,
      Arena arena,
      List<? extends Effect> catalogue,
      SharedSolver solver,
      long seed) {
    this.fitter = fitter;
    this.decision = decision;
    this.arena = arena;
    this.catalogue = catalogue;
    this.solver = solver;
    this.seed = seed;
  }

  /** The model with one law each, for every kind of value that follows something beside this model: the law that follows held-out kicks best. */
  List<FittedModel> beside(FittedModel model) {
    List<FittedModel> all = new ArrayList<>();
    List<Effect> values = new ArrayList<>(EffectCatalogue.unnamed());
    // What kickers do differs from kick to kick, too. Where it follows the kick, a law describes
    // it.
    catalogue.stream().filter(Effect::differsFromKickToKick).forEach(values::add);
    for (Effect effect : values) {
      if (!effect.canShowIn(arena)) {
        continue;
      }
      FittedModel with = with(model, Component.perKick(effect));
      Optional<Dependence> follows = decision.follows(with, with.model().components().size() - 1);
      follows.flatMap(d -> law(model, effect, d)).ifPresent(all::add);
    }
    return all;
  }

  /** Models in which a law takes the place of the values of components that follow the same quantity: the law alone, and the law with the values beside it. */
  Stream<FittedModel> insteadOf(FittedModel model, List<Integer> components, Dependence follows) {
    List<Component> rest = new ArrayList<>(model.started());
    List<Component> values = components.stream().map(rest::get).toList();
    rest.removeAll(values);
    FittedModel without = fit(model, rest);
    return law(without, values.get(0).template(), follows).stream()
        .flatMap(law -> Stream.of(law, withAll(law, values)));
  }

  /** A model without what differs by chance, and without effects that change the ground with time: each of these may be a piece of a law over time. */
  FittedModel withoutValues(FittedModel from) {
    List<Component> kept = new ArrayList<>(from.started());
    kept.removeIf(c -> !c.template().hasOwnMean() || changesGroundWithTime(c.template()));
    return fit(from, kept);
  }

  /** Whether an effect changes the ground in the course of the session. */
  static boolean changesGroundWithTime(Effect effect) {
    boolean ground = effect instanceof MotionEffect motion && !motion.actsOffTheGround();
    return ground && effect.changesWithTime();
  }

  private Optional<FittedModel> law(FittedModel model, Effect values, Dependence d) {
    Stream<Component> named =
        d.form() == Form.STEP
            ? catalogue.stream().filter(e -> e.canShowIn(arena)).flatMap(e -> steps(e, d))
            : Stream.of();
    String where = LearnedFindings.actsOn(values);
    List<FittedModel> fits = new ArrayList<>();
    named.forEach(c -> fits.add(with(model, c)));
    List<LearnedTerm> terms =
        Stream.concat(LearnedLibrary.of(arena).stream(), LearnedLibrary.ofRolling(arena).stream())
            .filter(t -> canStandFor(where, t) && t.family().variables().equals(List.of(d.on())))
            .toList();
    List<FittedModel> curves = terms.stream().map(t -> with(model, component(t))).toList();
    fits.addAll(curves);
    best(curves)
        .map(curves::indexOf)
        .ifPresent(i -> finer(terms.get(i), d).forEach(t -> fits.add(with(model, component(t)))));
    return best(fits);
  }

  /** Whether a term acts where the values act. Values that act at the kick may also be due to the carpet under a sliding ball. */
  private static boolean canStandFor(String where, LearnedTerm term) {
    return term.actsOn().equals(where) || where.equals("kick") && term.actsOn().equals("ground");
  }

  /** Forms of an effect that begins at an instant of the session, with the instant of the step. */
  private static Stream<Component> steps(Effect effect, Dependence d) {
    if (!(effect instanceof MotionEffect) || effect.places().size() != 1) {
      return Stream.of();
    }
    Effect at = effect.with(effect.places().get(0), d.place());
    return effect.choices().stream().map(c -> Component.of(at, c)).filter(Component::isInstant);
  }

  /** The same curve with as many knots as the values need. */
  private Stream<LearnedTerm> finer(LearnedTerm term, Dependence d) {
    if (!(term.family().basis() instanceof Spline s)) {
      return Stream.of();
    }
    int most = fitter.kicks().size() / KICKS_PER_KNOT;
    List<LearnedTerm> all = new ArrayList<>();
    for (int more : MORE_KNOTS) {
      int knots = d.functions() + more;
      if (knots > s.knots() && knots <= most) {
        Spline finer = new Spline(s.from(), s.to(), knots, s.centred());
        LearnedFamily family = term.family();
        all.add(
            new LearnedFamily(family.quantity(), family.variables(), finer, family.camera())
                .absent());
      }
    }
    return all.stream();
  }

  private static Component component(Effect effect) {
    return Component.of(effect, effect.magnitudes());
  }

  private FittedModel with(FittedModel model, Component added) {
    return withAll(model, List.of(added));
  }

  /** The model with more components; components of the same causes are replaced. */
  private FittedModel withAll(FittedModel model, List<Component> added) {
    List<Component> all = new ArrayList<>(model.started());
    all.removeIf(c -> added.stream().anyMatch(c::isSameCause));
    all.addAll(added);
    return fit(model, all);
  }

  private FittedModel fit(FittedModel from, List<Component> components) {
    return fitter.fit(from.resumedWith(components), from, Weighing.ALIKE, solver);
  }

  private Optional<FittedModel> best(List<FittedModel> fits) {
    return fits.stream().min(Comparator.comparingDouble(f -> HoldOut.of(f, false, seed).rmsMm()));
  }

  /** Whether values that differ by chance explain all that a model leaves: curves would then describe chance. */
  boolean leavesChance(FittedModel model) {
    return EffectCatalogue.unnamed().stream()
        .filter(e -> e.canShowIn(arena))
        .anyMatch(e -> !Leftover.of(with(model, Component.perKick(e))).isSignificant());
  }
}
