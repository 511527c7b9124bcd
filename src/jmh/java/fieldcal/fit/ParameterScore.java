package fieldcal.fit;

import fieldcal.benchmark.Goal;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * How well one parameter came out over many kicks.
 *
 * @param name of the parameter
 * @param n kicks that have an answer for it
 * @param rmse root mean square error over the bound
 * @param bias mean error over the bound
 * @param in68 share of kicks within one reported standard error, %
 * @param in95 share within 1.96, %
 */
record ParameterScore(String name, int n, double rmse, double bias, double in68, double in95) {
  static final Goal BIAS = Goal.atMost(0.1, "%.1f");
  static final Goal COVERAGE_68 = new Goal(64, 72, "%.0f");
  static final Goal COVERAGE_95 = new Goal(93, 97, "%.0f");

  /** Fewer kicks than that say nothing. */
  private static final int FEWEST = 10;

  /** One score for each parameter that enough kicks have an answer for. */
  static List<ParameterScore> of(List<KickTrial> trials) {
    KickFit sample =
        trials.stream().filter(t -> !t.failed()).map(KickTrial::fit).findFirst().orElseThrow();
    List<ParameterScore> scores = new ArrayList<>();
    for (int k = 0; k < sample.estimates().size(); k++) {
      int parameter = k;
      List<KickTrial> counted = trials.stream().filter(t -> t.counts(parameter)).toList();
      if (counted.size() >= FEWEST) {
        double[] errors = counted.stream().mapToDouble(t -> t.errors()[parameter]).toArray();
        double[] pulls = counted.stream().mapToDouble(t -> t.pulls()[parameter]).toArray();
        scores.add(
            new ParameterScore(
                sample.estimates().get(k).name(),
                counted.size(),
                Math.sqrt(Arrays.stream(errors).map(e -> e * e).average().orElseThrow()),
                Arrays.stream(errors).average().orElseThrow(),
                share(pulls, 1),
                share(pulls, 1.96)));
      }
    }
    return scores;
  }

  private static double share(double[] pulls, double within) {
    return 100.0 * Arrays.stream(pulls).filter(p -> Math.abs(p) < within).count() / pulls.length;
  }

  boolean meets(Goal worst) {
    return worst.met(rmse)
        && BIAS.met(Math.abs(bias))
        && COVERAGE_68.met(in68)
        && COVERAGE_95.met(in95);
  }

  static void print(List<ParameterScore> scores, Goal worst, PrintStream out) {
    out.printf(
        "  %-20s %5s %17s %17s %12s %12s  %s%n",
        "", "n", "RMSE/bound", "bias/bound", "68 %", "95 %", "");
    out.printf(
        "  %-20s %5s %17s %17s %12s %12s  %s%n",
        "goal", "", worst, "± " + BIAS, COVERAGE_68, COVERAGE_95, Goal.VERDICT);
    for (ParameterScore s : scores) {
      out.printf(
          Locale.ROOT,
          "  %-20s %5d %9.3f ± %5.3f %9.3f ± %5.3f %6.1f ± %3.1f %6.1f ± %3.1f  %s%n",
          s.name,
          s.n,
          s.rmse,
          s.rmse * Math.sqrt(0.5 / s.n),
          s.bias,
          s.rmse / Math.sqrt(s.n),
          s.in68,
          100 * Math.sqrt(0.68 * 0.32 / s.n),
          s.in95,
          100 * Math.sqrt(0.95 * 0.05 / s.n),
          Goal.verdict(s.meets(worst)));
    }
  }
}
