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
import java.util.List;

/**
 * Puts kicks right that were taken for the other kind. On its own a low chip, or one that is soon out of sight, may be fitted as a flat kick with a strange model; beside the other
 * kicks, which share one model, it shows what it is.
 */
final class Kinds {
  /** The other kind must fit that many times better. */
  static final double BETTER = 0.5;

  /** By how much less a chip must lose per observation than a flat kick, as a share, to take its place. */
  private static final double LESS = 0.97;

  /** A flat kick that loses hardly more with what is typical of flat kicks than with parameters of its own is one. */
  private static final double LIKE_THE_OTHERS = 1.3;

  /** What kickers that chip give a ball at least, as rise over run; a flat kick that is fitted as a chip needs less. */
  static final double STEEP = 0.5;

  /** A chip that rises like that with a model of its own is steep with the others' model, too (of 700 drawn ones all were), and is not questioned. */
  private static final double CLEARLY_STEEP = 0.7;

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
    } else if (rise(fit) > CLEARLY_STEEP) {
      return fit;
    }
    KickFit chip = fitter.fit(held, KickKind.CHIP);
    if (chip.failure().isPresent()) {
      return fit;
    }
    boolean toChip = fit.kind() == KickKind.FLAT;
    if (rise(chip) > STEEP != toChip) {
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
    boolean possible = changed.failure().isEmpty() && (!toChip || rise(changed) > STEEP);
    return possible ? changed : fit;
  }

  /** How steeply a chip rises: rise over run. */
  private static double rise(KickFit chip) {
    double run = Math.hypot(chip.estimate("vx").value(), chip.estimate("vy").value());
    return chip.estimate("vz").value() / run;
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
}
