package fieldcal.diagnosis;

import fieldcal.benchmark.Goal;
import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.diagnosis.hidden.HiddenRun.Times;
import fieldcal.diagnosis.hidden.Judgement;
import fieldcal.diagnosis.hidden.Judgement.Found;
import fieldcal.diagnosis.hidden.Judgement.How;
import fieldcal.diagnosis.hidden.Judgement.Outcome;
import fieldcal.diagnosis.hidden.Judgement.Strength;
import fieldcal.diagnosis.hidden.StudiedCase;
import fieldcal.diagnosis.hidden.Visibility.Class;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What a study showed: confusion, rates beside their goals, times, and every case that went wrong. */
final class StudySummary {
  private static final double SIGMAS = 3;
  private static final double PERCENT = 15;
  private static final double FLOOR = 1.05;

  private final List<StudiedCase> cases;

  StudySummary(List<StudiedCase> cases) {
    this.cases = List.copyOf(cases);
  }

  void print(PrintStream out) {
    out.printf("%n== What was hidden, and what was said ==%n");
    confusion(out);
    out.printf("%n== Rates ==%n");
    rates(out);
    out.printf("%n== Times of a case, s ==%n");
    times(out, "simulation", Times::simulation);
    times(out, "calibration", Times::calibration);
    times(out, "diagnosis", Times::diagnosis);
    out.printf("%n== Cases that are not as they should be ==%n");
    cases.stream().filter(c -> !c.asItShouldBe()).forEach(out::println);
  }

  /** One line for each hidden effect and class; most of a square table would be empty. */
  private void confusion(PrintStream out) {
    Map<String, List<StudiedCase>> rows =
        cases.stream()
            .filter(c -> c.hidden().category() != Category.PAIR)
            .collect(
                Collectors.groupingBy(
                    c -> c.hidden().label() + " " + level(c), TreeMap::new, Collectors.toList()));
    rows.forEach(
        (row, list) -> {
          Map<String, Long> said =
              list.stream()
                  .collect(
                      Collectors.groupingBy(
                          StudySummary::said, TreeMap::new, Collectors.counting()));
          out.printf(Locale.ROOT, "%-45s %3d: %s%n", row, list.size(), counts(said));
        });
    long pairs = of(Category.PAIR).count();
    out.printf(
        "pairs %d: %s%n",
        pairs,
        counts(
            of(Category.PAIR)
                .collect(
                    Collectors.groupingBy(
                        c -> c.outcome().map(Enum::name).orElse("FAILED"),
                        TreeMap::new,
                        Collectors.counting()))));
  }

  private static String counts(Map<String, Long> map) {
    return map.entrySet().stream()
        .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
        .map(e -> e.getKey() + " " + e.getValue())
        .collect(Collectors.joining(", "));
  }

  private static String level(StudiedCase c) {
    return c.hidden().hidden().isEmpty() ? "" : c.level().name().toLowerCase(Locale.ROOT);
  }

  private static String said(StudiedCase c) {
    return switch (c.outcome().map(Enum::name).orElse("FAILED")) {
      case "TIE" -> "tie with " + c.names();
      case "WRONG" -> "WRONG " + c.names();
      default -> c.names();
    };
  }

  private Stream<StudiedCase> of(Category category) {
    return cases.stream().filter(c -> c.hidden().category() == category);
  }

  private List<StudiedCase> singles(Class level) {
    return of(Category.SINGLE).filter(c -> c.level() == level).toList();
  }

  private static Predicate<StudiedCase> came(Outcome... outcomes) {
    return c -> c.outcome().isPresent() && List.of(outcomes).contains(c.outcome().get());
  }

  private void rates(PrintStream out) {
    List<StudiedCase> clear = singles(Class.CLEAR);
    rate(out, "clear: right name", clear, came(Outcome.RIGHT), atLeast(97));
    rate(out, "clear: right name or tie", clear, came(Outcome.RIGHT, Outcome.TIE), none());
    rate(out, "clear: wrong name", clear, came(Outcome.WRONG), atMost(1));
    List<StudiedCase> marginal = singles(Class.MARGINAL);
    rate(out, "marginal: right or tie", marginal, came(Outcome.RIGHT, Outcome.TIE), atLeast(85));
    rate(out, "marginal: wrong name", marginal, came(Outcome.WRONG), atMost(3));
    rate(out, "invisible: wrong name", singles(Class.INVISIBLE), came(Outcome.WRONG), none());
    List<StudiedCase> nulls = of(Category.NULL).toList();
    rate(out, "nothing there: false alarm", nulls, c -> !came(Outcome.RIGHT).test(c), atMost(1));
    List<StudiedCase> pairs = of(Category.PAIR).toList();
    rate(out, "pairs: both found", pairs, StudySummary::bothFound, none());
    List<StudiedCase> visible = pairs.stream().filter(c -> c.level() != Class.INVISIBLE).toList();
    // What cannot be seen alone cannot be asked for.
    rate(out, "pairs, both visible: both found", visible, StudySummary::bothFound, atLeast(90));
    List<StudiedCase> bright = pairs.stream().filter(c -> c.level() == Class.CLEAR).toList();
    rate(out, "pairs, both clear: both found", bright, StudySummary::bothFound, none());
    rate(out, "pairs: no wrong name", pairs, came(Outcome.WRONG).negate(), atLeast(95));
    List<StudiedCase> unknown =
        of(Category.UNKNOWN).filter(c -> c.level() != Class.INVISIBLE).toList();
    rate(
        out,
        "unknown to the catalogue: none blamed",
        unknown,
        came(Outcome.WRONG).negate(),
        none());
    rate(out, "unknown: said to be unexplained", unknown, came(Outcome.RIGHT), none());
    strengths(out);
    List<StudiedCase> found = clear.stream().filter(came(Outcome.RIGHT)).toList();
    rate(
        out,
        "clear and found: held out within 5 % of the noise",
        found,
        c -> c.rmsAfter() < FLOOR,
        atLeast(97));
    rate(
        out,
        "clear and found: lower bound of the gain positive",
        found,
        c -> c.judgement().get().found().get(0).cause().get().gain().lowMm() > 0,
        none());
    rate(out, "failed", cases, c -> c.judgement().isEmpty(), atMost(0));
  }

  private static boolean bothFound(StudiedCase c) {
    return c.judgement().isPresent()
        && c.judgement().get().found().stream().allMatch(f -> f.how() != How.NOT);
  }

  private void strengths(PrintStream out) {
    List<Strength> all = strengths(c -> true);
    List<Strength> errors = all.stream().filter(s -> !Double.isNaN(s.sigmas())).toList();
    rate(out, "strength within 3 standard errors", errors, s -> s.sigmas() < SIGMAS, atLeast(97));
    List<Strength> clear =
        strengths(f -> f.visibility().level() == Class.CLEAR).stream()
            .filter(s -> !Double.isNaN(s.percent()))
            .toList();
    rate(out, "strength within 15 %, clear", clear, s -> s.percent() < PERCENT, atLeast(97));
  }

  private List<Strength> strengths(Predicate<Found> which) {
    return of(Category.SINGLE)
        .flatMap(c -> c.judgement().stream())
        .map(Judgement::found)
        .flatMap(List::stream)
        .filter(which)
        .flatMap(f -> f.strength().stream())
        .toList();
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
    boolean asked = !goal.equals(none());
    out.printf(
        Locale.ROOT,
        "%-52s %4d of %4d  %5.1f %%  %s%n",
        what,
        hits,
        list.size(),
        percent,
        asked && !list.isEmpty() ? goal + "  " + goal.verdict(percent) : "");
  }

  private void times(PrintStream out, String stage, ToDoubleFunction<Times> time) {
    double[] sorted =
        cases.stream()
            .filter(c -> c.judgement().isPresent())
            .mapToDouble(c -> time.applyAsDouble(c.times()))
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
