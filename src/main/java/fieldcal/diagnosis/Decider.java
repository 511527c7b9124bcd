package fieldcal.diagnosis;

import fieldcal.diagnosis.ModelChoice.Weighed;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.effect.MotionEffect;
import java.util.List;

/** The stages that decide what stays of a model that was found, and what describes the rest. Not thread-safe. */
final class Decider {
  private final SampledSearch search;
  private final List<SearchStep> trace;
  private final FailedStages failed;
  private final DiagnosisProgress progress;

  /**
   * @param search for curves
   * @param trace to which simplifications are added
   * @param failed told of searches that fail
   * @param progress told in words what is being done
   */
  Decider(
      SampledSearch search,
      List<SearchStep> trace,
      FailedStages failed,
      DiagnosisProgress progress) {
    this.search = search;
    this.trace = trace;
    this.failed = failed;
    this.progress = progress;
  }

  /** Decides about a model that was found for these kicks; nothing stays that does not follow held-out kicks better than the simple model. */
  Decided decide(DiagnosisCase at, FittedModel found) {
    HoldOut heldBase = HoldOut.of(at.base(), true, at.seed());
    Weighed simple = new Weighed(at.base(), List.of(), heldBase);
    ModelChoice choice = new ModelChoice(at, heldBase, trace, progress::part);
    CurveSearch curves = new CurveSearch(at, search, failed);
    boolean none = found.model().components().isEmpty();
    Weighed named = none ? simple : choice.of(found);
    UnnamedTerms unnamed = new UnnamedTerms(at, choice, heldBase, curves, progress);
    Weighed shaped = new RivalForms(at, choice).against(named);
    CurveSearch coarse = CurveSearch.coarse(at, search, failed);
    Weighed best =
        new RivalCurves(at, choice, coarse, unnamed, progress).against(unnamed.beside(shaped));
    if (best.held().predictsWorseThan(heldBase, at.seed())) {
      // A law that is right does not predict worse from the beginning of a kick.
      best = best.nameless(j -> j.effect() instanceof MotionEffect);
    }
    boolean nothing = best.model().model().components().isEmpty();
    boolean worse = !(best.held().rmsMm() <= heldBase.rmsMm());
    return new Decided(at, at.base(), heldBase, nothing || worse ? simple : best);
  }
}
