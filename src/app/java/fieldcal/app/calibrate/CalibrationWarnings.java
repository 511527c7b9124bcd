package fieldcal.app.calibrate;

import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.VerdictText;
import fieldcal.app.wording.WordList;
import fieldcal.calibration.Average;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.Sample;
import fieldcal.calibration.TwoSigma;
import fieldcal.diagnosis.Verdict;
import fieldcal.fit.Agreement;
import fieldcal.fit.JointFit;
import fieldcal.kick.KickKind;
import fieldcal.verdict.Reason;
import fieldcal.verdict.VerdictRule;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What somebody should know beside the verdict, in sentences; for the report, the terminal and the JSON alike. */
public final class CalibrationWarnings {
  /** Offsets above that are worth a warning: they are larger than what a good camera calibration leaves, mm. */
  private static final double NOTABLE_OFFSET_MM = 5;

  /** That share of a kick's detections is more than sound chips show, whose loss at bounces is not quite fixed: 2 % in ER-Force's simulator, 5 % where they spin. */
  private static final double NOTABLE_LACK_OF_FIT = 0.05;

  private static final String FEW_DIAGNOSED =
      "The diagnosis found nothing wrong. " + VerdictText.SMALL_CAUSES;

  private final Calibration calibration;
  private final List<String> notes;
  private final Map<Integer, Set<Integer>> together;

  /** Whether kicks of several fields are mixed: then they differ, but not because of what the ball does. */
  private final boolean mixed;

  /** Whether a diagnosis found nothing wrong, but hardly could. */
  private final boolean hardlyDiagnosed;

  /** Whether flat kicks were fitted as chips: what such a fit makes of bounces means nothing. */
  private final boolean noChips;

  /**
   * Warnings about a calibration.
   *
   * @param outcome to be judged
   */
  public CalibrationWarnings(CalibrationOutcome outcome) {
    calibration = outcome.calibration();
    together = outcome.data().together();
    List<Reason> reasons = outcome.verdict().reasons();
    hardlyDiagnosed =
        calibration.trusted().size() < VerdictText.FEW_KICKS
            && reasons.stream()
                .anyMatch(
                    r -> r instanceof Reason.Diagnosed d && d.verdict() == Verdict.MODEL_ADEQUATE);
    noChips = reasons.stream().anyMatch(r -> r instanceof Reason.NoChips);
    mixed =
        reasons.stream()
            .anyMatch(
                r ->
                    r instanceof Reason.SeveralFields
                        || r instanceof Reason.OtherCameras
                        || r instanceof Reason.SimulatedField s && s.simulated() < s.recordings());
    notes =
        outcome
            .extended()
            .map(e -> new ExtendedModelNotes(e, outcome.data()).sentences())
            .orElse(List.of());
  }

  /**
   * The warnings.
   *
   * @return one sentence each, the most important first; may be empty
   */
  public List<String> list() {
    List<String> warnings = new ArrayList<>(notes);
    if (hardlyDiagnosed) {
      warnings.add(FEW_DIAGNOSED);
    }
    Map<Integer, Double> sizes = new TreeMap<>();
    calibration
        .joint()
        .map(JointFit::offsets)
        .orElse(Map.of())
        .forEach((camera, o) -> sizes.put(camera, 1000 * Math.hypot(o.x(), o.y())));
    if (calibration.trusted().size() >= VerdictRule.FEWEST_KICKS) {
      // What fewer kicks show may be their own error.
      offsets(sizes).ifPresent(warnings::add);
    }
    warnings.addAll(
        uncompared(
            calibration.kicks().stream()
                .filter(k -> k.fit().failure().isEmpty())
                .map(k -> k.fit().kick().observations().cameras())
                .toList(),
            together));
    addLackOfFit(warnings);
    if (mixed) {
      return warnings;
    }
    Stream.of(KickKind.values()).forEach(kind -> warnings.addAll(agreements(kind)));
    medians(Stream.of(KickKind.values()).flatMap(kind -> oneSided(kind).stream()).toList())
        .ifPresent(warnings::add);
    return warnings;
  }

  /** Parameters on which some kicks agree and others do not. */
  private List<String> agreements(KickKind kind) {
    List<String> sentences = new ArrayList<>();
    averages(kind)
        .forEach(
            (name, average) ->
                Average.agreement(samples(kind, name))
                    .filter(a -> covered(average, a))
                    .filter(CalibrationWarnings::matters)
                    .map(a -> agreement(name, a, samples(kind, name).size()))
                    .ifPresent(sentences::add));
    return sentences;
  }

  private Map<String, Average> averages(KickKind kind) {
    if (kind == KickKind.FLAT) {
      return calibration.flat();
    }
    return noChips ? Map.of() : calibration.chip();
  }

  /** Where the 2σ rule has excluded the others, they are named as excluded. */
  private static boolean covered(Average average, Agreement agreement) {
    return Math.abs(average.mean() - agreement.others()) < 2 * average.standardError();
  }

  /** Groups that lie closer together than mean and joint fit may are of no use to anybody. */
  static boolean matters(Agreement agreement) {
    return Math.abs(agreement.others() - agreement.value())
        >= VerdictRule.APART_PERCENT / 100 * Math.abs(agreement.value());
  }

  /** The values of a parameter, but those of kicks that are not trusted. */
  private List<Sample> samples(KickKind kind, String name) {
    return calibration.kicks(kind).stream()
        .flatMap(k -> k.samples().stream())
        .filter(s -> s.parameter().equals(name))
        .filter(s -> s.dropped().isEmpty() || s.leftForItsValue())
        .toList();
  }

  /** On which two values the kicks stand, and that the error covers both. */
  static String agreement(String parameter, Agreement agreement, int kicks) {
    return String.format(
        Locale.ROOT,
        "The kicks are of two kinds: %d of %d agree on a %s of %s%s, the others have %s%s on"
            + " average. Some of them may have spin. The error of the mean covers both.",
        Math.round(agreement.share() * kicks),
        kicks,
        ParameterWords.of(parameter),
        fourDigits(agreement.value()),
        ParameterWords.unit(parameter),
        fourDigits(agreement.others()),
        ParameterWords.unit(parameter));
  }

  private static String fourDigits(double value) {
    return Amount.minus(String.format(Locale.ROOT, "%.4g", value));
  }

  /** Parameters of which a median is given, so that values are used that lie more than 2 σ from it. */
  private List<String> oneSided(KickKind kind) {
    List<String> names = new ArrayList<>();
    averages(kind)
        .forEach(
            (name, average) -> {
              List<Sample> samples = samples(kind, name);
              List<Sample> used = samples.stream().filter(s -> s.dropped().isEmpty()).toList();
              boolean isMedian =
                  average.n() > 0
                      && average.mean() != Average.of(used).mean()
                      && Average.agreement(samples).isEmpty();
              if (isMedian && used.stream().anyMatch(s -> average.sigmas(s) > TwoSigma.LIMIT)) {
                names.add(ParameterWords.of(name));
              }
            });
    return names;
  }

  /** Why values are used that lie far from the mean. */
  static Optional<String> medians(List<String> names) {
    return names.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "The kicks do not scatter evenly about the mean of the "
                + WordList.of(names)
                + ". Some of them may have spin. The median is given instead, with an error that"
                + " covers both sides.");
  }

  /**
   * Cameras that no kick leads from one to another cannot be compared, however far they are apart. Of cameras of different fields, or before and after a calibration, nobody asks that.
   *
   * @param kicks the cameras that saw each
   * @param together by the number of each camera, those that looked at the field beside it
   * @return one sentence for each field with such cameras
   */
  static List<String> uncompared(List<int[]> kicks, Map<Integer, Set<Integer>> together) {
    List<Set<Integer>> groups =
        merged(
            kicks.stream()
                .map(cameras -> Arrays.stream(cameras).boxed().collect(Collectors.toSet()))
                .toList());
    List<Set<Integer>> neighbours = new ArrayList<>();
    for (int i = 0; i < groups.size(); i++) {
      Set<Integer> one = new TreeSet<>(Set.of(i));
      for (int j = 0; j < groups.size(); j++) {
        Set<Integer> other = groups.get(j);
        if (groups.get(i).stream()
            .anyMatch(id -> !Collections.disjoint(together.getOrDefault(id, Set.of()), other))) {
          one.add(j);
        }
      }
      neighbours.add(one);
    }
    return merged(neighbours).stream()
        .filter(field -> field.size() > 1)
        .map(field -> uncompared(field.stream().map(groups::get).toList()))
        .toList();
  }

  private static String uncompared(List<Set<Integer>> groups) {
    String named =
        groups.stream()
            .map(g -> WordList.of(g.stream().map(String::valueOf).toList()))
            .sorted()
            .collect(Collectors.joining("; "));
    return "No kick leads from the view of some cameras into that of others ("
        + named
        + "). It is not known how far these disagree, and no difference is assumed. Record"
        + " kicks from one view into the other.";
  }

  /** The same, where sets that have something in common are one. */
  private static List<Set<Integer>> merged(List<Set<Integer>> sets) {
    List<Set<Integer>> groups = new ArrayList<>();
    for (Set<Integer> set : sets) {
      Set<Integer> all = new TreeSet<>(set);
      for (Set<Integer> group : List.copyOf(groups)) {
        if (!Collections.disjoint(group, all)) {
          groups.remove(group);
          all.addAll(group);
        }
      }
      groups.add(all);
    }
    return groups;
  }

  /**
   * One sentence for all cameras: one that is off puts the others off from the mean.
   *
   * @param sizes of the cameras' offsets, mm
   */
  static Optional<String> offsets(Map<Integer, Double> sizes) {
    Map<Integer, Double> notable = new TreeMap<>(sizes);
    notable.values().removeIf(size -> !(size > NOTABLE_OFFSET_MM));
    if (notable.isEmpty()) {
      return Optional.empty();
    }
    double least = Collections.min(notable.values());
    double most = Collections.max(notable.values());
    boolean one = notable.size() == 1;
    String text =
        Math.round(least) == Math.round(most)
            ? String.format(Locale.ROOT, "%.0f mm", most)
            : notable.entrySet().stream()
                    .map(e -> String.format(Locale.ROOT, "%.0f", e.getValue()))
                    .collect(Collectors.collectingAndThen(Collectors.toList(), WordList::of))
                + " mm";
    return Optional.of(
        String.format(
            Locale.ROOT,
            "%s %s %s %s off from the mean of all cameras. %s taken out here, but not in a match:"
                + " calibrate the %s again.",
            one ? "Camera" : "Cameras",
            WordList.of(notable.keySet().stream().map(String::valueOf).toList()),
            one ? "reports everything" : "report everything",
            text,
            one ? "This offset is" : "These offsets are",
            one ? "camera" : "cameras"));
  }

  private void addLackOfFit(List<String> warnings) {
    double[] shares =
        calibration.kicks().stream()
            .filter(k -> k.fit().failure().isEmpty())
            .filter(k -> !noChips || k.fit().kind() == KickKind.FLAT)
            .map(k -> k.fit().statistics())
            .mapToDouble(s -> s.lackOfFit() / (double) s.observations())
            .filter(share -> share > NOTABLE_LACK_OF_FIT)
            .sorted()
            .toArray();
    if (shares.length > 0) {
      warnings.add(
          String.format(
              Locale.ROOT,
              "In %d of %d kicks the model does not explain a part of the path, up to %.0f %% of"
                  + " the detections. These kicks are used all the same; a diagnosis looks for the"
                  + " cause.",
              shares.length,
              calibration.kicks().size(),
              100 * shares[shares.length - 1]));
    }
  }
}
