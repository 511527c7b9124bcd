package fieldcal.kick;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.benchmark.ShareGoal;
import fieldcal.camera.Camera;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.truth.KickTruth;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Kicks found in drawn matches, against the truth: divisions A and B, 6 and 11 robots a side, one to eight cameras, the presets, noise, loss, outages, false balls, white spots, swapped numbers.
 * {@code --runs} matches of {@code --minutes} each from {@code --seed} on; every case that went wrong is printed.
 */
public final class MatchKicks {
  private static final Goal FOUND = Goal.atLeast(95, "%.0f %%");
  private static final Goal INVENTED = Goal.atMost(2, "%.0f %%");
  private static final Goal ENDS = Goal.atLeast(90, "%.0f %%");
  private static final Goal KINDS = Goal.atLeast(95, "%.0f %%");
  private static final Goal SPEED = Goal.atLeast(100, "%.0f");

  /** A fit of fewer detections says little about the kind. */
  private static final int ENOUGH = 20;

  private static final int LARGE_TEAM = 11;

  private MatchKicks() {}

  /**
   * Prints cases, numbers and goals.
   *
   * @param settings seed, number and length of the matches
   * @param out where to
   * @param findings the numbers with a goal
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings) {
    KickJudge judge = new KickJudge();
    Map<String, Integer> kinds = new TreeMap<>();
    double seconds = 0;
    double covered = 0;
    int[] large = new int[counts(judge).length];
    for (int i = 0; i < settings.runs(); i++) {
      DrawnMatch match = DrawnMatch.of(settings.seed() + i, settings.minutes());
      out.println(match);
      int cases = judge.cases().size();
      int pairs = judge.pairs().size();
      int[] before = counts(judge);
      seconds += judge.judge(match);
      if (match.settings().scenario().teamSize() == LARGE_TEAM) {
        int[] after = counts(judge);
        Arrays.setAll(large, k -> large[k] + after[k] - before[k]);
      }
      covered += 60.0 * settings.minutes();
      judge.cases().subList(cases, judge.cases().size()).forEach(c -> out.println("  " + c));
      kinds(match, judge.pairs().subList(pairs, judge.pairs().size()), kinds);
    }
    out.println(judge.summary());
    out.println("kinds, told by the fit of each kick alone: " + kinds);
    out.printf(
        Locale.ROOT,
        "11 against 11: %d kicks, %.1f %% found, %.1f %% invented, %.1f %% of the ends right%n",
        large[0],
        100.0 * large[1] / large[0],
        100.0 * large[2] / large[0],
        100.0 * large[4] / large[3]);
    goal(out, "found", 100.0 * judge.found() / judge.counted(), FOUND);
    goal(out, "invented", 100.0 * judge.invented() / judge.counted(), INVENTED);
    goal(out, "ends right", 100.0 * judge.rightEnds() / judge.judgedEnds(), ENDS);
    goal(out, "kinds right", rightKinds(kinds), KINDS);
    goal(out, "times real time", covered / seconds, SPEED);
    findings.share("kicks found", judge.found(), judge.counted(), ShareGoal.atLeast(0.95));
    findings.share("kicks invented", judge.invented(), judge.counted(), ShareGoal.atMost(0.02));
    findings.share("ends right", judge.rightEnds(), judge.judgedEnds(), ShareGoal.atLeast(0.9));
    int[] right = kindsRight(kinds);
    findings.share("flat or chip decided correctly", right[0], right[1], ShareGoal.atLeast(0.95));
    findings.share("11 against 11: found", large[1], large[0], ShareGoal.atLeast(0.95));
    findings.value("finding kicks, times real time", "%.0f", covered / seconds, SPEED);
  }

  private static int[] counts(KickJudge judge) {
    return new int[] {
      judge.counted(), judge.found(), judge.invented(), judge.judgedEnds(), judge.rightEnds()
    };
  }

  private static void goal(PrintStream out, String what, double value, Goal goal) {
    out.printf(Locale.ROOT, "%-16s %8.1f  %-8s %s%n", what, value, goal, goal.verdict(value));
  }

  private static void kinds(
      DrawnMatch match, List<KickJudge.Pair> pairs, Map<String, Integer> kinds) {
    CameraViews views =
        CameraViews.of(
            Simulation.of(match.settings()).geometry().cameras().stream()
                .map(c -> CameraView.of(c.id(), Optional.of(Camera.of(c))))
                .toList());
    KickFitter fitter = new KickFitter(FitSettings.defaults());
    for (KickJudge.Pair pair : pairs) {
      if (pair.kick().observations().count(pair.kick().time()) < ENOUGH) {
        continue;
      }
      KickTruth truth = pair.truth();
      KickFit fit =
          fitter.fit(FitProblem.of(pair.kick(), views, FlatModel.typical(), ChipModel.typical()));
      String told = fit.failure().isPresent() ? "nothing" : fit.kind().id();
      kinds.merge(truth.kind().label() + " is called " + told, 1, Integer::sum);
    }
  }

  private static double rightKinds(Map<String, Integer> kinds) {
    int[] counts = kindsRight(kinds);
    return 100.0 * counts[0] / counts[1];
  }

  private static int[] kindsRight(Map<String, Integer> kinds) {
    int all = 0;
    int right = 0;
    for (Map.Entry<String, Integer> e : kinds.entrySet()) {
      all += e.getValue();
      right += e.getKey().matches("(\\w+) is called \\1") ? e.getValue() : 0;
    }
    return new int[] {right, all};
  }
}
