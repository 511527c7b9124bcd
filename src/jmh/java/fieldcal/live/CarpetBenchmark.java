package fieldcal.live;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Goal;
import fieldcal.simulation.Preset;
import fieldcal.vision.BallModels;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Carpets as they were found, on which a ball brakes the more the faster it rolls, so that accRoll scatters from kick to kick: warnings of a calibrated model while nothing changes, warnings of a model that is
 * wrong by just the limit, and how soon a carpet that brakes 30 % more from half time on is warned about. Calibrated is the median of all matches before half time.
 */
public final class CarpetBenchmark {
  private static final int MATCHES_PER_RUN = 2;
  private static final double CHANGE = 1.3;

  private final BenchmarkSettings settings;
  private final Preset preset;
  private final double half;

  private CarpetBenchmark(BenchmarkSettings settings, Preset preset) {
    this.settings = settings;
    this.preset = preset;
    half = settings.minutes() / 2.0 + 1;
  }

  /** What the kicks of a match say, before and after half time. */
  private record Match(List<LiveKick> before, List<LiveKick> after) {}

  /**
   * Measures.
   *
   * @param settings matches, minutes, seed
   * @param out gets the numbers
   */
  public static void run(BenchmarkSettings settings, PrintStream out) {
    for (Preset preset : List.of(Preset.GERMAN_OPEN_2026, Preset.ROBOCUP_2026)) {
      new CarpetBenchmark(settings, preset).run(out);
    }
  }

  private void run(PrintStream out) {
    List<Match> matches = new ArrayList<>();
    for (int i = 0; i < MATCHES_PER_RUN * settings.runs(); i++) {
      matches.add(play(1000 * settings.seed() + 600 + i));
    }
    double[] rolls = before(matches, BallParameter.ACC_ROLL);
    out.printf(
        Locale.ROOT,
        "%s: %d matches of %.0f minutes, %d kicks; accRoll %.3f, half of the kicks %.3f … %.3f%n",
        preset.label(),
        matches.size(),
        2 * half,
        matches.stream().mapToInt(m -> m.before().size() + m.after().size()).sum(),
        rolls[rolls.length / 2],
        rolls[rolls.length / 4],
        rolls[3 * rolls.length / 4]);
    int wrong = 0;
    int flickering = 0;
    int[] delays = new int[matches.size()];
    for (int i = 0; i < delays.length; i++) {
      Match match = matches.get(i);
      for (BallParameter parameter : BallParameter.values()) {
        wrong += raised(parameter, match.before(), published(matches, 1)).size();
      }
      int near = raised(BallParameter.ACC_ROLL, match.before(), published(matches, 1.2)).size();
      flickering = Math.max(flickering, near);
      List<LiveKick> all = new ArrayList<>(match.before());
      all.addAll(match.after());
      delays[i] =
          raised(BallParameter.ACC_ROLL, all, published(matches, 1)).stream()
                  .filter(at -> at > match.before().size())
                  .findFirst()
                  .orElse(all.size())
              - match.before().size();
    }
    Arrays.sort(delays);
    goal(out, "warnings while nothing changed", wrong, Goal.atMost(0, "%.0f"));
    goal(
        out,
        "warnings of accRoll per match where the model is off by just 20 %, at most",
        flickering,
        Goal.atMost(1, "%.0f"));
    goal(
        out,
        "kicks until a carpet that brakes 30 % more is warned about, "
            + Arrays.toString(delays)
            + ", at most",
        delays[delays.length - 1],
        Goal.atMost(31, "%.0f"));
  }

  private static void goal(PrintStream out, String what, double value, Goal goal) {
    out.printf(Locale.ROOT, "  %s: %.0f  (%s)  %s%n", what, value, goal, goal.verdict(value));
  }

  private Match play(long seed) {
    SimulatedMatch first = SimulatedMatch.on(preset, seed, half, 1);
    SimulatedMatch second = SimulatedMatch.on(preset, seed, half, CHANGE);
    List<LiveKick> kicks = new ArrayList<>();
    LiveListener notes =
        new LiveListener() {
          @Override
          public void kick(LiveKick kick) {
            kicks.add(kick);
          }
        };
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withLimitsInterval(1000),
            first.recording().epoch(),
            notes,
            Runnable::run);
    first.feed(monitor, 0);
    List<LiveKick> before = List.copyOf(kicks);
    second.feed(monitor, first.duration() + 0.1);
    monitor.finish();
    return new Match(before, List.copyOf(kicks.subList(before.size(), kicks.size())));
  }

  private static double[] before(List<Match> matches, BallParameter parameter) {
    return matches.stream()
        .flatMap(m -> m.before().stream())
        .flatMap(k -> Optional.ofNullable(k.samples().get(parameter)).stream())
        .mapToDouble(BallSample::value)
        .sorted()
        .toArray();
  }

  /** The medians before half time, accRoll too small by a factor. */
  private static BallModels published(List<Match> matches, double factor) {
    double[] m = new double[BallParameter.values().length];
    for (BallParameter parameter : BallParameter.values()) {
      double[] values = before(matches, parameter);
      m[parameter.ordinal()] = values[values.length / 2];
    }
    double roll = m[BallParameter.ACC_ROLL.ordinal()] / factor;
    return new BallModels(
        Optional.of(new FlatModel(m[0], roll, m[2])),
        Optional.of(new ChipModel(m[3], m[4], m[5], roll)));
  }

  /** The kicks, counted from 1, at which warnings of a parameter begin. */
  private static List<Integer> raised(
      BallParameter parameter, List<LiveKick> kicks, BallModels published) {
    ParameterTrack track = new ParameterTrack(parameter, LiveSettings.defaults());
    List<Integer> at = new ArrayList<>();
    for (int i = 0; i < kicks.size(); i++) {
      Optional.ofNullable(kicks.get(i).samples().get(parameter)).ifPresent(track::add);
      if (track.compare(published).isPresent() && track.warning().isPresent()) {
        at.add(i + 1);
      }
    }
    return at;
  }
}
