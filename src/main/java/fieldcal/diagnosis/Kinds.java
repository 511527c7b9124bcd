package fieldcal.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
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

  /** By how much less a chip must lose per observation than a flat kick, as a share, to take its place. */
  private static final double LESS = 0.97;

  /** A flat kick that loses hardly more with what is typical of flat kicks than with parameters of its own is one. */
  private static final double LIKE_THE_OTHERS = 1.3;

  /** What kickers that chip give a ball at least, as rise over run; a flat kick that is fitted as a chip needs less. */
  private static final double STEEP = 0.5;

  private static final int ROUNDS = 2;

  private Kinds() {}

  /**
   * Kicks fitted on their own, each compared with what is typical of the others: both models with their parameters held at the medians of the recording, so that no strange model can excuse a wrong
   * kind.
   */
  static List<KickFit> beside(List<KickFit> fits, CameraViews cameras, FitSettings settings) {
    List<KickFit> all = fits;
    for (int round = 0; round < ROUNDS; round++) {
      List<KickFit> before = all;
      FlatModel flat = flat(before);
      ChipModel chip = chip(before, flat);
      boolean flats = before.stream().anyMatch(f -> f.kind() == KickKind.FLAT);
      boolean chips = before.stream().anyMatch(f -> f.kind() == KickKind.CHIP);
      KickFitter fitter = new KickFitter(settings);
      all =
          before.parallelStream()
              .map(
                  fit -> {
                    FitProblem free = FitProblem.of(fit.kick(), cameras, flat, chip);
                    FitProblem held =
                        new FitProblem(
                            fit.kick(),
                            cameras,
                            flats ? fixed(free.flat()) : free.flat(),
                            chips ? fixed(free.chip()) : free.chip());
                    return better(fitter, fit, free, held, chips);
                  })
              .toList();
      if (all.equals(before)) {
        break;
      }
    }
    return all;
  }

  private static KickFit better(
      KickFitter fitter, KickFit fit, FitProblem free, FitProblem held, boolean chips) {
    if (fit.kind() == KickKind.FLAT) {
      KickFit same = fitter.fit(held, KickKind.FLAT);
      if (same.failure().isEmpty()
          && same.statistics().meanLoss() < LIKE_THE_OTHERS * fit.statistics().meanLoss()) {
        return fit;
      }
    }
    KickFit chip = fitter.fit(held, KickKind.CHIP);
    if (chip.failure().isPresent()) {
      return fit;
    }
    boolean toChip = fit.kind() == KickKind.FLAT;
    if (isSteep(chip) != toChip) {
      return fit;
    }
    KickFit flat = fitter.fit(held, KickKind.FLAT);
    double asChip = chip.statistics().meanLoss();
    double asFlat =
        flat.failure().isPresent() ? Double.POSITIVE_INFINITY : flat.statistics().meanLoss();
    // Without other chips a chip's model is free, and must beat a flat kick's that is free, too.
    double limit = chips ? LESS * asFlat : BETTER * fit.statistics().meanLoss();
    if (toChip ? asChip >= limit : asFlat >= asChip) {
      return fit;
    }
    KickFit changed = fitter.fit(free, toChip ? KickKind.CHIP : KickKind.FLAT);
    // With parameters of its own, a flat kick that spins is a chip of many low hops.
    boolean possible = changed.failure().isEmpty() && (!toChip || isSteep(changed));
    return possible ? changed : fit;
  }

  private static boolean isSteep(KickFit chip) {
    double run = Math.hypot(chip.estimate("vx").value(), chip.estimate("vy").value());
    return chip.estimate("vz").value() > STEEP * run;
  }

  private static List<Parameter> fixed(List<Parameter> parameters) {
    return parameters.stream().map(Parameter::fixed).toList();
  }

  /** What is typical of the recording's flat kicks; typical of the league without any. */
  static FlatModel flat(List<KickFit> fits) {
    FlatModel typical = FlatModel.typical();
    return new FlatModel(
        median(fits, KickKind.FLAT, "accSlide", typical.accSlide()),
        median(fits, KickKind.FLAT, "accRoll", typical.accRoll()),
        median(fits, KickKind.FLAT, "kSwitch", typical.kSwitch()));
  }

  /** What is typical of the recording's chips, which roll as its flat kicks do. */
  static ChipModel chip(List<KickFit> fits, FlatModel flat) {
    ChipModel typical = ChipModel.typical();
    boolean flats = fits.stream().anyMatch(f -> f.kind() == KickKind.FLAT);
    return new ChipModel(
        median(fits, KickKind.CHIP, "dampingXyFirstHop", typical.dampingXyFirstHop()),
        median(fits, KickKind.CHIP, "dampingXyOtherHops", typical.dampingXyOtherHops()),
        median(fits, KickKind.CHIP, "dampingZ", typical.dampingZ()),
        flats ? flat.accRoll() : median(fits, KickKind.CHIP, "accRoll", typical.accRoll()));
  }

  private static double median(List<KickFit> fits, KickKind kind, String name, double otherwise) {
    double[] sorted =
        fits.stream()
            .filter(f -> f.kind() == kind)
            .map(f -> f.estimate(name))
            .filter(Estimate::usable)
            .mapToDouble(Estimate::value)
            .sorted()
            .toArray();
    return sorted.length == 0 ? otherwise : sorted[sorted.length / 2];
  }

  /** The kicks under a joint fit, some of them as the other kind; the same list when none changes. */
  static List<KickData> settle(
      HypothesisFitter fitter,
      FittedHypothesis at,
      NoiseCalibration noise,
      CameraViews cameras,
      FlatModel flat,
      ChipModel chip) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), fitter.observers);
    int random = at.hypothesis().random().size();
    double[] means =
        Arrays.copyOfRange(at.shared(), at.shared().length - random, at.shared().length);
    KickFitter kickFitter = new KickFitter(FitSettings.defaults());
    KickData[] settled = fitter.kicks.toArray(KickData[]::new);
    IntStream.range(0, settled.length)
        .parallel()
        .forEach(
            k -> {
              KickData data = settled[k];
              KickKind other = data.kind == KickKind.FLAT ? KickKind.CHIP : KickKind.FLAT;
              double now = cost(fitter, at, state, k);
              boolean judged = fitter.kicks.stream().filter(d -> d.kind == other).count() >= FEWEST;
              if (!judged || now < FITS) {
                return;
              }
              KickFit fit = kickFitter.fit(FitProblem.of(data.kick, cameras, flat, chip), other);
              if (fit.failure().isPresent()) {
                return;
              }
              KickData changed = new KickData(fit, noise.cameras(), noise.stampNoise());
              KickModel model = new KickModel(changed, random, fitter.sessionStart);
              model.startFrom(changed.start, changed.flights, means);
              OwnFit own = new OwnFit(model, state, at.scatter());
              double cost = own.minimize();
              if (other == KickKind.CHIP && own.chooseFlights()) {
                cost = own.minimize();
              }
              double run = Math.hypot(model.own[2], model.own[3]);
              boolean flies = other == KickKind.FLAT || model.own[4] > STEEP * run;
              if (flies && cost / (2.0 * changed.usedCount) < BETTER * now) {
                settled[k] = changed;
              }
            });
    List<KickData> all = new ArrayList<>(List.of(settled));
    return all.equals(fitter.kicks) ? fitter.kicks : all;
  }

  private static double cost(
      HypothesisFitter fitter, FittedHypothesis at, SharedState state, int k) {
    KickData data = fitter.kicks.get(k);
    KickModel model = new KickModel(data, at.hypothesis().random().size(), fitter.sessionStart);
    model.startFrom(at.own().get(k), at.flights()[k], new double[0]);
    double[] r = new double[2 * data.size];
    return model.residuals(state, model.path(state, model.own), r) / (2.0 * data.usedCount);
  }
}
