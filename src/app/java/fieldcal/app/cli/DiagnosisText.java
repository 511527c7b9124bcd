package fieldcal.app.cli;

import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.recording.DataProblem;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.diagnosis.Unexplained;
import fieldcal.diagnosis.Verdict;
import fieldcal.effect.EffectFields;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Prints a diagnosis for the operator's terminal: at most some forty lines of a hundred columns. */
final class DiagnosisText {
  private static final int WIDTH = 98;
  private static final int MOST_PROBLEMS = 3;

  private final PrintWriter out;

  DiagnosisText(PrintWriter out) {
    this.out = out;
  }

  void print(DiagnosisOutcome outcome, Path directory) {
    Diagnosis diagnosis = outcome.diagnosis();
    headline(outcome);
    int number = 1;
    for (Cause cause : diagnosis.causes()) {
      cause(number++, cause);
    }
    line("");
    quality(diagnosis);
    remains(diagnosis);
    line("");
    sources(outcome);
    if (directory != null) {
      line("files: %s, diagnosis.json, extended_model.json", directory.resolve("diagnosis.html"));
    }
    out.flush();
  }

  private void headline(DiagnosisOutcome outcome) {
    Diagnosis d = outcome.diagnosis();
    String kicks = d.kicks().size() + " kicks";
    String size =
        String.format(
            Locale.ROOT, "%.2f mm RMS, noise %.2f mm", d.base().rmsMm(), d.base().noiseMm());
    switch (d.verdict()) {
      case MODEL_ADEQUATE ->
          line("Nothing is wrong: the calibrated model explains all %s (%s).", kicks, size);
      case EXPLAINED -> line("The calibrated model is wrong on %s (%s). Why:", kicks, size);
      default -> {
        line("The calibrated model is wrong on %s (%s).", kicks, size);
        line(
            d.causes().isEmpty()
                ? "No known cause explains it."
                : "Known causes explain a part of it only:");
      }
    }
  }

  private void cause(int number, Cause cause) {
    line("");
    wrapped(number + ". ", "   ", cause.effect().sentence());
    wrapped(
        "   ", "     ", cause.effect().id() + ": " + numbers(cause) + "; " + gain(cause.gain()));
    if (!cause.indistinguishableFrom().isEmpty()) {
      wrapped(
          "   ",
          "     ",
          "These kicks cannot tell it from "
              + String.join(", ", cause.indistinguishableFrom())
              + ".");
    }
    if (!cause.discriminatingKicks().isEmpty()) {
      wrapped("   ", "     ", "To be sure, record: " + cause.discriminatingKicks());
    }
  }

  private static String numbers(Cause cause) {
    String numbers =
        EffectFields.of(cause.effect()).entrySet().stream()
            .map(e -> number(e, cause.standardErrors()))
            .collect(Collectors.joining(", "));
    return cause.scatter() > 0
        ? numbers + String.format(Locale.ROOT, ", scatter %.3g from kick to kick", cause.scatter())
        : numbers;
  }

  private static String number(Map.Entry<String, Object> field, Map<String, Double> errors) {
    String name = field.getKey() + " ";
    Double error = errors.get(field.getKey());
    if (!(field.getValue() instanceof Double value)) {
      return name + field.getValue();
    }
    if (error == null || !(error > 0) || Double.isInfinite(error)) {
      return name + String.format(Locale.ROOT, "%.4g", value);
    }
    // As many decimals as show two digits of the error.
    int decimals = Math.min(7, Math.max(0, 1 - (int) Math.floor(Math.log10(error))));
    return name
        + String.format(Locale.ROOT, "%." + decimals + "f ± %." + decimals + "f", value, error);
  }

  private static String gain(Gain gain) {
    if (!Double.isFinite(gain.mm())) {
      return "gain unknown, too few kicks";
    }
    String bounds =
        Double.isFinite(gain.lowMm() + gain.highMm())
            ? String.format(Locale.ROOT, " (%.2f to %.2f)", gain.lowMm(), gain.highMm())
            : "";
    return String.format(
        Locale.ROOT,
        "gains %.2f mm%s on kicks held out, %.0f %%",
        gain.mm(),
        bounds,
        gain.percent());
  }

  private void quality(Diagnosis d) {
    TreeSet<Double> horizons = new TreeSet<>(d.base().predictionErrorMm().keySet());
    StringBuilder head = new StringBuilder(String.format("%-22s %9s %9s", "mm", "fit", "held out"));
    horizons.forEach(h -> head.append(String.format("%13s", plain(h) + " s ahead")));
    line("%s", head);
    row("calibrated model", d.base(), horizons);
    if (!d.causes().isEmpty()) {
      row("with the causes", d.extended(), horizons);
    }
    line("%-22s %9s", "noise of the cameras", mm(d.base().noiseMm()));
  }

  private void row(String name, Quality quality, TreeSet<Double> horizons) {
    StringBuilder row =
        new StringBuilder(
            String.format("%-22s %9s %9s", name, mm(quality.rmsMm()), mm(quality.holdoutRmsMm())));
    for (double h : horizons) {
      double error = quality.predictionErrorMm().getOrDefault(h, Double.NaN);
      row.append(
          String.format(
              "%13s", Double.isNaN(error) ? "-" : String.format(Locale.ROOT, "%.1f", error)));
    }
    line("%s", row);
  }

  private static String plain(double horizon) {
    return horizon == Math.rint(horizon) ? Long.toString((long) horizon) : Double.toString(horizon);
  }

  private static String mm(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.2f", value) : "-";
  }

  private void remains(Diagnosis d) {
    Unexplained u = d.unexplained();
    if (!u.significant()) {
      if (d.verdict() != Verdict.MODEL_ADEQUATE) {
        line("What remains is no more than noise.");
      }
      return;
    }
    String on =
        u.dependsOn().stream()
            .map(StructureVariable::id)
            .map(id -> id.replace('_', ' '))
            .collect(Collectors.joining(", "));
    line("Unexplained: %s mm%s.", mm(u.systematicMm()), on.isEmpty() ? "" : ", depending on " + on);
  }

  private void sources(DiagnosisOutcome outcome) {
    Diagnosis d = outcome.diagnosis();
    int found = outcome.calibration().data().kicks().size();
    int used = outcome.problem().fits().size();
    line("%d of %d kicks%s, seed %d", used, found, commands(outcome), d.seed());
    List<DataProblem> problems = outcome.calibration().data().problems();
    problems.stream()
        .limit(MOST_PROBLEMS)
        .forEach(p -> wrapped("in the data: ", "  ", p.toString()));
    if (problems.size() > MOST_PROBLEMS) {
      line("in the data: %d more, see diagnosis.json", problems.size() - MOST_PROBLEMS);
    }
  }

  private static String commands(DiagnosisOutcome outcome) {
    int told = outcome.calibration().commands().size();
    int fitting = outcome.problem().commands().size();
    if (told == 0) {
      return "";
    }
    return fitting == 0
        ? ", none of the " + told + " commands fits one in time (clocks?)"
        : ", " + fitting + " with their commands";
  }

  private void line(String format, Object... args) {
    out.println(String.format(Locale.ROOT, format, args));
  }

  /** Breaks at spaces. */
  private void wrapped(String first, String others, String text) {
    StringBuilder row = new StringBuilder(first);
    boolean empty = true;
    for (String word : text.split(" ")) {
      if (!empty && row.length() + 1 + word.length() > WIDTH) {
        out.println(row);
        row = new StringBuilder(others);
        empty = true;
      }
      row.append(empty ? "" : " ").append(word);
      empty = false;
    }
    out.println(row);
  }
}
