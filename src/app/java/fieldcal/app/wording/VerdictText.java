package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.Unexplained;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A whole diagnosis in an operator's words.
 *
 * @param headline the verdict in one sentence
 * @param lines what it means in numbers, one sentence or two each
 */
public record VerdictText(String headline, List<String> lines) {

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
    String headline =
        switch (diagnosis.verdict()) {
          case MODEL_ADEQUATE -> adequate(diagnosis, lines);
          case EXPLAINED -> explained(diagnosis, lines);
          case PARTLY_EXPLAINED -> partly(diagnosis, lines);
          case UNEXPLAINED_STRUCTURE -> unexplained(diagnosis, lines);
        };
    return new VerdictText(headline, lines);
  }

  private static String adequate(Diagnosis d, List<String> lines) {
    lines.add(
        text(
            "Between the model and what the cameras saw are %s mm; their noise alone makes %s mm.",
            mm(d.base().rmsMm()), mm(d.base().noiseMm())));
    lines.add(
        text(
            "%d sorts of causes were tried, and none of them predicts kicks that it has not seen"
                + " any better.",
            sorts(d)));
    horizon(d.base())
        .ifPresent(
            h ->
                lines.add(
                    text(
                        "From the first 0.3 s of a kick, the model predicts the ball %s s ahead to"
                            + " %s mm.",
                        seconds(h.getKey()), Amount.of(h.getValue()))));
    return "The model is right: nothing to correct.";
  }

  private static String explained(Diagnosis d, List<String> lines) {
    lines.add(gain(d));
    if (d.unexplained().significant()) {
      lines.add("A part of it is still unexplained: " + rest(d.unexplained()));
    }
    return d.causes().size() == 1
        ? text("The model is wrong, and the cause is found: %s.", names(d))
        : text("The model is wrong, and %d causes are found: %s.", d.causes().size(), names(d));
  }

  private static String partly(Diagnosis d, List<String> lines) {
    lines.add(gain(d));
    if (d.unexplained().significant()) {
      lines.add("A part of it is still unexplained: " + rest(d.unexplained()));
    }
    return d.causes().isEmpty()
        ? "The model is wrong; what helps has no name yet, but the extended model predicts better."
        : text("The model is wrong, and a part of the cause is found: %s.", names(d));
  }

  private static String unexplained(Diagnosis d, List<String> lines) {
    lines.add(Sentences.begin(rest(d.unexplained())));
    lines.add(
        d.causes().isEmpty()
            ? text(
                "None of the %d causes tried explains it, so none is blamed: look at the pictures"
                    + " for what changes with it.",
                d.candidates().size())
            : text(
                "What is found so far (%s) is not all of it; no other known cause explains the"
                    + " rest.",
                names(d)));
    if (!d.causes().isEmpty()) {
      lines.add(gain(d));
    }
    d.unexplained().dependsOn().stream()
        .findFirst()
        .ifPresent(v -> lines.add(StructureWords.kicksToRecord(v)));
    return "Something is wrong that no known cause explains.";
  }

  private static long sorts(Diagnosis d) {
    return d.candidates().stream().map(c -> c.effect().id()).distinct().count();
  }

  /** What the causes gain together. */
  private static String gain(Diagnosis d) {
    Quality before = d.base();
    Quality after = d.extended();
    String horizons =
        before.predictionErrorMm().entrySet().stream()
            .filter(e -> after.predictionErrorMm().containsKey(e.getKey()))
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
                "With %s in the model the residual falls from %s to %s mm; too few kicks to hold"
                    + " some out (the cameras' noise is %s mm).",
                them(d), mm(before.rmsMm()), mm(after.rmsMm()), mm(after.noiseMm()))
            : text(
                "With %s in the model, kicks that it has never seen fit to %s mm instead of %s mm"
                    + " (the cameras' noise is %s mm).",
                them(d), mm(after.holdoutRmsMm()), mm(before.holdoutRmsMm()), mm(after.noiseMm()));
    return horizons.isEmpty() ? held : held + " Predictions are off by " + horizons + ".";
  }

  /**
   * What is left when all causes are in the model.
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
                    .limit(3)
                    .map(StructureWords::of)
                    .collect(Collectors.joining(", then on "));
    return text("balls are off by %s mm beyond the noise, %s.", mm(u.systematicMm()), on);
  }

  private static String them(Diagnosis d) {
    return d.causes().size() == 1 ? "it" : "them";
  }

  private static String names(Diagnosis d) {
    return d.causes().stream()
        .map(Cause::effect)
        .map(EffectName::of)
        .collect(Collectors.joining("; "));
  }

  private static Optional<Map.Entry<Double, Double>> horizon(Quality quality) {
    return quality.predictionErrorMm().entrySet().stream()
        .filter(e -> e.getKey() <= 1)
        .reduce((a, b) -> b);
  }

  private static String seconds(double s) {
    return Amount.decimals(s, 1).replaceAll("\\.0$", "");
  }

  private static String mm(double value) {
    return Amount.decimals(value, value < 1 ? 2 : 1);
  }
}
