package fieldcal.calibration;

import fieldcal.fit.Estimate;
import fieldcal.fit.FitStatistics;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import fieldcal.vision.Epoch;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Which kicks and which of their samples a model is made from. */
final class Selection {
  /** A kick whose fit is this many times worse than the others shows something else: a ball that hit a robot, two balls. */
  private static final double WORSE_THAN_OTHERS = 3;

  /**
   * RMS of a good fit with the cameras of real fields, mm (ten matches of 2026, Immortals-Robotics/Simulator, {@code docs/calibration}). With cameras that
   * are better than those, what is compared is how well the model describes each kick, and all of them are good.
   */
  private static final double GOOD_RMS_MM = 1.3;

  /** When a larger share of the detections are outliers, the rest is not trusted either. */
  private static final double MOST_OUTLIERS = 0.25;

  /** What was decided by hand, and the epoch of the times that name kicks. */
  record Decisions(HandSelection selection, Epoch epoch) {
    static Decisions of(CalibrationProblem problem) {
      return new Decisions(problem.selection(), problem.epoch());
    }
  }

  private Selection() {}

  /** Kicks whose fit can be believed and that were not dropped by hand: these enter the joint fit, whatever they determine. */
  static List<KickFit> trusted(List<KickFit> fits, Decisions decisions) {
    Map<KickKind, Double> medians = medianRms(fits);
    return fits.stream().filter(f -> distrust(f, medians, decisions).isEmpty()).toList();
  }

  /** Whether a kick is explained much worse than the others of its kind: the model of all, or what was fitted of this one, is not right for it. */
  static boolean standsOut(KickFit fit, List<KickFit> fits) {
    return fit.failure().isEmpty()
        && isWorse(fit.statistics().rmsMm(), medianRms(fits).get(fit.kind()));
  }

  /** Whether a kick stands out only while its rolling is held; a free fit that failed shows nothing. */
  static boolean isBetterFree(KickFit held, KickFit free, List<KickFit> fits) {
    return free.failure().isEmpty() && standsOut(held, fits) && !standsOut(free, fits);
  }

  private static boolean isWorse(double rmsMm, double median) {
    return rmsMm > WORSE_THAN_OTHERS * Math.max(GOOD_RMS_MM, median);
  }

  private static Optional<String> distrust(
      KickFit fit, Map<KickKind, Double> medians, Decisions decisions) {
    if (fit.failure().isPresent()) {
      return fit.failure();
    }
    String key = key(fit, decisions);
    Optional<String> byHand = decisions.selection().droppedBecause(key);
    if (byHand.isPresent() || decisions.selection().isKept(key)) {
      return byHand.map(r -> "by hand: " + r);
    }
    FitStatistics s = fit.statistics();
    double median = medians.get(fit.kind());
    if (isWorse(s.rmsMm(), median)) {
      return Optional.of(
          String.format(
              Locale.ROOT, "its rms is %.1f mm, that of the others %.1f mm", s.rmsMm(), median));
    }
    double outliers = 1 - s.used() / (double) s.observations();
    if (outliers > MOST_OUTLIERS) {
      return Optional.of(
          String.format(Locale.ROOT, "%.0f %% of its detections do not fit", 100 * outliers));
    }
    return Optional.empty();
  }

  /** Median RMS of the kicks of each kind that have a fit, mm; NaN without any. */
  private static Map<KickKind, Double> medianRms(List<KickFit> fits) {
    Map<KickKind, Double> medians = new EnumMap<>(KickKind.class);
    for (KickKind kind : KickKind.values()) {
      medians.put(kind, medianRms(fits, kind));
    }
    return medians;
  }

  private static double medianRms(List<KickFit> fits, KickKind kind) {
    double[] rms =
        fits.stream()
            .filter(f -> f.failure().isEmpty() && f.kind() == kind)
            .mapToDouble(KickFit::rmsMm)
            .sorted()
            .toArray();
    return rms.length == 0 ? Double.NaN : rms[rms.length / 2];
  }

  private static String key(KickFit fit, Decisions decisions) {
    return HandSelection.key(decisions.epoch().unixSeconds(fit.kick().time()));
  }

  /** Every kick with its samples; the 2σ rule applied to each parameter until no value is excluded any more. */
  static List<CalibratedKick> select(List<KickFit> fits, Decisions decisions) {
    Map<String, List<Sample>> byParameter = new LinkedHashMap<>();
    Map<KickFit, Optional<String>> distrusted = new HashMap<>();
    Set<Integer> kept = new HashSet<>();
    Map<KickKind, Double> medians = medianRms(fits);
    for (KickFit fit : fits) {
      Optional<String> reason = distrust(fit, medians, decisions);
      distrusted.put(fit, reason);
      if (decisions.selection().isKept(key(fit, decisions))) {
        kept.add(fit.kick().id());
      }
      for (Estimate e : fit.modelEstimates()) {
        if (e.usable()) {
          Sample s = new Sample(fit.kick().id(), e.name(), e.value(), e.standardError(), reason);
          byParameter
              .computeIfAbsent(fit.kind().id() + " " + e.name(), n -> new ArrayList<>())
              .add(s);
        }
      }
    }
    Map<Integer, List<Sample>> byKick = new HashMap<>();
    for (List<Sample> samples : byParameter.values()) {
      List<Sample> judged =
          new ArrayList<>(TwoSigma.rounds(samples, decisions.selection().twoSigmaRounds()));
      for (int i = 0; i < judged.size(); i++) {
        if (kept.contains(judged.get(i).kickId())) {
          // A kick kept by hand keeps its samples.
          judged.set(i, samples.get(i));
        }
      }
      for (Sample sample : TwoSigma.restated(judged)) {
        byKick.computeIfAbsent(sample.kickId(), id -> new ArrayList<>()).add(sample);
      }
    }
    return fits.stream()
        .map(
            f ->
                new CalibratedKick(
                    f, byKick.getOrDefault(f.kick().id(), List.of()), distrusted.get(f)))
        .toList();
  }

  /** The parameters that are averaged: how a chip rolls is part of its fit, but the model has it from flat kicks. */
  static List<String> averaged(KickKind kind) {
    return kind == KickKind.FLAT
        ? List.of("accSlide", "accRoll", "kSwitch")
        : List.of("dampingXyFirstHop", "dampingXyOtherHops", "dampingZ");
  }

  /** The average of each parameter over the kicks of one kind. */
  static Map<String, Average> averages(List<CalibratedKick> kicks, KickKind kind) {
    Map<String, Average> averages = new LinkedHashMap<>();
    for (String name : averaged(kind)) {
      List<Sample> samples =
          kicks.stream()
              .filter(k -> k.fit().kind() == kind)
              .flatMap(k -> k.samples().stream())
              .filter(s -> s.parameter().equals(name))
              .toList();
      averages.put(name, Average.judged(samples));
    }
    return averages;
  }
}
