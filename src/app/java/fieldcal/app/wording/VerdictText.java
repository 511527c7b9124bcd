package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.Unexplained;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A whole diagnosis in an operator's words.
 *
 * @param headline what it means for the team, in one sentence or two: how wrong kicks are predicted, before and after
 * @param verdict what it comes to, with the causes by name, in one sentence or two
 * @param lines more of it, one sentence or two each
 */
public record VerdictText(String headline, String verdict, List<String> lines) {
  private static final int MOST_VARIABLES = 3;

  /** Where the root mean square of all kicks exceeds what is typical by that factor, some kicks are far worse than the others; chosen: in five of twelve recordings of another simulator it does, in one by a factor of 53. */
  private static final double FAR_WORSE = 2;

  /** Fewer kicks do not show small causes; chosen: half of what the operator is asked to record. */
  public static final int FEW_KICKS = 10;

  private static final String RECORD_MORE =
      "Record at least twelve flat kicks and twelve chips of all speeds";

  /** What a diagnosis of few kicks that finds nothing wrong does not say. */
  public static final String SMALL_CAUSES =
      "So few kicks do not show small causes. " + RECORD_MORE + ".";

  /** Why its residuals are not those that a calibration shows. */
  public static final String WITHOUT_OFFSETS =
      "calibrate shows smaller residuals, because it takes out the offsets of the cameras.";

  /** Copies the list. {@inheritDoc} */
  public VerdictText {
    lines = List.copyOf(lines);
  }

  /**
   * Puts a diagnosis into words.
   *
   * @param diagnosis what it came to
   * @return the text
   */
  public static VerdictText of(Diagnosis diagnosis) {
    List<String> lines = new ArrayList<>();
    String verdict =
        switch (diagnosis.verdict()) {
          case MODEL_ADEQUATE -> adequate(diagnosis, lines);
          case EXPLAINED -> explained(diagnosis, lines);
          case PARTLY_EXPLAINED -> partly(diagnosis, lines);
          case UNEXPLAINED_STRUCTURE -> unexplained(diagnosis, lines);
        };
    farWorse(diagnosis).ifPresent(lines::add);
    lines.addAll(failures(diagnosis));
    return new VerdictText(Headline.of(diagnosis), verdict, lines);
  }

  /**
   * Headline and verdict.
   *
   * @return in one line
   */
  public String first() {
    return headline + " " + verdict;
  }

  static boolean isKnown(Double value) {
    return value != null && Double.isFinite(value);
  }

  // ---- the verdict ----

  private static String adequate(Diagnosis d, List<String> lines) {
    lines.add(
        text(
            "The kicks fit to %s mm rms; the noise of the cameras alone is %s mm.",
            mm(d.base().rmsMm()), mm(d.base().noiseMm())));
    lines.add(
        text(
            "%d kinds of causes were tried. None of them improves the prediction of held-out"
                + " kicks.",
            kinds(d)));
    return hasFewKicks(d)
        ? "These few kicks show nothing wrong with the model beyond noise."
        : "These kicks show no error beyond noise.";
  }

  /**
   * Whether small causes do not show in so few kicks.
   *
   * @param d the diagnosis
   * @return true for fewer than ten
   */
  public static boolean hasFewKicks(Diagnosis d) {
    return d.kicks().size() < FEW_KICKS;
  }

  private static String explained(Diagnosis d, List<String> lines) {
    lines.add(gain(d));
    caveat(d).ifPresent(lines::add);
    String found =
        d.causes().size() == 1
            ? text("These kicks do not follow the model, and the cause is found: %s.", names(d))
            : text(
                "These kicks do not follow the model, and %d causes are found: %s.",
                d.causes().size(), names(d));
    return found + laws(d) + chance(d) + unproven(d) + undecided(d);
  }

  private static String partly(Diagnosis d, List<String> lines) {
    boolean left = d.unexplained().significant();
    lines.add(gain(d));
    if (left) {
      lines.add("Still unexplained: " + rest(d.unexplained()));
    }
    lines.add(advice(d));
    if (!d.causes().isEmpty()) {
      String found =
          text(
              "These kicks do not follow the model, and a part of that is explained: %s.",
              names(d));
      return found + curves(d) + laws(d) + chance(d) + unproven(d) + undecided(d);
    }
    String laws = names(d, f -> f.kind() == LearnedFinding.Kind.LAW);
    String found =
        laws.isEmpty()
            ? "These kicks do not follow the model, and no cause is proven."
            : text(
                "These kicks do not follow the model. Another law replaces one of its own: %s.",
                laws);
    return found + curves(d) + chance(d) + unproven(d) + undecided(d);
  }

  private static String unexplained(Diagnosis d, List<String> lines) {
    lines.add(
        d.kicks().size() == 1
            ? text(
                "In this one kick, the ball is off by %s mm beyond the noise.",
                mm(d.unexplained().systematicMm()))
            : Sentences.begin(rest(d.unexplained())));
    lines.add(
        d.kicks().size() == 1
            ? "The pictures show where the model errs."
            : text(
                "None of the %d kinds of causes that were tried improves the prediction of held-out"
                    + " kicks, so none is named. The pictures show where the model errs.",
                kinds(d)));
    toRecord(d).ifPresent(lines::add);
    return "Something is wrong that no known cause explains.";
  }

  /**
   * What to do where a part is explained.
   *
   * @param d the diagnosis
   * @return a sentence or two
   */
  public static String advice(Diagnosis d) {
    return use(d) + toRecord(d).map(kicks -> " To find the rest: " + lower(kicks)).orElse("");
  }

  /** Which kicks would tell more; of a single kick it is not known what its error depends on. */
  private static Optional<String> toRecord(Diagnosis d) {
    return d.kicks().size() == 1
        ? Optional.of(RECORD_MORE + ": a single kick shows no cause.")
        : d.unexplained().dependsOn().stream().findFirst().map(StructureWords::kicksToRecord);
  }

  private static String use(Diagnosis d) {
    return caveat(d).orElse("Use the extended model: it predicts better than the calibrated one.");
  }

  /**
   * That whoever predicts with the extended model should look at the predictions first.
   *
   * @param d the diagnosis
   * @return a sentence; empty where it predicts no worse at any horizon, and clearly better at the one of the first line
   */
  public static Optional<String> caveat(Diagnosis d) {
    Map<Double, Double> before = d.base().typicalErrorMm();
    Map<Double, Double> after = d.extended().typicalErrorMm();
    List<Double> all =
        before.keySet().stream()
            .filter(h -> isKnown(before.get(h)) && isKnown(after.get(h)))
            .toList();
    boolean worse = false;
    boolean better = all.isEmpty();
    for (double h : all) {
      worse |= after.get(h) > (1 + Headline.AS_GOOD) * before.get(h);
      better |= after.get(h) < (1 - Headline.AS_GOOD) * before.get(h);
    }
    if (worse) {
      return Optional.of(
          "The extended model follows kicks better, but does not always predict them better from"
              + " their first 0.3 s: compare both in the table before you use it.");
    }
    if (!better) {
      return Optional.of(
          "The extended model follows kicks better, and predicts them as well as the"
              + " calibrated one from their first 0.3 s.");
    }
    return Headline.doubts(d)
        ? Optional.of(
            "The extended model follows kicks better, and predicts them hardly better from their"
                + " first 0.3 s.")
        : Optional.empty();
  }

  /**
   * That some kicks are predicted much worse than the typical errors say.
   *
   * @param d the diagnosis
   * @return a sentence about the horizon where the two are farthest apart; empty where no model has such kicks
   */
  public static Optional<String> farWorse(Diagnosis d) {
    boolean found = !d.causes().isEmpty() || !d.learned().isEmpty();
    return Stream.of(
            farWorse(d.base(), "the calibrated model"),
            found ? farWorse(d.extended(), "the extended model") : Optional.<String>empty())
        .flatMap(Optional::stream)
        .reduce((a, b) -> a + " " + b);
  }

  private static Optional<String> farWorse(Quality q, String model) {
    return q.typicalErrorMm().keySet().stream()
        .filter(h -> excess(q, h) > FAR_WORSE)
        .max(Comparator.comparingDouble(h -> excess(q, h)))
        .map(
            h ->
                text(
                    "With %s, some kicks are predicted far worse than most: %s s ahead, the root"
                        + " mean square error of all kicks is %s mm, the typical error %s mm.",
                    model,
                    seconds(h),
                    Amount.of(q.predictionErrorMm().get(h)),
                    Amount.of(q.typicalErrorMm().get(h))));
  }

  private static double excess(Quality q, double horizon) {
    return q.predictionErrorMm().get(horizon) / q.typicalErrorMm().get(horizon);
  }

  /**
   * Parts of the diagnosis that did not come to an end.
   *
   * @param d the diagnosis
   * @return a sentence for each
   */
  public static List<String> failures(Diagnosis d) {
    return d.problems().stream().map(p -> "There may be more to find: " + p + ".").toList();
  }

  private static long kinds(Diagnosis d) {
    return d.candidates().stream().map(c -> c.effect().id()).distinct().count();
  }

  /** What was found gains together. */
  private static String gain(Diagnosis d) {
    Quality before = d.base();
    Quality after = d.extended();
    String horizons =
        before.typicalErrorMm().entrySet().stream()
            .filter(e -> isKnown(e.getValue()))
            .filter(e -> isKnown(after.typicalErrorMm().get(e.getKey())))
            .map(
                e ->
                    text(
                        "%s mm instead of %s mm %s s ahead",
                        Amount.of(after.typicalErrorMm().get(e.getKey())),
                        Amount.of(e.getValue()),
                        seconds(e.getKey())))
            .collect(Collectors.joining(", "));
    String held =
        Double.isNaN(before.holdoutRmsMm())
            ? text(
                "With the extended model, the residual falls from %s mm to %s mm (the cameras'"
                    + " noise is %s mm); there are too few kicks to hold some out.",
                mm(before.rmsMm()), mm(after.rmsMm()), mm(after.noiseMm()))
            : text(
                "With the extended model, held-out kicks fit to %s mm"
                    + " instead of %s mm (the cameras' noise is %s mm).",
                mm(after.holdoutRmsMm()), mm(before.holdoutRmsMm()), mm(after.noiseMm()));
    return horizons.isEmpty() ? held : held + " Predictions are off by " + horizons + ".";
  }

  /**
   * What is left when all that was found is in the model.
   *
   * @param u what that is
   * @return a sentence that begins in lower case
   */
  public static String rest(Unexplained u) {
    String on =
        u.dependsOn().isEmpty()
            ? "without a pattern that could be named"
            : "depending on "
                + u.dependsOn().stream()
                    .limit(MOST_VARIABLES)
                    .map(StructureWords::of)
                    .collect(Collectors.joining(", then on "));
    return text("balls are off by %s mm beyond the noise, %s.", mm(u.systematicMm()), on);
  }

  private static String names(Diagnosis d) {
    return d.causes().stream()
        .map((Cause cause) -> EffectName.of(cause))
        .collect(Collectors.joining("; "));
  }

  /** Learned curves by name; begins with a blank. */
  private static String curves(Diagnosis d) {
    String names = names(d, f -> f.kind() == LearnedFinding.Kind.CURVE && f.isShownToHelp());
    return names.isEmpty()
        ? ""
        : (d.causes().isEmpty() && !hasLaw(d)
                ? " Held-out kicks fit better with "
                : " Without a proven cause, held-out kicks also fit better with ")
            + names
            + ".";
  }

  private static boolean hasLaw(Diagnosis d) {
    return d.learned().stream().anyMatch(f -> f.kind() == LearnedFinding.Kind.LAW);
  }

  /** What takes the place of the simple model's own laws; begins with a blank. */
  private static String laws(Diagnosis d) {
    String names = names(d, f -> f.kind() == LearnedFinding.Kind.LAW);
    return names.isEmpty() ? "" : text(" Another law applies in the extended model: %s.", names);
  }

  /** What no model predicts; begins with a blank. */
  private static String chance(Diagnosis d) {
    String names = names(d, f -> f.kind() == LearnedFinding.Kind.SCATTER);
    return names.isEmpty() ? "" : text(" Chance plays a part: %s.", names);
  }

  /** What the prediction needs and nothing proves; begins with a blank. */
  private static String unproven(Diagnosis d) {
    String names = names(d, f -> f.kind() == LearnedFinding.Kind.UNPROVEN && f.isShownToHelp());
    return names.isEmpty()
        ? ""
        : text(" Held-out kicks also fit better with %s, but that is not proven.", names);
  }

  /** What is in the extended model and gains nothing beyond chance; begins with a blank. */
  private static String undecided(Diagnosis d) {
    String names = names(d, f -> !f.isShownToHelp());
    return names.isEmpty()
        ? ""
        : text(" Held-out kicks do not show whether this helps: %s.", names);
  }

  private static String names(Diagnosis d, Predicate<LearnedFinding> which) {
    return WordList.of(
        d.learned().stream().filter(which).map(f -> EffectName.of(f.effect())).toList());
  }

  private static String lower(String text) {
    return Character.toLowerCase(text.charAt(0)) + text.substring(1);
  }

  static String seconds(double s) {
    return Amount.decimals(s, 1).replaceAll("\\.0$", "");
  }

  static String mm(double value) {
    return Amount.decimals(value, value < 1 ? 2 : 1);
  }
}
