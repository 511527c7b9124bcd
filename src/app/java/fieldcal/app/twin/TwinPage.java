package fieldcal.app.twin;

import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.report.Problem;
import fieldcal.app.report.Provenance;
import fieldcal.app.report.ReportPage;
import fieldcal.app.report.Rounded;
import fieldcal.app.statistics.Comparison;
import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** {@code twin.html}: what the twin is, and how like the field it is. The same outcome gives the same bytes. */
final class TwinPage {
  private static final ReportPage PAGE =
      new ReportPage("Twin", "twin_check.json", "twin.html", "twin.css", List.of("twin.js"));

  private TwinPage() {}

  /** What the scripts find in the page. */
  private record Contents(
      Provenance provenance,
      int kicks,
      int found,
      int statistics,
      List<String> sentences,
      List<String> notes,
      List<String> causes,
      int learned,
      List<Row> parameters,
      List<Row> rows,
      List<Problem> problems) {}

  /** A line of a table; how far both are apart in standard errors. */
  private record Row(
      String words,
      String recorded,
      String twin,
      String unit,
      int samples,
      @Rounded(2) double sigmas,
      @Rounded(5) double p,
      boolean differs) {
    static Row of(Comparison c) {
      return new Row(
          c.statistic().words(),
          TwinWords.number(c.first()),
          TwinWords.number(c.second()),
          c.statistic().unit(),
          c.samples(),
          c.difference() == 0 ? 0 : c.difference() / c.error(),
          c.pHolm(),
          c.differs());
    }

    static Row of(TwinCheck.Parameter p) {
      return new Row(
          ParameterWords.withUnit(p.name()),
          Amount.withError(p.recorded(), p.recordedError()),
          Amount.withError(p.twin(), p.twinError()),
          "",
          0,
          p.sigmas(),
          Double.NaN,
          p.sigmas() > 2);
    }
  }

  static void write(TwinOutcome outcome, Path file) throws IOException {
    TwinCheck check = outcome.check();
    Contents contents =
        new Contents(
            Provenance.of(
                outcome.twin().sources(),
                outcome.diagnosis().calibration().data(),
                outcome.diagnosis().problem().seed()),
            check.kicks(),
            check.found(),
            check.comparisons().size(),
            check.sentences(),
            outcome.twin().notes(),
            outcome.causes(),
            outcome.twin().settings().physics().extras().size(),
            check.parameters().stream().map(Row::of).toList(),
            check.comparisons().stream().map(Row::of).toList(),
            outcome.diagnosis().calibration().data().problems().stream().map(Problem::of).toList());
    String title =
        String.format(Locale.ROOT, "Twin: %.0f %% of the statistics agree", 100 * check.share());
    JsonFiles.write(PAGE.html(title, contents).getBytes(StandardCharsets.UTF_8), file);
  }
}
