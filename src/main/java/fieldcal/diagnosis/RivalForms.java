package fieldcal.diagnosis;

import fieldcal.diagnosis.ModelChoice.Weighed;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.search.Alternatives.Scored;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.Price;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The stage that lets a law of another form compete with each named cause that all kicks share. A rolling deceleration that grows with the square of the speed is nearly an air drag: only a ball that slides, which the air brakes and the carpet's pile does not, tells them apart, and noise hides what the wrong one leaves. So each cause is
 * compared with the short curves that act where it acts. Not thread-safe.
 */
final class RivalForms {
  private final ModelFitter fitter;
  private final SharedSolver solver;
  private final DecisionSettings settings;
  private final long seed;
  private final ModelChoice choice;
  private final List<LearnedTerm> forms;
  private final Arena arena;

  /**
   * @param problem the screened kicks and what may explain them
   * @param choice which of the components that are found stay
   */
  RivalForms(DiagnosisCase problem, ModelChoice choice) {
    this.choice = choice;
    fitter = problem.fitter();
    solver = problem.solver();
    settings = problem.settings();
    seed = problem.seed();
    arena = problem.arena();
    forms = LearnedLibrary.forms(arena);
  }

  /**
   * Compares.
   *
   * @param found what was decided
   * @return the same where each cause stands; otherwise with curves in the place of those that do not
   */
  Weighed against(Weighed found) {
    Weighed best = found;
    for (Judgement j : found.judged()) {
      boolean shared = !j.component().isPerKick() && !j.component().isLaw();
      boolean placed = j.component().hasPlace();
      if (j.isName() && shared && !placed) {
        // A curve that took the place of one cause changes the judgements of the others.
        int at = best.judged().stream().map(Judgement::component).toList().indexOf(j.component());
        best = at < 0 ? best : against(best, at);
      }
    }
    return best;
  }

  private Weighed against(Weighed named, int i) {
    Component cause = named.judged().get(i).component();
    List<LearnedTerm> alike = forms.stream().filter(form -> actAlike(form, cause)).toList();
    if (alike.isEmpty()) {
      return named;
    }
    Optional<FittedModel> rival =
        new Alternatives(fitter, new Dictionary(alike, arena))
            .scores(named.model()).stream()
                .filter(s -> s.gain() > dearer(named.model(), i, s.effect()))
                .flatMap(s -> insteadOf(named.model(), i, s).stream())
                .min(Comparator.comparingDouble(Price::total));
    if (rival.isEmpty()) {
      return named;
    }
    Weighed other = choice.of(rival.get());
    return other.mayReplace(named, settings.formGain(), seed) ? other : named;
  }

  /** Whether both change how the ball moves, or what the same camera reports. */
  private static boolean actAlike(LearnedTerm form, Component cause) {
    return form instanceof MotionEffect
        ? cause.template() instanceof MotionEffect
        : form.camera().equals(cause.camera());
  }

  /** How much more a curve costs than a cause. In the cause's stead it gains at most what it gains beside it. */
  private static double dearer(FittedModel model, int i, Effect curve) {
    return Price.of(List.of(whole(curve))) - Price.of(List.of(model.model().components().get(i)));
  }

  /** A model with the curve in the cause's stead, if this explains more than the cause does, and if the cause explains no more beside the curve than noise may. */
  private Optional<FittedModel> insteadOf(FittedModel model, int i, Scored curve) {
    List<Component> both = model.started();
    both.add(whole(curve.effect()));
    List<Component> other = new ArrayList<>(both);
    Component cause = other.remove(i);
    FittedModel instead = fitter.fit(model.resumedWith(other), model, Weighing.ALIKE, solver);
    if (!(Price.total(instead) < Price.total(model))) {
      return Optional.empty();
    }
    FittedModel beside = fitter.fit(model.resumedWith(both), model, Weighing.ALIKE, solver);
    double noise = Math.max(1, beside.solution().reducedChiSquare());
    double needed = (instead.evenCost() - beside.evenCost()) / noise;
    return needed < settings.beyondNoise(cause.magnitudeCount())
        ? Optional.of(instead)
        : Optional.empty();
  }

  private static Component whole(Effect curve) {
    return Component.of(curve, curve.magnitudes());
  }
}
