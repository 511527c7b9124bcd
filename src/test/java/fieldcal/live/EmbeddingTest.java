package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.movement.PlayPhase;
import fieldcal.vision.BallModels;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The monitor within a host that is not ours: a minimal AI with a clock, a control loop and threads of its own. */
@Timeout(300)
class EmbeddingTest {
  private static final double MINUTES = 1;
  private static SimulatedMatch match;

  @BeforeAll
  static void play() {
    match = SimulatedMatch.play(8, MINUTES, -0.28);
  }

  /** An AI that ticks at 100 Hz of a clock of its own, gives the monitor what came since the last tick, and draws what is known in another thread. */
  private static final class MinimalAi {
    private static final double TICK = 0.01;

    private final ExecutorService background;
    private final LiveMonitor monitor;
    private final Set<Thread> told = Collections.synchronizedSet(new HashSet<>());
    private final List<LiveKick> kicks = Collections.synchronizedList(new ArrayList<>());
    private double clock;

    MinimalAi(ExecutorService background) {
      this.background = background;
      monitor =
          new LiveMonitor(
              LiveSettings.defaults().withLimitsInterval(20),
              match.recording().epoch(),
              new LiveListener() {
                @Override
                public void kick(LiveKick kick) {
                  told.add(Thread.currentThread());
                  kicks.add(kick);
                }
              },
              background);
    }

    void run() {
      List<VisionFrame> frames = match.recording().frames();
      int next = 0;
      monitor.geometry(match.recording().geometry());
      monitor.phase(PlayPhase.RUNNING);
      while (next < frames.size()) {
        clock += TICK;
        while (next < frames.size() && frames.get(next).captureTime() <= clock) {
          monitor.accept(frames.get(next++));
        }
      }
      monitor.finish();
    }
  }

  @Test
  void fitsRunOnTheHostsThreadAndSnapshotsAreReadFromAnother() throws Exception {
    ExecutorService background = Executors.newSingleThreadExecutor();
    MinimalAi ai = new MinimalAi(background);
    AtomicBoolean over = new AtomicBoolean();
    List<String> contradictions = Collections.synchronizedList(new ArrayList<>());
    Thread screen =
        new Thread(
            () -> {
              long seen = 0;
              while (!over.get()) {
                LiveSnapshot s = ai.monitor.snapshot();
                KickCounts c = s.ball().counts();
                if (s.frames() < seen || c.used() + c.unused() > c.found()) {
                  contradictions.add(s.frames() + " after " + seen + ", " + c);
                }
                seen = s.frames();
                Thread.yield();
              }
            });
    screen.start();
    ai.run();
    background.shutdown();
    assertThat(background.awaitTermination(200, TimeUnit.SECONDS)).isTrue();
    over.set(true);
    screen.join();
    assertThat(contradictions).isEmpty();
    assertThat(ai.told).hasSize(1).doesNotContain(Thread.currentThread());
    assertThat(ai.kicks.size()).isGreaterThan(5);
    LiveSnapshot last = ai.monitor.snapshot();
    assertThat(last.ball().counts().waiting()).isZero();
    assertThat(last.ball().counts().used() + last.ball().counts().unused())
        .isEqualTo(ai.kicks.size());
    assertThat(last.movement().limits()).isNotEmpty();
    assertThat(last.phase()).isEqualTo(PlayPhase.RUNNING);
  }

  @Test
  void withoutAnExecutorTheHostPollsWhenItLikes() {
    List<LiveKick> kicks = new ArrayList<>();
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults(),
            match.recording().epoch(),
            new LiveListener() {
              @Override
              public void kick(LiveKick kick) {
                kicks.add(kick);
              }
            });
    match.feed(monitor, 0);
    monitor.finish();
    assertThat(kicks).isEmpty();
    while (monitor.poll()) {
      // Each call does one piece.
    }
    assertThat(kicks.size()).isGreaterThan(5);
    assertThat(monitor.poll()).isFalse();
  }

  @Test
  void aHostThatHasNoTimeLosesTheOldestKicksAndIsToldSo() {
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withWaitingKicks(3),
            match.recording().epoch(),
            LiveListener.NONE,
            task -> {
              throw new RejectedExecutionException("shutting down");
            });
    match.feed(monitor, 0);
    KickCounts counts = monitor.snapshot().ball().counts();
    assertThat(counts.waiting()).isEqualTo(3);
    assertThat(counts.dropped()).isEqualTo(counts.found() - counts.outsidePlay() - 3).isPositive();
  }

  @Test
  void aListenerThatThrowsEndsNothing() {
    BallModels wrong =
        new BallModels(
            Optional.of(new FlatModel(-3.1, -0.28, 0.65)),
            Optional.of(new ChipModel(0.75, 0.95, 0.52, -0.28)));
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withPublished(wrong),
            match.recording().epoch(),
            new LiveListener() {
              @Override
              public void kick(LiveKick kick) {
                throw new IllegalStateException("a defect of the host");
              }
            },
            Runnable::run);
    match.feed(monitor, 0);
    monitor.finish();
    LiveSnapshot last = monitor.snapshot();
    assertThat(last.listenerFailures())
        .isEqualTo(last.ball().counts().used() + last.ball().counts().unused())
        .isPositive();
  }
}
