package fieldcal.app.console;

import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.camera.Camera;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderSettings;
import fieldcal.live.SimulatedMatch;
import fieldcal.vision.Epoch;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;

/** Whether {@link Soak}'s monitor reports each kick that it saw. Thread-safe in what it is told of reported kicks. */
final class SoakKicks {
  private final SimulatedMatch match;
  private final List<Match> matches = new ArrayList<>();
  private final List<Double> reported = Collections.synchronizedList(new ArrayList<>());

  /**
   * A match that was sent.
   *
   * @param from before its first kick, s since the epoch
   * @param to after its last one
   * @param kicks that a kick finder finds in the very frames that were sent
   * @param missing how many of these frames never reached the monitor
   */
  private record Match(double from, double to, int kicks, long missing) {
    long found(List<Double> times) {
      return times.stream().filter(t -> t >= from && t < to).count();
    }
  }

  SoakKicks(SimulatedMatch match) {
    this.match = match;
  }

  /** Finds, beside the sending, what there is to be found in the frames that are sent. */
  KickFinder finder(AtomicInteger found) {
    Map<Integer, Camera> cameras = new HashMap<>();
    match.recording().geometry().cameras().forEach(c -> cameras.put(c.id(), Camera.of(c)));
    KickFinder finder =
        new KickFinder(KickFinderSettings.defaults(), kick -> found.incrementAndGet());
    finder.geometry(match.recording().geometry(), cameras);
    return finder;
  }

  /** A match was sent, at these times since the epoch, s. */
  void sent(double from, double to, int kicks, long missing) {
    matches.add(new Match(from, to, kicks, missing));
  }

  /** The monitor reports a kick, at a Unix time, s. */
  void reported(double unix) {
    reported.add(unix);
  }

  /** A kick is lost that the monitor saw and did not report. Of a match of which frames got lost on their way, as on a machine that is late, nobody knows what it saw. */
  void judge(Epoch epoch, PrintStream out, Findings findings) {
    List<Double> times = reported.stream().map(epoch::seconds).toList();
    List<Match> whole = matches.stream().filter(m -> m.missing() <= 0).toList();
    long lost = whole.stream().mapToLong(m -> Math.max(0, m.kicks() - m.found(times))).sum();
    out.printf(
        "%d kicks sent, %d found; frames of %d matches got lost on their way%n",
        matches.stream().mapToInt(Match::kicks).sum(),
        matches.stream().mapToLong(m -> m.found(times)).sum(),
        matches.size() - whole.size());
    Goal none = Goal.atMost(0, "%.0f");
    out.printf(
        "kicks lost, of the %d that were seen: %d, goal %s: %s%n",
        whole.stream().mapToInt(Match::kicks).sum(), lost, none, none.verdict(lost));
    int seen = whole.stream().mapToInt(Match::kicks).sum();
    findings.value("kicks lost, of %d that were seen".formatted(seen), "%.0f", lost, none);
  }
}
