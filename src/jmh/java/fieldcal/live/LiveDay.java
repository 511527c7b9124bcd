package fieldcal.live;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Goal;
import fieldcal.vision.VisionFrame;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The heap of a monitor that watches for a day: one match of four minutes over and over, later each time, with the heap after a collection ten times on the way. */
public final class LiveDay {
  private static final double MINUTES = 4;
  private static final int POINTS = 10;

  private LiveDay() {}

  /**
   * Measures.
   *
   * @param settings {@code minutes} times 24 are watched: 60 make a day
   * @param out gets the numbers
   */
  public static void run(BenchmarkSettings settings, PrintStream out) {
    SimulatedMatch match = SimulatedMatch.play(settings.seed(), MINUTES, -0.28);
    List<VisionFrame> frames = match.recording().frames();
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withLimitsInterval(60),
            match.recording().epoch(),
            LiveListener.NONE,
            Runnable::run);
    double hours = 24 * settings.minutes() / 60.0;
    int rounds = Math.max(POINTS, (int) Math.round(3600 * hours / match.duration()));
    long before = heap();
    List<Double> megabytes = new ArrayList<>();
    long start = System.nanoTime();
    for (int round = 0; round < rounds; round++) {
      match.feed(monitor, round * (match.duration() + 0.05));
      if ((round + 1) * POINTS / rounds != round * POINTS / rounds) {
        megabytes.add((heap() - before) / 1e6);
      }
    }
    double seconds = 1e-9 * (System.nanoTime() - start);
    double warm = megabytes.get(1);
    double last = megabytes.get(megabytes.size() - 1);
    Goal flat = Goal.atMost(1, "%.0f MB");
    out.printf(
        Locale.ROOT,
        "%.1f hours of a match, %d frames, %d kicks, in %.0f s%n",
        rounds * match.duration() / 3600,
        (long) rounds * frames.size(),
        monitor.snapshot().ball().counts().found(),
        seconds);
    out.printf("heap of the monitor, tenth by tenth, MB:");
    megabytes.forEach(m -> out.printf(Locale.ROOT, " %.2f", m));
    out.printf(
        Locale.ROOT,
        "%ngrown after the second tenth: %.2f MB  (%s)  %s%n",
        last - warm,
        flat,
        flat.verdict(last - warm));
  }

  private static long heap() {
    Runtime runtime = Runtime.getRuntime();
    for (int i = 0; i < 3; i++) {
      System.gc();
    }
    return runtime.totalMemory() - runtime.freeMemory();
  }
}
