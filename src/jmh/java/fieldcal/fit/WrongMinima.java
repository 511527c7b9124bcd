package fieldcal.fit;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.kick.KickKind;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * How often the search ends in a wrong local minimum, from published parameters that are 15 % off: residuals above 1.2 of the noise, a
 * parameter more than 6 bounds off, or no fit at all.
 */
public final class WrongMinima {
  private static final double NOISE = 0.0014;

  private WrongMinima() {}

  /**
   * Prints the table.
   *
   * @param settings number of kicks and seed
   * @param out where to
   * @param findings the numbers with a goal
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings) {
    out.printf(
        Locale.ROOT,
        "%d kicks per row, noise %.1f mm, published parameters 15 %% off%n",
        settings.kicks(),
        1000 * NOISE);
    out.printf("%-22s %6s %6s %7s  %s%n", "", "wrong", "failed", "goal", Goal.VERDICT);
    SplittableRandom random = new SplittableRandom(settings.seed() + 1_000_003);
    for (KickKind kind : KickKind.values()) {
      for (double outliers : new double[] {0, 0.05}) {
        List<KickTrial> trials =
            KickTrial.run(
                kind,
                new IdealKicks.Conditions(NOISE, outliers, 0),
                settings.kicks(),
                random.split());
        long wrong = trials.stream().filter(KickTrial::wrong).count();
        long failed = trials.stream().filter(KickTrial::failed).count();
        Goal goal = Goal.atMost(outliers > 0 ? 2 : 0, "%.0f");
        String condition = outliers > 0 ? "5 % outliers" : "clean";
        out.printf(
            "%-22s %6d %6d %7s  %s%n",
            kind.id() + ", " + condition, wrong, failed, goal, goal.verdict(wrong));
        String what = "wrong minima of %d kicks, %s, %s";
        findings.value(what.formatted(settings.kicks(), kind.id(), condition), "%.0f", wrong, goal);
        if (Boolean.getBoolean("fieldcal.verbose")) {
          trials.stream().filter(KickTrial::wrong).forEach(t -> out.println(t.fit()));
        }
      }
    }
  }
}
