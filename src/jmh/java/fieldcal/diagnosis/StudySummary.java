package fieldcal.diagnosis;

import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.benchmark.ShareGoal;
import java.io.PrintStream;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** What a study showed: confusion, rates of each group beside their goals, sizes, times, and every case that went wrong. */
final class StudySummary {
  /** Two standard errors hold 95 % of normal errors. */
  private static final double SCORE = 2;

  private static final double EXPECTED_WITHIN = 95;
  private static final double WITHIN_TOLERANCE = 3;

  /** Residual of held-out kicks that still counts as the noise, trouble of the cameras included. */
  private static final double FLOOR = 1.1;

  /** Share of the excess that must go. */
  private static final double REDUCED = 0.7;

  /** Below that there is no excess worth a ratio, in units of the noise. */
  private static final double EXCESS = 1.1;

  private static final double PERCENT = 15;

  /** Which of the times of a case that is. */
  private static final int DIAGNOSIS = 2;

  private final List<CaseRow> cases;

  StudySummary(List<CaseRow> cases) {
    this.cases = cases.stream().sorted(Comparator.comparingLong(CaseRow::seed)).toList();
  }

  void print(PrintStream out) {
    out.printf("%n== What was hidden, and what was said ==%n");
    confusion(out);
    out.printf("%n== Rates ==%n");
    rates(out);
    out.printf("%n== Times of a case, s ==%n");
    times(out, "simulation", 0);
    times(out, "calibration", 1);
    times(out, "diagnosis", DIAGNOSIS);
    out.printf("%n== Cases that are not as they should be ==%n");
    cases.stream().filter(c -> !c.expected()).map(CaseRow::text).forEach(out::println);
  }

  /** The rates whose goals the studies state, for so few cases as a page has. */
  void tell(Findings findings) {
    List<CaseRow> clear = group("clear");
    List<CaseRow> marginal = group("marginal");
    List<CaseRow> nulls = group("null");
    List<CaseRow> unnamed = group("unnamed").stream().filter(CaseRow::shown).toList();
    List<CaseRow> several = cases.stream().filter(c -> c.group().matches("pair|mixture")).toList();
    List<CaseRow> fitted = several.stream().filter(c -> !Double.isNaN(c.rmsAfter())).toList();
    List<Double> scores = cases.stream().flatMap(c -> c.scores().stream()).toList();
    share(findings, "clear single causes, right name", clear, CaseRow::right, true, 0.99);
    share(findings, "… wrong name", clear, c -> c.wrong() > 0, false, 0.005);
    share(findings, "marginal single causes, right name", marginal, CaseRow::right, true, 0.93);
    share(findings, "… wrong name", marginal, c -> c.wrong() > 0, false, 0.02);
    String alarm = "nothing hidden, something found or called unexplained";
    share(findings, alarm, nulls, c -> !c.right(), false, 0.005);
    String noise = "several causes, held-out kicks within 10 % of the noise";
    share(findings, noise, fitted, c -> c.rmsAfter() <= FLOOR, true, 0.9);
    share(findings, "in no catalogue, a wrong name", unnamed, c -> c.wrong() > 0, false, 0.03);
    String sizes = "sizes within two of their standard errors";
    int within = (int) scores.stream().filter(s -> s <= SCORE).count();
    findings.share(sizes, within, scores.size(), 0.92, 0.98);
    double[] times =
        cases.stream()
            .filter(c -> !c.failed())
            .mapToDouble(CaseRow.timeOf(DIAGNOSIS))
            .sorted()
            .toArray();
    if (times.length > 0) {
      findings.value(
          "time of a diagnosis, one core, median",
          "%.1f s",
          times[times.length / 2],
          Goal.atMost(5, "%.0f s"));
      findings.note(
          "time of a diagnosis, longest",
          String.format(Locale.ROOT, "%.0f s", times[times.length - 1]));
    }
  }

  private static <T> void share(
      Findings findings, String what, List<T> of, Predicate<T> test, boolean least, double limit) {
    int count = (int) of.stream().filter(test).count();
    findings.share(what, count, of.size(), new ShareGoal(limit, least));
  }

  /** One line for each hidden effect and group; most of a square table would be empty. */
  private void confusion(PrintStream out) {
    Map<String, List<CaseRow>> rows =
        cases.stream()
            .collect(Collectors.groupingBy(StudySummary::row, TreeMap::new, Collectors.toList()));
    rows.forEach(
        (row, list) -> {
          Map<String, Long> said =
              list.stream()
                  .collect(
                      Collectors.groupingBy(
                          StudySummary::said, TreeMap::new, Collectors.counting()));
          out.printf(Locale.ROOT, "%-45s %3d: %s%n", row, list.size(), counts(said));
        });
  }

  private static String row(CaseRow c) {
    return switch (c.group()) {
      case "pair", "mixture" -> c.group();
      case "null" -> "nothing";
      default -> c.hidden() + " " + c.group();
    };
  }

  private static String counts(Map<String, Long> map) {
    return map.entrySet().stream()
        .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
        .map(e -> e.getKey() + " " + e.getValue())
        .collect(Collectors.joining(", "));
  }

  private static String said(CaseRow c) {
    if (c.group().equals("pair") || c.group().equals("mixture")) {
      return c.outcome();
    }
    return switch (c.outcome()) {
      case "TIE" -> "tie with " + c.said();
      case "WRONG" -> "WRONG " + c.said();
      default -> c.said();
    };
  }

  private List<CaseRow> group(String name) {
    return cases.stream().filter(c -> c.group().equals(name)).toList();
  }

  private void rates(PrintStream out) {
    List<CaseRow> clear = group("clear");
    rate(out, "clear: right name or tie", clear, CaseRow::right, atLeast(97));
    rate(out, "clear: wrong name", clear, c -> c.wrong() > 0, atMost(1));
    fits(out, "clear", clear);
    List<CaseRow> marginal = group("marginal");
    rate(out, "marginal: right name or tie", marginal, CaseRow::right, atLeast(85));
    rate(out, "marginal: wrong name", marginal, c -> c.wrong() > 0, atMost(3));
    rate(out, "invisible: wrong name", group("invisible"), c -> c.wrong() > 0, none());
    List<CaseRow> nulls = group("null");
    rate(out, "nothing there: false alarm", nulls, c -> !c.right(), atMost(1));
    for (String name : List.of("pair", "mixture")) {
      List<CaseRow> several = group(name);
      rate(out, name + ": recording complete", several, CaseRow::complete, none());
      rate(out, name + ": no wrong name", several, c -> c.wrong() == 0, atLeast(95));
      share(out, name + ": visible causes named", several);
      fits(out, name, several);
    }
    List<CaseRow> unnamed = group("unnamed").stream().filter(CaseRow::shown).toList();
    rate(out, "unnamed, visible: no wrong name", unnamed, c -> c.wrong() == 0, atLeast(95));
    rate(out, "unnamed, visible: said or learned", unnamed, c -> !c.variable().equals("-"), none());
    rate(
        out,
        "unnamed, visible: right variable first",
        unnamed,
        c -> c.variable().equals("yes"),
        none());
    share(out, "unnamed: visible named causes beside it", unnamed);
    fits(out, "unnamed, visible", unnamed);
    sizes(out);
    rate(out, "failed", cases, CaseRow::failed, atMost(0));
  }

  /** How well kicks that were held out are described, and how much of what the simple model leaves is gone. */
  private static void fits(PrintStream out, String name, List<CaseRow> list) {
    List<CaseRow> done = list.stream().filter(c -> !Double.isNaN(c.rmsAfter())).toList();
    rate(
        out, name + ": held out within 1.1 of the noise", done, c -> c.rmsAfter() <= FLOOR, none());
    List<CaseRow> excess = done.stream().filter(c -> c.rmsBefore() > EXCESS).toList();
    rate(out, name + ": excess reduced by 70 %", excess, c -> c.excessReduced() >= REDUCED, none());
  }

  private void sizes(PrintStream out) {
    List<Double> scores = cases.stream().flatMap(c -> c.scores().stream()).toList();
    long within = scores.stream().filter(s -> s <= SCORE).count();
    double percent = scores.isEmpty() ? Double.NaN : 100.0 * within / scores.size();
    print(
        out,
        "sizes within 2 standard errors",
        within,
        scores.size(),
        Math.abs(percent - EXPECTED_WITHIN) <= WITHIN_TOLERANCE
            ? "95 ± 3 %  met"
            : "95 ± 3 %  missed");
    List<Double> percents =
        cases.stream()
            .filter(c -> c.group().equals("clear"))
            .flatMap(c -> c.percents().stream())
            .toList();
    rate(out, "clear: size within 15 %", percents, p -> p < PERCENT, atLeast(97));
  }

  private static void share(PrintStream out, String what, List<CaseRow> list) {
    long visible = list.stream().mapToLong(CaseRow::visible).sum();
    long found = list.stream().mapToLong(CaseRow::found).sum();
    print(out, what, found, visible, "");
  }

  private static Goal atLeast(double percent) {
    return Goal.atLeast(percent, "%.0f %%");
  }

  private static Goal atMost(double percent) {
    return Goal.atMost(percent, "%.0f %%");
  }

  /** Reported, but nobody asked for a number. */
  private static Goal none() {
    return Goal.atLeast(Double.NEGATIVE_INFINITY, "");
  }

  private static <T> void rate(
      PrintStream out, String what, List<T> list, Predicate<T> test, Goal goal) {
    long hits = list.stream().filter(test).count();
    double percent = list.isEmpty() ? Double.NaN : 100.0 * hits / list.size();
    boolean asked = !goal.equals(none()) && !list.isEmpty();
    print(out, what, hits, list.size(), asked ? goal + "  " + goal.verdict(percent) : "");
  }

  private static void print(PrintStream out, String what, long hits, long of, String goal) {
    double percent = of == 0 ? Double.NaN : 100.0 * hits / of;
    out.printf(Locale.ROOT, "%-52s %4d of %4d  %5.1f %%  %s%n", what, hits, of, percent, goal);
  }

  private void times(PrintStream out, String stage, int index) {
    double[] sorted =
        cases.stream()
            .filter(c -> !c.failed())
            .mapToDouble(CaseRow.timeOf(index))
            .sorted()
            .toArray();
    if (sorted.length > 0) {
      out.printf(
          Locale.ROOT,
          "%-12s median %.1f, 95 %% below %.1f, longest %.1f%n",
          stage,
          sorted[sorted.length / 2],
          sorted[(int) (0.95 * sorted.length)],
          sorted[sorted.length - 1]);
    }
  }
}
