package fieldcal.app.console;

import fieldcal.app.monitor.MatchDisplay;
import fieldcal.app.monitor.MatchStatus;
import fieldcal.app.monitor.MonitorRequest;
import fieldcal.app.monitor.MonitorSession;
import fieldcal.app.monitor.NetworkFeed;
import fieldcal.app.net.LoopbackSender;
import fieldcal.app.net.NetworkPlace;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.benchmark.NetworkPlayBenchmark;
import fieldcal.kick.KickFinder;
import fieldcal.live.KickCounts;
import fieldcal.live.LiveKick;
import fieldcal.live.LiveSnapshot;
import fieldcal.live.SimulatedMatch;
import fieldcal.simulation.SimulatedPacket;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.net.DatagramSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

/**
 * A tournament's day at accelerated pace: one monitor on the network, a console that is looked at, and plays over UDP beside them, while vision restarts, loses packets, is flooded with junk and sets its clock.
 * The same match is sent over and over; heap, threads and open files are looked at after each.
 */
public final class Soak {
  /** Of one match, minutes: some kicks, and many matches in an hour. */
  private static final double MATCH = 2;

  /** Between two matches, s of field time: longer than any kick. */
  private static final double BREAK = 5;

  /** Packets of junk in a flood: more than the receiver keeps. */
  private static final int FLOOD = 2000;

  /** How many frames may be on their way: the sockets hold some hundred packets. */
  private static final int AHEAD = 60;

  /** How long is waited for a frame on its way before it counts as lost, ms: the machine may be busy with other work. */
  private static final int PATIENCE = 2000;

  /** A thread for each: the common pool of a small machine has one, which on Java 25 runs one task after the other. */
  private static final Executor THREADS = task -> new Thread(task).start();

  private static final double LOSS = 0.1;
  private static final double HOUR = 3600;
  private static final double MEGABYTE = 1 << 20;

  private final BenchmarkSettings settings;
  private final PrintStream out;
  private final SimulatedMatch match;
  private final AtomicInteger kicks = new AtomicInteger();
  private final SoakKicks judged;
  private final Random random;
  private double shift;

  private Soak(BenchmarkSettings settings, PrintStream out) {
    this.settings = settings;
    this.out = out;
    match = SimulatedMatch.play(settings.seed(), MATCH, -0.28);
    judged = new SoakKicks(match);
    random = new Random(settings.seed());
  }

  /** What befalls a match. */
  private enum Trouble {
    NONE,
    RESTART,
    LOSS,
    FLOOD,
    CLOCK
  }

  /** What the process holds, after a collection. */
  private record Held(double megabytes, int threads, long files) {
    static Held now() throws IOException {
      System.gc();
      double heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() / MEGABYTE;
      int threads = ManagementFactory.getThreadMXBean().getThreadCount();
      Path descriptors = Path.of("/proc/self/fd");
      if (!Files.exists(descriptors)) {
        return new Held(heap, threads, 0);
      }
      try (Stream<Path> open = Files.list(descriptors)) {
        return new Held(heap, threads, open.count());
      }
    }
  }

  /**
   * Runs.
   *
   * @param settings minutes are those of the field; 480 are a day
   * @param out told each match and the verdict
   * @param findings the numbers of the page
   * @throws Exception when something breaks
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws Exception {
    new Soak(settings, out).run(findings);
  }

  private void run(Findings findings) throws Exception {
    Path folder = Files.createTempDirectory("fieldcal-soak");
    Path session = Files.createDirectories(folder.resolve("session"));
    SampleSession.copy(SampleSession.small(), session);
    int port = freePort();
    AtomicBoolean stop = new AtomicBoolean();
    MonitorRequest request =
        new MonitorRequest(
            Optional.empty(),
            Optional.of(folder.resolve("changes.jsonl")),
            Optional.of(folder.resolve("state.json")));
    NetworkPlace place = NetworkPlace.parse(LoopbackSender.GROUP + ":" + port, "127.0.0.1");
    try (RunningConsole console = RunningConsole.start(session);
        NetworkFeed feed = new NetworkFeed(place, Optional.empty())) {
      console.settled();
      MonitorSession monitor = new MonitorSession(request, feed, new Counting());
      CompletableFuture<MatchStatus> watching =
          CompletableFuture.supplyAsync(() -> watch(monitor), THREADS);
      CompletableFuture<Integer> looking =
          CompletableFuture.supplyAsync(() -> look(console, stop), THREADS);
      CompletableFuture<Integer> playing = CompletableFuture.supplyAsync(() -> play(stop), THREADS);
      List<Held> held = matches(monitor, feed.epoch(), port);
      stop.set(true);
      monitor.stop();
      KickCounts counts = watching.get().snapshot().ball().counts();
      out.printf("%d kicks found, %d of them dropped%n", counts.found(), counts.dropped());
      out.printf(
          "the console was looked at %d times; %d plays over UDP ended with all kicks%n",
          looking.get(), playing.get());
      judged.judge(feed.epoch(), out, findings);
      judge(held, findings);
    } finally {
      try (Stream<Path> all = Files.walk(folder)) {
        for (Path file : all.sorted(java.util.Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }

  private List<Held> matches(MonitorSession monitor, Epoch epoch, int port) throws Exception {
    List<Held> held = new ArrayList<>();
    int undisturbed = 0;
    int lost = 0;
    int expected = -1;
    int number = (int) Math.max(5, Math.round(settings.minutes() / MATCH));
    long begin = System.nanoTime();
    for (int i = 0; i < number; i++) {
      Trouble trouble = Trouble.values()[i % Trouble.values().length];
      int before = kicks.get();
      long missing = send(monitor, epoch, port, trouble);
      awaitQuiet();
      int found = kicks.get() - before;
      if (trouble == Trouble.NONE) {
        expected = expected < 0 ? found : expected;
        undisturbed++;
        lost += found == expected ? 0 : 1;
      }
      held.add(Held.now());
      Held now = held.get(i);
      out.printf(
          "match %d, %s: %d kicks, %d frames lost, heap %.0f MB, %d threads, %d files%n",
          i + 1, trouble, found, missing, now.megabytes(), now.threads(), now.files());
    }
    double seconds = (System.nanoTime() - begin) * 1e-9;
    out.printf(
        "%d matches of %.0f minutes in %.0f s, %.0f times real time; of %d undisturbed ones %d"
            + " found another number of kicks than the first%n",
        number, MATCH, seconds, number * 60 * MATCH / seconds, undisturbed, lost);
    return held;
  }

  /** Levels of the second half against the first: what grows does so match by match. */
  private void judge(List<Held> held, Findings findings) {
    int middle = held.size() / 2;
    // The first match fills caches and starts threads.
    double early = median(held.subList(1, Math.max(2, middle)), Held::megabytes);
    double late = median(held.subList(middle, held.size()), Held::megabytes);
    Goal flat = Goal.atMost(1.1, "%.2f");
    out.printf(
        "heap of the second half over that of the first: %.2f, goal %s: %s%n",
        late / early, flat, flat.verdict(late / early));
    double threads =
        median(held.subList(middle, held.size()), h -> h.threads())
            - median(held.subList(1, Math.max(2, middle)), h -> h.threads());
    double files =
        median(held.subList(middle, held.size()), h -> h.files())
            - median(held.subList(1, Math.max(2, middle)), h -> h.files());
    Goal none = Goal.atMost(2, "%.0f");
    out.printf("threads more: %.0f, goal %s: %s%n", threads, none, none.verdict(threads));
    findings.value("heap of the second half over that of the first", "%.2f", late / early, flat);
    findings.value("more threads at the end", "%.0f", threads, none);
    findings.value("more open files at the end", "%.0f", files, none);
    out.printf("open files more: %.0f, goal %s: %s%n", files, none, none.verdict(files));
  }

  private static double median(List<Held> held, java.util.function.ToDoubleFunction<Held> of) {
    double[] sorted = held.stream().mapToDouble(of).sorted().toArray();
    return sorted[sorted.length / 2];
  }

  /** Sends the match once; returns how many of the frames that were sent never reached the monitor. */
  private long send(MonitorSession monitor, Epoch epoch, int port, Trouble trouble)
      throws Exception {
    VisionEncoder encoder = new VisionEncoder(epoch);
    LoopbackSender vision = new LoopbackSender(port);
    AtomicInteger seen = new AtomicInteger();
    KickFinder finder = judged.finder(seen);
    double from = shift;
    int packets = 0;
    long before = taken(monitor);
    long given = before;
    long sent = 0;
    int all = match.recording().packets().size();
    try (LoopbackSender junk = new LoopbackSender(port)) {
      for (SimulatedPacket packet : match.recording().packets()) {
        if (++packets == all / 2) {
          if (trouble == Trouble.RESTART) {
            vision.close();
            vision = new LoopbackSender(port);
          } else if (trouble == Trouble.CLOCK) {
            shift += HOUR;
            finder.finish();
          } else if (trouble == Trouble.FLOOD) {
            flood(junk);
          }
        }
        if (trouble == Trouble.LOSS && random.nextDouble() < LOSS) {
          continue;
        }
        VisionPacket content = packet.packet();
        Optional<VisionFrame> frame = content.frame().map(f -> SimulatedMatch.later(f, shift));
        vision.send(encoder.encode(new VisionPacket(frame, content.geometry())));
        frame.ifPresent(finder::accept);
        sent += frame.isPresent() ? 1 : 0;
        // A frame that is lost is lost: it is waited for once.
        given -= missing(monitor, given + sent - AHEAD);
      }
    } finally {
      vision.close();
    }
    missing(monitor, given + sent);
    finder.finish();
    double to = shift + match.duration() + BREAK / 2;
    long lost = sent - (taken(monitor) - before);
    judged.sent(from, to, seen.get(), lost);
    shift += match.duration() + BREAK;
    return lost;
  }

  /** The frames that reached the monitor; it leaves out the first two after its clock was set. */
  private static long taken(MonitorSession monitor) {
    LiveSnapshot now = monitor.status().snapshot();
    return now.frames() + now.strayFrames();
  }

  private void flood(LoopbackSender junk) throws IOException {
    byte[] bytes = new byte[200];
    for (int i = 0; i < FLOOD; i++) {
      random.nextBytes(bytes);
      junk.send(bytes);
    }
  }

  /** Waits a little until the monitor has taken so many frames; how many it still has not. */
  private static long missing(MonitorSession monitor, long frames) throws InterruptedException {
    for (int i = 0; i < PATIENCE && taken(monitor) < frames; i++) {
      Thread.sleep(1);
    }
    return Math.max(0, frames - taken(monitor));
  }

  /** The last kicks are fitted beside the frames. */
  private void awaitQuiet() throws InterruptedException {
    int before = -1;
    while (before != kicks.get()) {
      before = kicks.get();
      Thread.sleep(500);
    }
  }

  private static MatchStatus watch(MonitorSession monitor) {
    try {
      return monitor.run();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static int look(RunningConsole console, AtomicBoolean stop) {
    int looks = 0;
    try {
      while (!stop.get()) {
        console.state();
        console.decide("{\"action\":\"" + (looks % 2 == 0 ? "drop" : "auto") + "\",\"kicks\":[1]}");
        looks++;
        Thread.sleep(200);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return looks;
  }

  private int play(AtomicBoolean stop) {
    int complete = 0;
    for (int i = 0; !stop.get(); i++) {
      try {
        complete += NetworkPlayBenchmark.overBadNetwork(settings.seed() + i) ? 1 : 0;
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    return complete;
  }

  private static int freePort() throws IOException {
    try (DatagramSocket any = new DatagramSocket()) {
      return any.getLocalPort();
    }
  }

  /** Counts kicks, and shows nothing. */
  private final class Counting implements MatchDisplay {
    @Override
    public void show(MatchStatus status) {
      // Nobody looks.
    }

    @Override
    public void summary(MatchStatus status) {
      // Nobody looks.
    }

    @Override
    public void kick(LiveKick kick) {
      judged.reported(kick.time());
      kicks.incrementAndGet();
    }
  }
}
