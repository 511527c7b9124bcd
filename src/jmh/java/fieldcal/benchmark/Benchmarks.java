package fieldcal.benchmark;

import fieldcal.app.compare.CompareBenchmark;
import fieldcal.app.console.ConsoleBenchmark;
import fieldcal.app.console.Soak;
import fieldcal.app.twin.TwinBenchmark;
import fieldcal.diagnosis.DiagnosisSpeed;
import fieldcal.diagnosis.HiddenEffectStudy;
import fieldcal.effect.ExtendedQueries;
import fieldcal.fit.FitAccuracy;
import fieldcal.fit.WrongMinima;
import fieldcal.gamelog.ReadingBenchmark;
import fieldcal.kick.MatchKicks;
import fieldcal.live.CarpetBenchmark;
import fieldcal.live.FalseBallsBenchmark;
import fieldcal.live.LiveBenchmark;
import fieldcal.live.LiveDay;
import fieldcal.live.ReplayBenchmark;
import fieldcal.live.SampleTreeStudy;
import fieldcal.live.WarningBenchmark;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Accuracy and speed against their goals. A goal that is missed is said, not punished: the program ends well, since a busy machine
 * misses goals of time. Without names it runs everything. Ends with a table of the numbers that docs/benchmarks.md shows.
 */
public final class Benchmarks {
  private static final String USAGE =
      "usage: [fit] [wrong-minima] [fit-speed] [trajectories] [reading] [calibrate] [extended]"
          + " [limits] [limit-bounds] [limit-shapes] [match-kicks] [k-switch] [diagnose]"
          + " [hidden-effects] [false-balls] [live] [live-replay] [live-warnings] [live-carpets]"
          + " [live-day] [sample-tree] [console] [play] [play-calibration] [play-adaptive]"
          + " [play-causes] [play-udp] [play-characters] [soak] [compare] [twin] [--kicks N]"
          + " [--seed N] [--megabytes N] [--runs N] [--minutes N]";

  private Benchmarks() {}

  /** One benchmark. */
  private interface Part {
    void run(BenchmarkSettings settings, PrintStream out, Findings findings) throws Exception;
  }

  /** One that is not on the page. */
  private interface Study {
    void run(BenchmarkSettings settings, PrintStream out) throws Exception;
  }

  private static Part study(Study study) {
    return (settings, out, findings) -> study.run(settings, out);
  }

  /**
   * Runs those that are named.
   *
   * @param args names and options
   * @throws Exception when a benchmark cannot run at all
   */
  public static void main(String[] args) throws Exception {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    Map<String, Part> parts = new LinkedHashMap<>();
    parts.put("fit", FitAccuracy::run);
    parts.put("wrong-minima", WrongMinima::run);
    parts.put("fit-speed", MicroBenchmarks::fit);
    parts.put("trajectories", MicroBenchmarks::trajectories);
    parts.put("reading", ReadingBenchmark::run);
    parts.put("calibrate", CalibrateBenchmark::run);
    parts.put("extended", ExtendedQueries::run);
    parts.put("limits", LimitsBenchmark::run);
    parts.put("limit-bounds", study(BoundsBenchmark::run));
    parts.put("limit-shapes", study(ShapesBenchmark::run));
    parts.put("match-kicks", MatchKicks::run);
    parts.put("k-switch", study(KSwitchCauses::run));
    parts.put("diagnose", DiagnosisSpeed::run);
    parts.put("hidden-effects", HiddenEffectStudy::run);
    parts.put("false-balls", FalseBallsBenchmark::run);
    parts.put("live", study(LiveBenchmark::run));
    parts.put("live-replay", ReplayBenchmark::run);
    parts.put("live-warnings", WarningBenchmark::run);
    parts.put("live-carpets", study(CarpetBenchmark::run));
    parts.put("live-day", study(LiveDay::run));
    parts.put("sample-tree", study(SampleTreeStudy::run));
    parts.put("console", ConsoleBenchmark::run);
    parts.put("play", PlayBenchmark::run);
    parts.put("play-calibration", PlayCalibrationBenchmark::run);
    parts.put("play-adaptive", study(AdaptiveBenchmark::run));
    parts.put("play-causes", study(CausesBenchmark::run));
    parts.put("play-udp", study(NetworkPlayBenchmark::run));
    parts.put("play-characters", study(CharacterPlayBenchmark::run));
    parts.put("soak", Soak::run);
    parts.put("compare", CompareBenchmark::run);
    parts.put("twin", TwinBenchmark::run);
    List<String> chosen = new ArrayList<>();
    BenchmarkSettings settings;
    try {
      settings = parse(args, parts, chosen);
    } catch (IllegalArgumentException wrong) {
      System.err.println(wrong.getMessage());
      System.err.println(USAGE);
      System.exit(2);
      return;
    }
    out.printf(
        "seed %d, Java %s, %d cores%n",
        settings.seed(), Runtime.version(), Runtime.getRuntime().availableProcessors());
    Findings findings = new Findings();
    for (String name : chosen.isEmpty() ? parts.keySet() : chosen) {
      out.printf("%n== %s ==%n", name);
      parts.get(name).run(settings, out, findings);
    }
    findings.print(out);
  }

  private static BenchmarkSettings parse(
      String[] args, Map<String, Part> parts, List<String> chosen) {
    BenchmarkSettings s = BenchmarkSettings.defaults();
    for (int i = 0; i < args.length; i++) {
      if (parts.containsKey(args[i])) {
        chosen.add(args[i]);
        continue;
      }
      if (i + 1 == args.length) {
        throw new IllegalArgumentException("'" + args[i] + "' is neither a name nor an option");
      }
      String value = args[++i];
      s =
          switch (args[i - 1]) {
            case "--kicks" -> s.withKicks(Integer.parseInt(value));
            case "--seed" -> s.withSeed(Long.parseLong(value));
            case "--megabytes" -> s.withMegabytes(Integer.parseInt(value));
            case "--runs" -> s.withRuns(Integer.parseInt(value));
            case "--minutes" -> s.withMinutes(Integer.parseInt(value));
            default ->
                throw new IllegalArgumentException(
                    "'" + args[i - 1] + "' is neither a name nor an option");
          };
    }
    return s;
  }
}
