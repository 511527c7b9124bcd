package fieldcal.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Puts kicks right that were taken for the other kind. On its own a low chip, or one that is soon out of sight, may be fitted as a flat kick with a strange model; beside the other
 * kicks, which share one model, it shows what it is.
 */
final class Kinds {
  /** A kick that fits better than that, in variances of noise, is not questioned. */
  private static final double FITS = 2;

  /** The other kind must fit that many times better. */
  private static final double BETTER = 0.5;

  /** A model that fewer kicks determine judges no others. */
  private static final int FEWEST = 3;

  private Kinds() {}

  /** The kicks, some of them as the other kind; the same list when none changes. */
  static List<KickData> settle(
      HypothesisFitter fitter,
      FittedHypothesis simple,
      NoiseCalibration noise,
      CameraViews cameras,
      FlatModel flat,
      ChipModel chip) {
    SharedState state = SharedState.of(simple.hypothesis(), simple.shared(), fitter.observers);
    KickFitter kickFitter = new KickFitter(FitSettings.defaults());
    KickData[] settled = fitter.kicks.toArray(KickData[]::new);
    IntStream.range(0, settled.length)
        .parallel()
        .forEach(
            k -> {
              KickData data = settled[k];
              KickKind other = data.kind == KickKind.FLAT ? KickKind.CHIP : KickKind.FLAT;
              double now = cost(fitter, simple, state, k);
              boolean judged = fitter.kicks.stream().filter(d -> d.kind == other).count() >= FEWEST;
              if (!judged || now < FITS) {
                return;
              }
              KickFit fit = kickFitter.fit(FitProblem.of(data.kick, cameras, flat, chip), other);
              if (fit.failure().isPresent()) {
                return;
              }
              KickData changed = new KickData(fit, noise.cameras(), noise.stampNoise());
              KickModel model = new KickModel(changed, 0, fitter.sessionStart);
              OwnFit own = new OwnFit(model, state, new double[0]);
              double cost = own.minimize();
              if (other == KickKind.CHIP && own.chooseFlights()) {
                cost = own.minimize();
              }
              if (cost / (2.0 * changed.usedCount) < BETTER * now) {
                settled[k] = changed;
              }
            });
    List<KickData> all = new ArrayList<>(List.of(settled));
    return all.equals(fitter.kicks) ? fitter.kicks : all;
  }

  private static double cost(
      HypothesisFitter fitter, FittedHypothesis at, SharedState state, int k) {
    KickData data = fitter.kicks.get(k);
    KickModel model = new KickModel(data, 0, fitter.sessionStart);
    model.startFrom(at.own().get(k), at.flights()[k], new double[0]);
    double[] r = new double[2 * data.size];
    return model.residuals(state, model.path(state, model.own), r) / (2.0 * data.usedCount);
  }
}
