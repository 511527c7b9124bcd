package fieldcal.app.compare;

import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.report.Problem;
import fieldcal.app.report.Provenance;
import fieldcal.app.report.ReportPage;
import fieldcal.app.report.Rounded;
import fieldcal.app.statistics.Comparison;
import fieldcal.app.wording.EffectName;
import fieldcal.diagnosis.Cause;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** {@code compare.html}. The same outcome gives the same bytes. */
final class ComparePage {
  private static final ReportPage PAGE =
      new ReportPage(
          "Field and simulator",
          "compare.json",
          "compare.html",
          "compare.css",
          List.of("compare.js"));

  private ComparePage() {}

  /** What the scripts find in the page. */
  private record Contents(
      Provenance provenance,
      List<String> simSources,
      String verdict,
      @Rounded(3) double passReal,
      @Rounded(3) double passSim,
      List<Ahead> prediction,
      List<Line> differences,
      List<String> realCauses,
      List<String> simCauses,
      List<Line> parameters,
      List<Line> cameras,
      List<Line> others,
      List<Problem> problems) {}

  private record Ahead(@Rounded(1) double seconds, @Rounded(1) double mm) {}

  private record Line(
      String words,
      String unit,
      @Rounded(5) double real,
      @Rounded(5) double realError,
      @Rounded(5) double sim,
      @Rounded(5) double simError,
      boolean differs,
      @Rounded(3) double shareOfError,
      @Rounded(3) double shareOfPass) {
    static Line of(Row r) {
      return new Line(
          r.words(),
          r.unit(),
          r.real(),
          r.realError(),
          r.sim(),
          r.simError(),
          r.differs(),
          Double.NaN,
          Double.NaN);
    }

    static Line of(FieldComparison.Named n) {
      return new Line(
          n.words(),
          n.unit(),
          n.real(),
          n.realError(),
          n.sim(),
          n.simError(),
          true,
          n.shareOfError(),
          n.shareOfPass());
    }

    static Line of(Comparison c) {
      return new Line(
          c.statistic().words(),
          c.statistic().unit(),
          c.first(),
          Double.NaN,
          c.second(),
          Double.NaN,
          c.differs(FieldComparison.ALPHA),
          Double.NaN,
          Double.NaN);
    }
  }

  static void write(CompareSession.Outcome outcome, Path file) throws IOException {
    FieldComparison c = outcome.comparison();
    Side real = outcome.real();
    List<Ahead> ahead = new ArrayList<>();
    c.predictionError().forEach((h, e) -> ahead.add(new Ahead(h, 1000 * e)));
    Contents contents =
        new Contents(
            Provenance.of(
                logs(real),
                real.diagnosis().calibration().data(),
                real.diagnosis().problem().seed()),
            logs(outcome.sim()),
            c.verdict(),
            c.passReal(),
            c.passSim(),
            ahead,
            c.differences().stream().map(Line::of).toList(),
            causes(real),
            causes(outcome.sim()),
            c.parameters().stream().map(Line::of).toList(),
            c.cameras().stream().map(Line::of).toList(),
            c.others().stream().map(Line::of).toList(),
            Stream.of(real, outcome.sim())
                .flatMap(s -> s.diagnosis().calibration().data().problems().stream())
                .map(Problem::of)
                .toList());
    String title =
        String.format(Locale.ROOT, "Field and simulator: %d differences", c.differences().size());
    JsonFiles.write(PAGE.html(title, contents).getBytes(StandardCharsets.UTF_8), file);
  }

  private static List<String> logs(Side side) {
    return side.diagnosis().calibration().logs().stream().map(Path::toString).toList();
  }

  private static List<String> causes(Side side) {
    return side.diagnosis().diagnosis().causes().stream()
        .map((Cause cause) -> EffectName.of(cause))
        .toList();
  }
}
