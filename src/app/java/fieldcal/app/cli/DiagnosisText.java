package fieldcal.app.cli;

import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.calibrate.ResultFiles;
import fieldcal.app.diagnose.CalibrationBeside;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.LeftOutKick;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.wording.Amount;
import fieldcal.app.wording.CauseText;
import fieldcal.app.wording.CauseWords;
import fieldcal.app.wording.Certainty;
import fieldcal.app.wording.NextKicks;
import fieldcal.app.wording.PublishWords;
import fieldcal.app.wording.StructureWords;
import fieldcal.app.wording.VerdictText;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.Unexplained;
import fieldcal.diagnosis.Verdict;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Prints a diagnosis for the operator's terminal: words first, then numbers; some forty lines of a hundred columns at most. */
final class DiagnosisText {
  private static final int MOST_PROBLEMS = 3;

  /** Kicks that are named for each reason why they were left out. */
  private static final int MOST_LEFT_OUT = 8;

  /** Of more causes only what is wrong is said; what it does and what to do about it is in the report. */
  private static final int MOST_IN_FULL = 3;

  /** A share of a residual that two readers would not call the same; chosen. */
  private static final double MUCH_LESS = 0.9;

  private final PrintWriter out;

  DiagnosisText(PrintWriter out) {
    this.out = out;
  }

  void print(DiagnosisOutcome outcome, Path directory) {
    Diagnosis diagnosis = outcome.diagnosis();
    VerdictText verdict = VerdictText.of(diagnosis);
    wrapped("", "", verdict.first());
    if (diagnosis.verdict() == Verdict.MODEL_ADEQUATE) {
      line("%s", quality(diagnosis));
      if (VerdictText.hasFewKicks(diagnosis)) {
        wrapped("", "", VerdictText.SMALL_CAUSES);
      }
    } else {
      causes(outcome);
      learned(outcome);
      if (diagnosis.verdict() == Verdict.UNEXPLAINED_STRUCTURE) {
        line("");
        verdict.lines().forEach(text -> wrapped("", "", text));
      }
      line("");
      table(diagnosis);
      if (calibrateShowsLess(outcome)) {
        wrapped("", "", VerdictText.WITHOUT_OFFSETS);
      }
    }
    if (diagnosis.verdict() != Verdict.UNEXPLAINED_STRUCTURE) {
      VerdictText.failures(diagnosis).forEach(text -> wrapped("", "", text));
    }
    recordings(outcome, directory);
    out.flush();
  }

  /** What the diagnosis makes of a calibration that was in the directory before. */
  void model(CalibrationBeside beside, DiagnosisOutcome outcome, Path directory) {
    String headline = PublishWords.of(outcome.judged().verdict()).headline();
    switch (beside) {
      case NONE ->
          ResultFiles.CALIBRATION
              .ofOthers(directory, MadeFrom.of(outcome.calibration()))
              .ifPresent(
                  others -> {
                    line("");
                    wrapped("", "", others);
                  });
      case JUDGED_AGAIN -> {
        line("");
        wrapped(
            "",
            "",
            "The files of calibrate in " + directory + " now count this diagnosis. " + headline);
      }
      case OUTDATED -> {
        line("");
        wrapped(
            "",
            "",
            "The files of calibrate in "
                + directory
                + " do not count this diagnosis: run calibrate again with the same options. "
                + headline);
      }
    }
    out.flush();
  }

  /** The one line of numbers that a model without faults needs. */
  private static String quality(Diagnosis d) {
    return String.format(
        Locale.ROOT,
        "%d %s to %s mm; the cameras' noise is %s mm.",
        d.kicks().size(),
        d.kicks().size() == 1 ? "kick fits" : "kicks fit",
        mm(d.base().rmsMm()),
        mm(d.base().noiseMm()));
  }

  private void causes(DiagnosisOutcome outcome) {
    Diagnosis diagnosis = outcome.diagnosis();
    CauseWords words = new CauseWords(diagnosis, outcome.problem().observers());
    boolean full = diagnosis.causes().size() <= MOST_IN_FULL;
    Set<String> said = new HashSet<>();
    int number = 1;
    for (Cause cause : diagnosis.causes()) {
      CauseText text = words.of(cause);
      if (full || number == 1) {
        line("");
      }
      wrapped(number++ + ". ", "   ", full ? text.sentences() : text.what());
      wrapped(
          "   ",
          "   ",
          text.strength()
              + "; "
              + Certainty.of(cause.evidence())
              + ". "
              + gainSentence(cause.gain()));
      String rivals = CauseWords.rivals(cause);
      if (!rivals.isEmpty()) {
        wrapped("   ", "   ", rivals);
      }
      String next = NextKicks.toTellApart(cause.effect().id(), cause.indistinguishableFrom());
      if (!next.isEmpty() && said.add(next)) {
        wrapped("   ", "   ", NextKicks.introduced(next));
      }
    }
  }

  /** Whether a reader of both wonders which residual is right. */
  private static boolean calibrateShowsLess(DiagnosisOutcome outcome) {
    return outcome
        .calibration()
        .calibration()
        .joint()
        .filter(joint -> joint.oneModel().rmsMm() < MUCH_LESS * outcome.diagnosis().base().rmsMm())
        .isPresent();
  }

  /** What has no name: an item each. */
  private void learned(DiagnosisOutcome outcome) {
    Diagnosis diagnosis = outcome.diagnosis();
    List<LearnedFinding> laws = new ArrayList<>();
    List<LearnedFinding> helping = new ArrayList<>();
    List<LearnedFinding> others = new ArrayList<>();
    for (LearnedFinding f : diagnosis.learned()) {
      (f.kind() == LearnedFinding.Kind.LAW ? laws : f.isShownToHelp() ? helping : others).add(f);
    }
    if (!diagnosis.learned().isEmpty()) {
      line("");
    }
    items(outcome, "A law that replaces a law of the calibrated model:", laws);
    items(outcome, "What helps without a proven cause:", helping);
    items(outcome, "In the extended model, but held-out kicks do not show that it helps:", others);
  }

  private void items(DiagnosisOutcome outcome, String title, List<LearnedFinding> findings) {
    if (findings.isEmpty()) {
      return;
    }
    CauseWords words = new CauseWords(outcome.diagnosis(), outcome.problem().observers());
    line("%s", title);
    for (LearnedFinding finding : findings) {
      CauseText text = words.of(finding);
      wrapped("-  ", "   ", text.what() + " " + gainSentence(finding.gain()));
    }
  }

  private static String gainSentence(Gain gain) {
    if (!Double.isFinite(gain.mm())) {
      return "There are too few kicks to tell the gain.";
    }
    String bounds =
        Double.isFinite(gain.lowMm() + gain.highMm())
            ? "; 95 % bounds " + Amount.of(gain.lowMm()) + " to " + Amount.of(gain.highMm()) + " mm"
            : "";
    return "It reduces the rms of held-out kicks by "
        + Amount.of(gain.mm())
        + " mm ("
        + Amount.decimals(gain.percent(), 0)
        + " %"
        + bounds
        + ").";
  }

  private void table(Diagnosis d) {
    TreeSet<Double> horizons = new TreeSet<>(d.base().typicalErrorMm().keySet());
    StringBuilder head = new StringBuilder(String.format("%-21s%8s%10s", "mm", "fit", "held out"));
    horizons.forEach(h -> head.append(String.format("%13s", seconds(h) + " s ahead")));
    line("%s", head);
    row("calibrated model", d.base(), horizons);
    if (!d.causes().isEmpty() || !d.learned().isEmpty()) {
      row("extended model", d.extended(), horizons);
    }
    line("%-21s%8s", "noise of the cameras", mm(d.base().noiseMm()));
    if (d.verdict() != Verdict.UNEXPLAINED_STRUCTURE) {
      VerdictText.farWorse(d).ifPresent(text -> wrapped("", "", text));
    }
    Unexplained rest = d.unexplained();
    if (!rest.significant()) {
      line("What remains is no more than noise.");
    } else if (d.verdict() != Verdict.UNEXPLAINED_STRUCTURE) {
      String on =
          rest.dependsOn().stream()
              .limit(2)
              .map(StructureWords::of)
              .collect(Collectors.joining(" and "));
      wrapped(
          "",
          "",
          String.format(
              "%s mm beyond the noise remain unexplained%s.",
              mm(rest.systematicMm()), on.isEmpty() ? "" : ", depending on " + on));
    }
    if (d.verdict() == Verdict.PARTLY_EXPLAINED) {
      wrapped("", "", VerdictText.advice(d));
    } else if (d.verdict() == Verdict.EXPLAINED) {
      VerdictText.caveat(d).ifPresent(text -> wrapped("", "", text));
    }
  }

  private void row(String name, Quality quality, TreeSet<Double> horizons) {
    StringBuilder row =
        new StringBuilder(
            String.format("%-21s%8s%10s", name, mm(quality.rmsMm()), mm(quality.holdoutRmsMm())));
    for (double h : horizons) {
      double error = quality.typicalErrorMm().getOrDefault(h, Double.NaN);
      row.append(String.format("%13s", Amount.decimals(error, 1)));
    }
    line("%s", row);
  }

  private static String seconds(double horizon) {
    return horizon == Math.rint(horizon) ? Long.toString((long) horizon) : Double.toString(horizon);
  }

  private static String mm(double value) {
    return Amount.decimals(value, 2);
  }

  private void recordings(DiagnosisOutcome outcome, Path directory) {
    line("");
    line(
        "%d of %d %s used%s, seed %d",
        outcome.diagnosis().kicks().size(),
        outcome.calibration().data().kicks().size(),
        outcome.calibration().data().kicks().size() == 1 ? "kick" : "kicks",
        commands(outcome),
        outcome.diagnosis().seed());
    leftOut(outcome);
    List<DataProblem> problems = DataProblem.folded(outcome.calibration().data().problems());
    if (!problems.isEmpty()) {
      line("In the data:");
    }
    for (DataProblem p : problems.subList(0, Math.min(MOST_PROBLEMS, problems.size()))) {
      wrapped("  ", "    ", p.toString());
    }
    if (problems.size() > MOST_PROBLEMS) {
      line("  %d more, see diagnosis.json", problems.size() - MOST_PROBLEMS);
    }
    if (directory != null) {
      line("report: %s", directory.resolve("diagnosis.html"));
    }
  }

  private void leftOut(DiagnosisOutcome outcome) {
    Map<String, List<LeftOutKick>> byReason =
        LeftOutKick.of(outcome).stream()
            .collect(Collectors.groupingBy(LeftOutKick::reason, TreeMap::new, Collectors.toList()));
    byReason.forEach(
        (reason, kicks) -> {
          String ids =
              kicks.stream()
                  .limit(MOST_LEFT_OUT)
                  .map(k -> Integer.toString(k.kick().id()))
                  .collect(Collectors.joining(", "));
          String more =
              kicks.size() > MOST_LEFT_OUT
                  ? " and " + (kicks.size() - MOST_LEFT_OUT) + " more"
                  : "";
          wrapped(
              "  ",
              "    ",
              String.format(
                  "Left out: %s %s%s: %s.",
                  kicks.size() == 1 ? "kick" : "kicks", ids, more, reason));
        });
  }

  private static String commands(DiagnosisOutcome outcome) {
    int told = outcome.calibration().commands().size();
    int fitting = outcome.problem().commands().size();
    if (told == 0) {
      return "";
    }
    return fitting == 0
        ? ", none of which belongs to any of the "
            + told
            + " commands (are they of another recording, or do the clocks differ?)"
        : ", " + fitting + " with their commands";
  }

  private void line(String format, Object... args) {
    out.println(String.format(Locale.ROOT, format, args));
  }

  private void wrapped(String first, String others, String text) {
    new WrappedText(out).print(first, others, text);
  }
}
