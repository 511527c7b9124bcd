package fieldcal.app.cli;

import fieldcal.app.compare.CompareSession;
import fieldcal.app.compare.FieldComparison;
import fieldcal.app.compare.FieldComparison.Named;
import fieldcal.app.compare.Row;
import fieldcal.app.statistics.Comparison;
import fieldcal.app.wording.Amount;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** Prints the comparison of a field with a simulator for the terminal. */
final class CompareText {
  private final PrintWriter out;

  CompareText(PrintWriter out) {
    this.out = out;
  }

  void print(CompareSession.Outcome outcome, Path directory) {
    FieldComparison c = outcome.comparison();
    line("%s", c.verdict());
    if (!c.differences().isEmpty()) {
      line("%n%-46s %25s %25s %7s %8s", "the ball", "field", "simulator", "error*", "pass**");
      for (Named n : c.differences()) {
        line(
            "%-46s %25s %25s %7s %8s",
            n.words(),
            value(n.real(), n.realError(), n.unit()),
            value(n.sim(), n.simError(), n.unit()),
            share(n.shareOfError()),
            metres(n.shareOfPass(), c));
      }
      line("*  share of the prediction error 1 s ahead");
      line(
          "** how much farther this difference alone lets a pass at %.0f m/s roll on the field",
          FieldComparison.PASS_SPEED);
      line("%nAn AI tuned on the simulator predicts the field's kicks wrong by");
      c.predictionError().forEach((h, e) -> line("  %5.0f mm %.1f s ahead", 1000 * e, h));
    }
    List<Comparison> cameras =
        c.cameras().stream()
            .filter(k -> k.differs(FieldComparison.ALPHA))
            .filter(k -> !value(k, k.first()).equals(value(k, k.second())))
            .toList();
    if (!cameras.isEmpty()) {
      line("%n%-44s %12s %12s", "cameras", "field", "simulator");
      for (Comparison k : cameras) {
        line("%-44s %12s %12s", k.statistic().words(), value(k, k.first()), value(k, k.second()));
      }
    }
    List<Row> others = c.others().stream().filter(Row::differs).toList();
    if (!others.isEmpty()) {
      line("%n%-34s %20s %20s", "kickers and robots", "field", "simulator");
      for (Row row : others) {
        line(
            "%-34s %20s %20s",
            row.words(),
            value(row.real(), row.realError(), row.unit()),
            value(row.sim(), row.simError(), row.unit()));
      }
    }
    if (directory != null) {
      line("%nreport: %s", directory.resolve("compare.html"));
    }
    out.flush();
  }

  private static String value(Comparison of, double value) {
    return value(value, Double.NaN, of.statistic().unit());
  }

  private static String value(double value, double error, String unit) {
    if (!Double.isFinite(value)) {
      return "–";
    }
    // Two figures of the error, so that none reads as zero.
    int decimals =
        Double.isFinite(error) && error > 0
            ? Math.max(0, Math.min(8, 1 - (int) Math.floor(Math.log10(error))))
            : 3;
    String number = "%." + decimals + "f";
    String text =
        Double.isFinite(error)
            ? String.format(Locale.ROOT, number + " ± " + number, value, error)
            : String.format(Locale.ROOT, number, value);
    return Amount.minus(text) + (unit.isEmpty() ? "" : " " + unit);
  }

  /** By how much farther a difference alone makes the pass roll on the field. */
  private static String metres(double share, FieldComparison c) {
    double more = share * (c.passReal() - c.passSim());
    return Double.isFinite(more) ? Amount.minus(String.format(Locale.ROOT, "%+.2f m", more)) : "–";
  }

  private static String share(double share) {
    return Double.isFinite(share)
        ? Amount.minus(String.format(Locale.ROOT, "%.0f %%", 100 * share))
        : "–";
  }

  private void line(String format, Object... args) {
    out.println(String.format(Locale.ROOT, format, args));
  }
}
