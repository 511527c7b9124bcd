package fieldcal.benchmark;

import fieldcal.app.compare.CompareBenchmark;
import fieldcal.app.console.ConsoleBenchmark;
import fieldcal.app.console.Soak;
import fieldcal.app.twin.TwinBenchmark;
import fieldcal.diagnosis.DiagnosisSpeed;
import fieldcal.effect.ExtendedQueries;
import fieldcal.fit.FitAccuracy;
import fieldcal.fit.WrongMinima;
import fieldcal.gamelog.ReadingBenchmark;
import fieldcal.kick.MatchKicks;
import fieldcal.live.CarpetBenchmark;
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
 * misses goals of time. Without names it runs everything.
 */
public final class Benchmarks {
  private static final String USAGE =
      "usage: [fit] [wrong-minima] [reading] [calibrate] [extended] [limits] [limit-bounds]"
          + " [limit-shapes] [match-kicks] [k-switch] [diagnose] [live] [live-replay]"
          + " [live-warnings] [live-carpets] [live-day] [sample-tree] [console] [play]"
          + " [play-calibration] [play-adaptive] [play-causes] [play-udp]"
          + " [play-characters] [soak] [compare] [twin]"
          + " [--kicks N] [--seed N] [--megabytes N] [--runs N] [--minutes N]";

  private Benchmarks() {}

  /** One benchmark. */
  private interface Part {
    void run(BenchmarkSettings settings, PrintStream out) throws Exception;
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
    parts.put("reading", ReadingBenchmark::run);
    parts.put("calibrate", CalibrateBenchmark::run);
    parts.put("extended", ExtendedQueries::run);
    parts.put("limits", LimitsBenchmark::run);
    parts.put("limit-bounds", BoundsBenchmark::run);
    parts.put("limit-shapes", ShapesBenchmark::run);
    parts.put("match-kicks", MatchKicks::run);
    parts.put("k-switch", KSwitchCauses::run);
    parts.put("diagnose", DiagnosisSpeed::run);
    parts.put("live", LiveBenchmark::run);
    parts.put("live-replay", ReplayBenchmark::run);
    parts.put("live-warnings", WarningBenchmark::run);
    parts.put("live-carpets", CarpetBenchmark::run);
    parts.put("live-day", LiveDay::run);
    parts.put("sample-tree", SampleTreeStudy::run);
    parts.put("console", ConsoleBenchmark::run);
    parts.put("play", PlayBenchmark::run);
    parts.put("play-calibration", PlayCalibrationBenchmark::run);
    parts.put("play-adaptive", AdaptiveBenchmark::run);
    parts.put("play-causes", CausesBenchmark::run);
    parts.put("play-udp", NetworkPlayBenchmark::run);
    parts.put("play-characters", CharacterPlayBenchmark::run);
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
    for (String name : chosen.isEmpty() ? parts.keySet() : chosen) {
      out.printf("%n== %s ==%n", name);
      parts.get(name).run(settings, out);
    }
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
