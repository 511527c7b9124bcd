package fieldcal.diagnosis;

import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.Effort;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.MovingNoise;
import fieldcal.diagnosis.screening.KickScreen;
import fieldcal.effect.Effect;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.Screening;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** The first two stages: the kicks that can be used, and the simple model fitted to all of them. */
final class BaseFit {
  /** Rounds in which the kind of kicks is corrected before the search: each may show others. */
  private static final int ROUNDS = 4;

  private BaseFit() {}

  /**
   * Screens and fits.
   *
   * @param problem with at least one fit
   * @param catalogue effects that may be named
   * @param solver of all fits
   * @param effort to which all paths are added
   * @param watcher receives every fit
   * @return the case
   * @throws IllegalArgumentException when no kick has enough detections
   */
  static DiagnosisCase of(
      DiagnosisProblem problem,
      List<? extends Effect> catalogue,
      SharedSolver solver,
      Effort effort,
      Consumer<FittedModel> watcher) {
    List<KickFit> fits = problem.fits();
    List<boolean[]> kept = fits.stream().map(f -> Screening.kept(f, problem.cameras())).toList();
    MovingNoise noise = MovingNoise.of(fits, kept, problem.cameras());
    List<KickRecord> kicks = usable(fits, noise);
    EffectModel simple = DiagnosisCase.simple(problem, kicks);
    FitSettings single = FitSettings.defaults().withSeed(problem.seed());
    KickScreen screen = new KickScreen(noise, simple, problem.sessionStart(), single);
    ModelFitter fitter = new ModelFitter(kicks, problem.sessionStart(), effort, watcher);
    DiagnosisCase at =
        new DiagnosisCase(
            problem,
            catalogue,
            DecisionSettings.defaults(),
            solver,
            screen,
            fitter,
            DiagnosisCase.arena(problem, kicks),
            fitter.fit(simple, solver));
    for (int round = 0; round < ROUNDS; round++) {
      List<KickRecord> revised = screen.revise(at.base(), false);
      if (revised.equals(at.fitter().kicks())) {
        break;
      }
      at = at.refitted(revised);
    }
    return at;
  }

  private static List<KickRecord> usable(List<KickFit> fits, MovingNoise noise) {
    List<KickRecord> kicks = new ArrayList<>();
    for (KickFit fit : fits) {
      KickRecord record = KickScreen.record(fit, noise);
      if (record.usedCount() > 2 * record.start().length) {
        kicks.add(record);
      }
    }
    if (kicks.isEmpty()) {
      throw new IllegalArgumentException("no kick has enough detections for a diagnosis");
    }
    return kicks;
  }
}
