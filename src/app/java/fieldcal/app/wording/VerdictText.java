package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.Unexplained;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A whole diagnosis in an operator's words.
 *
 * @param headline what it means for the team, in one sentence: how wrong passes are predicted, before and after
 * @param verdict what it comes to, with the causes by name, in one sentence or two
 * @param lines more of it, one sentence or two each
 */
public record VerdictText(String headline, String verdict, List<String> lines) {
  /** How far ahead a pass is predicted in the headline, s. */
  private static final double AHEAD = 1;

  /** Predictions that gain less than this share are not worth a headline; chosen. */
  private static final double LEAST_GAIN = 0.1;

  /** From that error on it is said in cm. */
  private static final double CENTIMETRES_FROM_MM = 100;

  private static final int MOST_VARIABLES = 3;

  /** A prediction that errs by a fiftieth more is as good. */
  private static final double NO_WORSE = 1.02;

  /** Fewer kicks do not show small causes; chosen: half of what the operator is asked to record. */
  private static final int FEW_KICKS = 10;

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
    lines.addAll(failures(diagnosis));
    return new VerdictText(headline(diagnosis), verdict, lines);
  }

  /**
   * Headline and verdict.
   *
   * @return in one line
   */
  public String first() {
    return headline + " " + verdict;
  }

  // ---- what it means for the team ----

  private static String headline(Diagnosis d) {
    boolean helped = !d.causes().isEmpty() || !d.learned().isEmpty();
    Optional<Double> horizon = horizon(d);
    if (!helped) {
      return horizon.map(h -> predicted(d, h, "")).orElseGet(() -> fitted(d, ""));
    }
    if (horizon.isPresent()) {
      double before = d.base().predictionErrorMm().get(horizon.get());
      double after = d.extended().predictionErrorMm().get(horizon.get());
      if (after < (1 - LEAST_GAIN) * before) {
        return predicted(d, horizon.get(), "with what was found ");
      }
    }
    return fitted(d, "with what was found ");
  }

  /** An empty {@code with} leaves the extended model out. */
  private static String predicted(Diagnosis d, double horizon, String with) {
    double before = d.base().predictionErrorMm().get(horizon);
    double after = with.isEmpty() ? before : d.extended().predictionErrorMm().get(horizon);
    boolean cm = Math.max(before, after) >= CENTIMETRES_FROM_MM;
    String text =
        text(
            "%s are predicted %s %s wrong after %s s",
            kicks(d), length(before, cm), cm ? "cm" : "mm", seconds(horizon));
    return with.isEmpty()
        ? text + "."
        : text + "; " + with + length(after, cm) + (cm ? " cm." : " mm.");
  }

  private static String length(double mm, boolean cm) {
    double value = cm ? mm / 10 : mm;
    return Amount.decimals(value, value < 5 ? 1 : 0);
  }

  private static String fitted(Diagnosis d, String with) {
    boolean held = !Double.isNaN(d.base().holdoutRmsMm());
    double before = held ? d.base().holdoutRmsMm() : d.base().rmsMm();
    double after = held ? d.extended().holdoutRmsMm() : d.extended().rmsMm();
    String text =
        text(
            held
                ? "The model misses kicks that were held out by %s mm"
                : "The model misses by %s mm",
            mm(before));
    return with.isEmpty() ? text + "." : text + "; " + with + "by " + mm(after) + " mm.";
  }

  private static String kicks(Diagnosis d) {
    boolean chips =
        !d.kicks().isEmpty() && d.kicks().stream().allMatch(k -> k.kind() == KickKind.CHIP);
    return chips ? "Chips" : "Passes";
  }

  /** The horizon of the headline: a second where there is one, else the longest. */
  private static Optional<Double> horizon(Diagnosis d) {
    Map<Double, Double> before = d.base().predictionErrorMm();
    Map<Double, Double> after = d.extended().predictionErrorMm();
    List<Double> all =
        before.keySet().stream()
            .filter(h -> isKnown(before.get(h)) && isKnown(after.get(h)))
            .toList();
    return all.contains(AHEAD) ? Optional.of(AHEAD) : all.stream().reduce((a, b) -> b);
  }

  private static boolean isKnown(Double value) {
    return value != null && Double.isFinite(value);
  }

  // ---- the verdict ----

  private static String adequate(Diagnosis d, List<String> lines) {
    lines.add(
        text(
            "The kicks fit to %s mm rms; the noise of the cameras alone makes %s mm.",
            mm(d.base().rmsMm()), mm(d.base().noiseMm())));
    lines.add(
        text(
            "%d kinds of causes were tried. None of them predicts kicks that were held out any"
                + " better.",
            kinds(d)));
    return hasFewKicks(d)
        ? "These few kicks show nothing wrong with the model."
        : "The model is right: nothing to correct.";
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
    String found =
        d.causes().size() == 1
            ? text("The model is wrong, and the cause is found: %s.", names(d))
            : text("The model is wrong, and %d causes are found: %s.", d.causes().size(), names(d));
    return found + laws(d) + chance(d) + unproven(d);
  }

  private static String partly(Diagnosis d, List<String> lines) {
    boolean left = d.unexplained().significant();
    lines.add(gain(d));
    if (left) {
      lines.add("Still unexplained: " + rest(d.unexplained()));
    }
    lines.add(advice(d));
    String unnamed = unnamed(d);
    String found =
        d.causes().isEmpty()
            ? "The model is wrong, and no known cause explains it."
            : text("The model is wrong, and a part of it is explained: %s.", names(d));
    String more =
        unnamed.isEmpty() ? "" : text(" This also helps, without a known cause: %s.", unnamed);
    return found + more + laws(d) + chance(d) + unproven(d);
  }

  private static String unexplained(Diagnosis d, List<String> lines) {
    lines.add(Sentences.begin(rest(d.unexplained())));
    lines.add(
        text(
            "None of the %d kinds of causes that were tried predicts kicks that were held out any"
                + " better, so none is named. The pictures show where the model errs.",
            kinds(d)));
    d.unexplained().dependsOn().stream()
        .findFirst()
        .ifPresent(v -> lines.add(StructureWords.kicksToRecord(v)));
    return "Something is wrong that no known cause explains.";
  }

  /**
   * What to do where a part is explained.
   *
   * @param d the diagnosis
   * @return a sentence or two
   */
  public static String advice(Diagnosis d) {
    return use(d)
        + d.unexplained().dependsOn().stream()
            .findFirst()
            .map(v -> " To find the rest: " + lower(StructureWords.kicksToRecord(v)))
            .orElse("");
  }

  private static String use(Diagnosis d) {
    boolean ahead =
        d.extended().predictionErrorMm().entrySet().stream()
            .allMatch(
                e ->
                    e.getValue()
                        <= NO_WORSE
                            * d.base().predictionErrorMm().getOrDefault(e.getKey(), Double.NaN));
    return ahead
        ? "Use the extended model: it predicts better than the simple one, whatever is left."
        : "The extended model follows kicks better, but does not predict them better from their"
            + " first 0.3 s at every horizon: compare both in the table before you use it.";
  }

  /**
   * Parts of the diagnosis that did not come to an end.
   *
   * @param d the diagnosis
   * @return a sentence for each
   */
  public static List<String> failures(Diagnosis d) {
    return d.problems().stream()
        .map(p -> "A part of the diagnosis failed, so there may be more to find: " + p + ".")
        .toList();
  }

  private static long kinds(Diagnosis d) {
    return d.candidates().stream().map(c -> c.effect().id()).distinct().count();
  }

  /** What was found gains together. */
  private static String gain(Diagnosis d) {
    Quality before = d.base();
    Quality after = d.extended();
    String horizons =
        before.predictionErrorMm().entrySet().stream()
            .filter(e -> isKnown(e.getValue()))
            .filter(e -> isKnown(after.predictionErrorMm().get(e.getKey())))
            .map(
                e ->
                    text(
                        "%s mm instead of %s mm %s s ahead",
                        Amount.of(after.predictionErrorMm().get(e.getKey())),
                        Amount.of(e.getValue()),
                        seconds(e.getKey())))
            .collect(Collectors.joining(", "));
    String held =
        Double.isNaN(before.holdoutRmsMm())
            ? text(
                "With what was found in the model, the residual falls from %s to %s mm; too few"
                    + " kicks to hold some out (the cameras' noise is %s mm).",
                mm(before.rmsMm()), mm(after.rmsMm()), mm(after.noiseMm()))
            : text(
                "With what was found in the model, kicks that were held out fit to %s mm"
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

  /** Learned curves by name. */
  private static String unnamed(Diagnosis d) {
    return names(d, LearnedFinding.Kind.CURVE);
  }

  /** What takes the place of the simple model's own laws; begins with a blank. */
  private static String laws(Diagnosis d) {
    String names = names(d, LearnedFinding.Kind.LAW);
    return names.isEmpty() ? "" : text(" Another law applies in the extended model: %s.", names);
  }

  /** What no model predicts; begins with a blank. */
  private static String chance(Diagnosis d) {
    String names = names(d, LearnedFinding.Kind.SCATTER);
    return names.isEmpty() ? "" : text(" Chance plays a part: %s.", names);
  }

  /** What the prediction needs and nothing proves; begins with a blank. */
  private static String unproven(Diagnosis d) {
    String names = names(d, LearnedFinding.Kind.UNPROVEN);
    return names.isEmpty() ? "" : text(" This also helps, but is not proven: %s.", names);
  }

  private static String names(Diagnosis d, LearnedFinding.Kind kind) {
    return d.learned().stream()
        .filter(f -> f.kind() == kind)
        .map(f -> EffectName.of(f.effect()))
        .collect(Collectors.joining("; "));
  }

  private static String lower(String text) {
    return Character.toLowerCase(text.charAt(0)) + text.substring(1);
  }

  private static String seconds(double s) {
    return Amount.decimals(s, 1).replaceAll("\\.0$", "");
  }

  private static String mm(double value) {
    return Amount.decimals(value, value < 1 ? 2 : 1);
  }
}
