package fieldcal.app.cli;

import fieldcal.app.statistics.Comparison;
import fieldcal.app.twin.TwinCheck;
import fieldcal.app.twin.TwinOutcome;
import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Prints a twin and its check for the terminal. */
final class TwinText {
  private final PrintWriter out;

  TwinText(PrintWriter out) {
    this.out = out;
  }

  void print(TwinOutcome outcome, Path directory) {
    TwinCheck check = outcome.check();
    List<Comparison> different = check.different();
    int all = check.comparisons().size();
    line(
        "The twin behaves like the field in %d of %d statistics; %d of %d kicks were found again.",
        all - different.size(), all, check.found(), check.kicks());
    if (!check.sentences().isEmpty()) {
      line("%nWhat the twin does not reproduce:");
      check.sentences().forEach(s -> line("- %s", s));
    }
    line("%n%-46s %20s %20s   apart", "", "recording", "twin");
    for (TwinCheck.Parameter p : check.parameters()) {
      line(
          "%-46s %20s %20s   %.1f σ",
          ParameterWords.withUnit(p.name()),
          Amount.withError(p.recorded(), p.recordedError()),
          Amount.withError(p.twin(), p.twinError()),
          p.sigmas());
    }
    List<String> causes = new ArrayList<>(outcome.causes());
    int learned = outcome.twin().settings().physics().extras().size();
    if (learned > 0) {
      causes.add(learned + (learned == 1 ? " learned law" : " learned laws") + " of the ball");
    }
    if (!causes.isEmpty()) {
      line("%nCauses in the twin:");
      causes.forEach(e -> line("- %s", e));
    }
    if (!outcome.twin().notes().isEmpty()) {
      line("%nAssumed, or left out:");
      outcome.twin().notes().forEach(n -> line("- %s", n));
    }
    line(
        "%nsettings: %s%nreport: %s",
        directory.resolve("twin.json"), directory.resolve("twin.html"));
    out.flush();
  }

  private void line(String format, Object... args) {
    out.println(String.format(Locale.ROOT, format, args));
  }
}
