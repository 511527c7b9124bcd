package fieldcal.benchmark;

import fieldcal.movement.LimitEstimate;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.stat.interval.ConfidenceInterval;
import org.apache.commons.math3.stat.interval.WilsonScoreInterval;

/** How far the estimates of one limit are off, over many teams, and whether their errors cover that. */
final class LimitScore {
  private static final Goal UNBIASED = Goal.atMost(1, "%.1f %%");

  /** How often two standard errors hold the truth. */
  private static final Goal COVERED = new Goal(92, 98, "%.0f %%");

  /** What so few teams can tell about that. */
  private static final double CONFIDENCE = 0.95;

  private static final Goal NEVER_FALSE = Goal.atMost(0, "%.0f");
  private static final Goal NEAR = Goal.atLeast(1, "%.0f of the tolerance");

  private final String name;
  private final List<Double> own = new ArrayList<>();
  private final List<Double> league = new ArrayList<>();
  private int ownNear;
  private int leagueNear;
  private int reached;
  private int covered;
  private int falseBounds;
  private double deviations;
  private double squares;

  LimitScore(String name) {
    this.name = name;
  }

  String of(LimitEstimate ours, LimitEstimate theirs, double truth) {
    double tolerance = Math.max(0.1, 0.05 * truth);
    own.add(Math.abs(ours.value() / truth - 1));
    league.add(Math.abs(theirs.value() / truth - 1));
    double two = 2 * ours.standardError();
    if (ours.reached()) {
      reached++;
      deviations += ours.value() / truth - 1;
      squares += Math.pow((ours.value() - truth) / ours.standardError(), 2);
      covered += Math.abs(ours.value() - truth) < two ? 1 : 0;
    } else {
      falseBounds += ours.value() - two > truth ? 1 : 0;
    }
    boolean near = Math.abs(ours.value() - truth) <= tolerance;
    ownNear += near ? 1 : 0;
    leagueNear += Math.abs(theirs.value() - truth) <= tolerance ? 1 : 0;
    return String.format(
        Locale.ROOT,
        "  %s %.2f: %s%.3f ± %.3f (%+.1f %%)%s, %.2f (%+.0f %%)",
        name.charAt(0),
        truth,
        ours.reached() ? "" : "≥",
        ours.value(),
        ours.standardError(),
        100 * (ours.value() / truth - 1),
        near ? "" : "!",
        theirs.value(),
        100 * (theirs.value() / truth - 1));
  }

  void print(PrintStream out) {
    out.printf(
        Locale.ROOT,
        "%-14s %7d %22s %22s %22s  %s%n",
        name,
        own.size(),
        ownNear + " (league's " + leagueNear + ")",
        percent(own, 0.5) + " (" + percent(league, 0.5) + ")",
        percent(own, 1) + " (" + percent(league, 1) + ")",
        NEAR.verdict((double) ownNear / own.size()));
  }

  void tell(Findings findings) {
    findings.value(
        name + ": teams within 5 % or 0.1 of the truth, of " + own.size(),
        "%.0f",
        ownNear,
        Goal.atLeast(own.size(), "%.0f"));
    int trials = Math.max(1, reached);
    findings.value(name + ": mean error", "%.2f %%", Math.abs(100 * deviations / trials), UNBIASED);
    findings.share(
        name + ": within two standard errors",
        covered,
        reached,
        COVERED.lowest() / 100,
        COVERED.highest() / 100);
    findings.value(name + ": false lower bounds", "%.0f", falseBounds, NEVER_FALSE);
  }

  void printErrors(PrintStream out) {
    double bias = 100 * deviations / Math.max(1, reached);
    int trials = Math.max(1, reached);
    double within = 100.0 * covered / trials;
    ConfidenceInterval known =
        new WilsonScoreInterval().createInterval(trials, covered, CONFIDENCE);
    double low = 100 * known.getLowerBound();
    double high = 100 * known.getUpperBound();
    out.printf(
        Locale.ROOT,
        "%-14s %d of %d reached: bias %+.2f %%  (%s)  %s; %.0f %% (%.0f to %.0f %%) within two"
            + " standard errors  (%s)  %s, rms %.2f of them; false lower bounds %d of %d  (%s) "
            + " %s%n",
        name,
        reached,
        own.size(),
        bias,
        UNBIASED,
        UNBIASED.verdict(Math.abs(bias)),
        within,
        low,
        high,
        COVERED,
        Goal.verdict(low <= COVERED.highest() && high >= COVERED.lowest()),
        Math.sqrt(squares / trials),
        falseBounds,
        own.size() - reached,
        NEVER_FALSE,
        NEVER_FALSE.verdict(falseBounds));
  }

  private static String percent(List<Double> errors, double share) {
    List<Double> sorted = errors.stream().sorted().toList();
    return String.format(
        Locale.ROOT, "%.1f %%", 100 * sorted.get((int) (share * (sorted.size() - 1))));
  }
}
