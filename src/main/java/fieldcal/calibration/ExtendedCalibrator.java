package fieldcal.calibration;

import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * Calibrates the simple parameters under a model with given effects, by deferred correction: each detection is moved by what the simple model predicts at the fitted unknowns minus what
 * the extended model predicts there, and everything is calibrated again, until the detections no longer move. Then the simple model explains the corrected detections as the extended one explains the
 * true ones, and every rule of the calibration (selection, averages, joint fit) holds unchanged. Immutable and thread-safe.
 */
public final class ExtendedCalibrator {
  /** Detections that move less than this are settled: a fourteenth of the noise of good cameras, m. */
  private static final double SETTLED = 5e-5;

  private static final int MAX_ROUNDS = 4;

  private final Calibrator calibrator;
  private final KickFitter fitter;
  private final ExtendedModel model;
  private final EffectCorrection correction;

  /**
   * A calibrator.
   *
   * @param settings of the fits, with the seed
   * @param model whose effects are taken out, with the start of the session on the clock of the kicks; its simple parameters are where the first round begins
   * @param cameras as published, one for every camera that saw a kick
   */
  public ExtendedCalibrator(
      FitSettings settings, ExtendedModel model, Collection<ObservedCamera> cameras) {
    calibrator = new Calibrator(settings);
    fitter = new KickFitter(settings);
    this.model = Objects.requireNonNull(model, "model");
    correction = new EffectCorrection(model, cameras);
  }

  /**
   * Calibrates.
   *
   * @param problem kicks, cameras, start
   * @param progress called for every kick when it is first fitted, from any thread
   * @return the calibration; without kicks one that is empty
   */
  public ExtendedCalibration calibrate(CalibrationProblem problem, Consumer<Kick> progress) {
    List<CorrectedKick> kicks =
        problem.kicks().stream().map(kick -> new CorrectedKick(kick, correction)).toList();
    Calibration calibration = calibrator.calibrate(problem, progress);
    int rounds = 0;
    double move = Double.POSITIVE_INFINITY;
    while (move > SETTLED && rounds < MAX_ROUNDS) {
      move = correct(problem, kicks, calibration);
      calibration =
          calibrator.calibrate(
              problem.withKicks(kicks.stream().map(CorrectedKick::kick).toList()), kick -> {});
      rounds++;
    }
    return new ExtendedCalibration(calibration, model, rounds, 1000 * move, move <= SETTLED);
  }

  /** How far the detections of the kick that moves most have moved, m; kicks that are not trusted do not count. */
  private double correct(
      CalibrationProblem problem, List<CorrectedKick> kicks, Calibration calibration) {
    List<CalibratedKick> fitted = calibration.kicks();
    double[] moves =
        IntStream.range(0, kicks.size())
            .parallel()
            .mapToDouble(
                i ->
                    kicks
                        .get(i)
                        .correct(
                            fitted.get(i).fit(),
                            (kick, from) -> again(problem, calibration.cameras(), kick, from),
                            SETTLED))
            .toArray();
    return IntStream.range(0, moves.length)
        .filter(i -> fitted.get(i).trusted())
        .mapToDouble(i -> moves[i])
        .max()
        .orElse(0);
  }

  private KickFit again(CalibrationProblem problem, CameraViews views, Kick kick, KickFit from) {
    FitProblem one = FitProblem.of(kick, views, problem.flat(), problem.chip());
    if (from.kind() == KickKind.CHIP) {
      // The accRoll of the flat kicks stays.
      Estimate roll = from.estimate("accRoll");
      one = roll.parameter().estimated() ? one : one.withChipRollFixed(roll.value());
    }
    return fitter.refit(one, from);
  }
}
