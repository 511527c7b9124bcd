package fieldcal.live;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.simulation.Preset;
import fieldcal.vision.BallModels;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;

/**
 * How soon a published parameter that is 25 to 50 % off from the first kick on is warned about, with the median of 31 samples alone and with the proof from fewer, and how often a match with nothing wrong is. On
 * ideal carpets and on those of two tournaments in turn. What is right on a tournament's carpet is the median of all kicks there, as a calibration would publish it.
 */
public final class WarningBenchmark {
  private static final int MATCHES_PER_RUN = 10;
  private static final int CARPETS = 3;
  private static final double LEAST = 0.25;
  private static final double MOST = 0.5;

  /** So small that only the median of 31 samples warns. */
  private static final double NEVER = 1e-300;

  private static final LiveSettings EARLY = LiveSettings.defaults();
  private static final LiveSettings LATE = LiveSettings.defaults().withFalseWarnings(NEVER);

  private final BenchmarkSettings settings;
  private final PrintStream out;
  private final Findings findings;

  private WarningBenchmark(BenchmarkSettings settings, PrintStream out, Findings findings) {
    this.findings = findings;
    this.settings = settings;
    this.out = out;
  }

  /** A kick, and when the monitor told it, s since the match's start: fits wait for the cameras' offsets. */
  private record ToldKick(LiveKick kick, double time) {}

  /** The kicks of a match on one of the carpets. */
  private record Match(int carpet, List<ToldKick> kicks) {}

  /**
   * Measures.
   *
   * @param settings matches per run, minutes, seed
   * @param out gets the numbers
   * @param findings those of the page
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings) {
    new WarningBenchmark(settings, out, findings).run();
  }

  private void run() {
    List<Match> matches = new ArrayList<>();
    for (int i = 0; i < MATCHES_PER_RUN * settings.runs(); i++) {
      matches.add(play(i));
    }
    int kicks = matches.stream().mapToInt(m -> m.kicks().size()).sum();
    out.printf("%d matches of %d minutes, %d kicks%n", matches.size(), settings.minutes(), kicks);
    nothingWrong(matches);
    for (BallParameter parameter : BallParameter.values()) {
      wrong(matches, List.of(parameter), parameter.id());
    }
    wrong(matches, List.of(BallParameter.values()), "all");
  }

  private Match play(int number) {
    long seed = 1000 * settings.seed() + 700 + number;
    int carpet = number % CARPETS;
    SimulatedMatch match =
        switch (carpet) {
          case 0 -> SimulatedMatch.play(seed, settings.minutes(), -0.28);
          case 1 -> SimulatedMatch.on(Preset.GERMAN_OPEN_2026, seed, settings.minutes(), 1);
          default -> SimulatedMatch.on(Preset.ROBOCUP_2026, seed, settings.minutes(), 1);
        };
    List<ToldKick> kicks = new ArrayList<>();
    LiveMonitor[] monitor = new LiveMonitor[1];
    double start = match.recording().epoch().unixSeconds(0);
    LiveListener notes =
        new LiveListener() {
          @Override
          public void kick(LiveKick kick) {
            kicks.add(new ToldKick(kick, monitor[0].snapshot().time() - start));
          }
        };
    LiveSettings calm = EARLY.withLimitsInterval(1000);
    monitor[0] = new LiveMonitor(calm, match.recording().epoch(), notes, Runnable::run);
    match.feed(monitor[0], 0);
    monitor[0].finish();
    return new Match(carpet, kicks);
  }

  /** What a calibration would have published. */
  private static Map<BallParameter, Double> right(List<Match> matches, int carpet) {
    Map<BallParameter, Double> values = new EnumMap<>(BallParameter.class);
    for (BallParameter parameter : BallParameter.values()) {
      double[] all =
          matches.stream()
              .filter(m -> m.carpet() == carpet)
              .flatMap(m -> m.kicks().stream())
              .flatMap(k -> Optional.ofNullable(k.kick().samples().get(parameter)).stream())
              .mapToDouble(BallSample::value)
              .sorted()
              .toArray();
      values.put(parameter, all[all.length / 2]);
    }
    return values;
  }

  private static BallModels models(Map<BallParameter, Double> v) {
    double roll = v.get(BallParameter.ACC_ROLL);
    return new BallModels(
        Optional.of(
            new FlatModel(v.get(BallParameter.ACC_SLIDE), roll, v.get(BallParameter.K_SWITCH))),
        Optional.of(
            new ChipModel(
                v.get(BallParameter.DAMPING_XY_FIRST_HOP),
                v.get(BallParameter.DAMPING_XY_OTHER_HOPS),
                v.get(BallParameter.DAMPING_Z),
                roll)));
  }

  private void nothingWrong(List<Match> matches) {
    int early = 0;
    int late = 0;
    for (Match match : matches) {
      BallModels published = models(right(matches, match.carpet()));
      for (BallParameter parameter : BallParameter.values()) {
        early += Double.isNaN(warned(match, parameter, published, EARLY)) ? 0 : 1;
        late += Double.isNaN(warned(match, parameter, published, LATE)) ? 0 : 1;
      }
    }
    Goal none = Goal.atMost(0, "%.0f");
    out.printf(
        "nothing wrong: false warnings %d (31 samples alone: %d)  (%s)  %s%n",
        early, late, none, none.verdict(early));
    findings.value(
        "false warnings in %d matches whose published model is right".formatted(matches.size()),
        "%.0f",
        early,
        none);
  }

  private void wrong(List<Match> matches, List<BallParameter> candidates, String name) {
    Random random = new Random(settings.seed());
    double[] before = new double[matches.size()];
    double[] after = new double[matches.size()];
    int never = 0;
    int neverBefore = 0;
    int earlier = 0;
    for (int i = 0; i < before.length; i++) {
      Match match = matches.get(i);
      BallParameter parameter = candidates.get(random.nextInt(candidates.size()));
      Map<BallParameter, Double> values = right(matches, match.carpet());
      double off = LEAST + (MOST - LEAST) * random.nextDouble();
      double value = values.get(parameter);
      // Fractions stay below one.
      boolean less = random.nextBoolean() && (value < 0 || value / (1 - off) < 1);
      values.put(parameter, value / (less ? 1 - off : 1 + off));
      before[i] = warned(match, parameter, models(values), LATE);
      after[i] = warned(match, parameter, models(values), EARLY);
      neverBefore += Double.isNaN(before[i]) ? 1 : 0;
      never += Double.isNaN(after[i]) ? 1 : 0;
      earlier += !Double.isNaN(after[i]) && !(before[i] <= after[i]) ? 1 : 0;
    }
    if (candidates.size() == 1) {
      out.println(samples(matches, candidates.get(0), after));
    }
    Goal soon = Goal.atMost(median(before), "%.0f s");
    out.printf(
        Locale.ROOT,
        "%-22s 31 samples alone: median %s, worst %s, never %d; with the early proof: median %s,"
            + " worst %s, never %d; earlier in %d  %s%n",
        name,
        seconds(median(before)),
        seconds(worst(before)),
        neverBefore,
        seconds(median(after)),
        seconds(worst(after)),
        never,
        earlier,
        soon.verdict(median(after)));
    findings.note(
        "published "
            + (name.equals("all") ? "parameter, drawn" : name)
            + ", 25 to 50 % off: warned about after (median, worst, never)",
        "%s, %s; in %d of %d matches"
            .formatted(seconds(median(after)), seconds(worst(after)), never, matches.size()));
  }

  /** How many samples a match has, and how many of these certainly without spin; of all, and of those that were never warned about. */
  private static String samples(List<Match> matches, BallParameter parameter, double[] warned) {
    int[] all = new int[matches.size()];
    int[] clean = new int[matches.size()];
    int fewClean = 0;
    for (int i = 0; i < all.length; i++) {
      for (ToldKick told : matches.get(i).kicks()) {
        BallSample sample = told.kick().samples().get(parameter);
        all[i] += sample != null ? 1 : 0;
        clean[i] += sample != null && !sample.possiblySpinning() ? 1 : 0;
      }
      fewClean += Double.isNaN(warned[i]) && clean[i] < 5 ? 1 : 0;
    }
    Arrays.sort(all);
    Arrays.sort(clean);
    return String.format(
        Locale.ROOT,
        "%-22s samples in a match: median %d, of balls without spin %d; never warned about with"
            + " fewer than five of these: %d",
        parameter.id(),
        all[all.length / 2],
        clean[clean.length / 2],
        fewClean);
  }

  private static String seconds(double time) {
    return Double.isInfinite(time)
        ? "not in the match"
        : Double.isNaN(time) ? "–" : String.format(Locale.ROOT, "%.0f s", time);
  }

  /** Matches that were never warned come last. */
  private static double median(double[] times) {
    double[] sorted = Arrays.stream(times).map(WarningBenchmark::orNever).sorted().toArray();
    return sorted[sorted.length / 2];
  }

  /** The worst of those that were warned. */
  private static double worst(double[] times) {
    return Arrays.stream(times).filter(t -> !Double.isNaN(t)).max().orElse(Double.NaN);
  }

  private static double orNever(double time) {
    return Double.isNaN(time) ? Double.POSITIVE_INFINITY : time;
  }

  /** Time from the match's start until a parameter is warned about, s; NaN when it never is. */
  private static double warned(
      Match match, BallParameter parameter, BallModels published, LiveSettings settings) {
    ParameterTrack track = new ParameterTrack(parameter, settings);
    for (ToldKick told : match.kicks()) {
      Optional.ofNullable(told.kick().samples().get(parameter)).ifPresent(track::add);
      if (track.compare(published).isPresent() && track.warning().isPresent()) {
        return told.time();
      }
    }
    return Double.NaN;
  }
}
