package fieldcal.app.twin;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Fits of a twin's kicks with what the fits of the recording took for the noise and the offset of each camera. Where the simple model does not explain a kick, the weights and offsets decide whose residuals are large. Both are estimated from
 * all kicks together: a camera's noise that came out 7 % larger made the residuals of every kick differ by 7 %, the same way, which a test of kick against kick takes for a difference of the fields. Offsets that the twin does have
 * otherwise show in its residuals.
 */
final class AlikeFits {
  private AlikeFits() {}

  /**
   * Fits again, from where the fits ended.
   *
   * @param fits of the twin's kicks
   * @param twin cameras with which they were made
   * @param recorded cameras of the recording, with their noise and offsets
   * @return in the same order; one that cannot be fitted again stays as it is
   */
  static List<KickFit> of(List<KickFit> fits, CameraViews twin, CameraViews recorded) {
    Map<Integer, CameraView> known =
        recorded.all().stream().collect(Collectors.toMap(CameraView::id, v -> v));
    CameraViews views = twin.map(v -> like(v, known.getOrDefault(v.id(), v)));
    return fits.parallelStream().map(fit -> again(fit, views)).toList();
  }

  private static CameraView like(CameraView view, CameraView other) {
    return view.withNoise(other.noise()).withOffset(other.offsetX(), other.offsetY());
  }

  private static KickFit again(KickFit fit, CameraViews views) {
    List<Parameter> model = fit.modelEstimates().stream().map(Estimate::parameter).toList();
    FitProblem usual = FitProblem.of(fit.kick(), views, FlatModel.typical(), ChipModel.typical());
    FitProblem problem =
        fit.kind() == KickKind.CHIP
            ? new FitProblem(fit.kick(), views, usual.flat(), model)
            : new FitProblem(fit.kick(), views, model, usual.chip());
    // The seed of searches; a fit that begins where another one ended makes none.
    KickFit again =
        new KickFitter(FitSettings.defaults().withSeed(fit.statistics().seed()))
            .refit(problem, fit);
    return again.failure().isPresent() ? fit : again;
  }
}
