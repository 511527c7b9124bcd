package fieldcal.calibration;

import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ObservedCamera;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * Calibrates the simple parameters under a model with given effects, by deferred correction: each detection is moved by what the simple model predicts at the fitted unknowns minus what
 * the extended model predicts there, and everything is calibrated again, until the detections rest. Then the simple model explains the corrected detections as the extended one explains the
 * true ones, and every rule of the calibration (selection, averages, joint fit) holds unchanged. Immutable and thread-safe.
 */
public final class ExtendedCalibrator {
  /** Detections that move less than that are settled: a fourteenth of the noise of good cameras, m. */
  private static final double SETTLED = 5e-5;

  private static final int MAX_ROUNDS = 8;

  private final Calibrator calibrator;
  private final ExtendedModel model;
  private final EffectCorrection correction;

  /**
   * A calibrator.
   *
   * @param calibrator of the corrected kicks
   * @param model whose effects are taken out, with the session's begin on the clock of the kicks; its simple parameters play no part
   * @param cameras as published, one for every camera that saw a kick
   */
  public ExtendedCalibrator(
      Calibrator calibrator, ExtendedModel model, Collection<ObservedCamera> cameras) {
    this.calibrator = Objects.requireNonNull(calibrator, "calibrator");
    this.model = Objects.requireNonNull(model, "model");
    correction = new EffectCorrection(model, cameras);
  }

  /**
   * Calibrates.
   *
   * @param problem kicks, cameras, start
   * @param progress told about every kick when it is first fitted, from any thread
   * @return the calibration; without kicks one that is empty
   */
  public ExtendedCalibration calibrate(CalibrationProblem problem, Consumer<Kick> progress) {
    List<Kick> kicks = problem.kicks();
    List<Kick> corrected = kicks;
    Calibration calibration = calibrator.calibrate(problem, progress);
    int rounds = 0;
    double move = Double.POSITIVE_INFINITY;
    while (move > SETTLED && rounds < MAX_ROUNDS) {
      List<CalibratedKick> fitted = calibration.kicks();
      List<Kick> next =
          IntStream.range(0, kicks.size())
              .parallel()
              .mapToObj(i -> correction.of(kicks.get(i), fitted.get(i).fit()))
              .toList();
      move = 0;
      for (int i = 0; i < kicks.size(); i++) {
        if (fitted.get(i).trusted()) {
          move = Math.max(move, moved(corrected.get(i), next.get(i)));
        }
      }
      corrected = next;
      calibration = calibrator.calibrate(problem.withKicks(next), kick -> {});
      rounds++;
    }
    return new ExtendedCalibration(calibration, model, rounds, 1000 * move, move <= SETTLED);
  }

  /** Root mean square over the detections of one kick. */
  private static double moved(Kick from, Kick to) {
    Observations a = from.observations();
    Observations b = to.observations();
    double sum = 0;
    for (int i = 0; i < a.size(); i++) {
      double dx = b.x(i) - a.x(i);
      double dy = b.y(i) - a.y(i);
      sum += dx * dx + dy * dy;
    }
    return a.size() == 0 ? 0 : Math.sqrt(sum / a.size());
  }
}
