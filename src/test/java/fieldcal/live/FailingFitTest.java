package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A fit that throws costs one kick. What is the machine's error and not the kick's reaches the host. */
class FailingFitTest {
  /** The kick that breaks its fit, counted from 1. */
  private static final int BROKEN = 3;

  private static SimulatedMatch match;
  private static List<Integer> soundKicks;

  private final List<Integer> kicks = Collections.synchronizedList(new ArrayList<>());
  private int fits;

  @BeforeAll
  static void play() {
    match = SimulatedMatch.play(8, 1, -0.28);
    FailingFitTest sound = new FailingFitTest();
    LiveMonitor monitor = sound.monitor(Optional.of(Runnable::run), null);
    match.feed(monitor, 0);
    monitor.finish();
    soundKicks = List.copyOf(sound.kicks);
    assertThat(soundKicks).hasSizeGreaterThan(BROKEN + 1);
    assertThat(monitor.snapshot().ball().counts().dropped()).isZero();
  }

  static Stream<Throwable> ofTheKick() {
    return Stream.of(
        new IllegalStateException("singular"), new StackOverflowError(), new AssertionError("x"));
  }

  /** A monitor whose third fit throws, unless nothing is to be thrown. */
  private LiveMonitor monitor(Optional<Executor> executor, Throwable thrown) {
    LiveSettings settings = LiveSettings.defaults();
    KickJudge judge = new KickJudge(settings, match.recording().epoch());
    LiveListener listener =
        new LiveListener() {
          @Override
          public void kick(LiveKick kick) {
            kicks.add(kick.id());
          }
        };
    return new LiveMonitor(
        settings,
        match.recording().epoch(),
        listener,
        executor,
        (kick, cameras, start, roll) -> {
          if (++fits == BROKEN && thrown != null) {
            sneak(thrown);
          }
          return judge.judge(kick, cameras, start, roll);
        });
  }

  @SuppressWarnings("unchecked")
  private static <T extends Throwable> void sneak(Throwable thrown) throws T {
    throw (T) thrown;
  }

  private static List<Integer> withoutTheBrokenOne() {
    List<Integer> rest = new ArrayList<>(soundKicks);
    rest.remove(BROKEN - 1);
    return rest;
  }

  private void oneKickIsLost(LiveMonitor monitor) {
    assertThat(kicks).isEqualTo(withoutTheBrokenOne());
    KickCounts counts = monitor.snapshot().ball().counts();
    assertThat(counts.dropped()).isEqualTo(1);
    assertThat(counts.waiting()).isZero();
    assertThat(counts.used() + counts.unused()).isEqualTo(kicks.size());
  }

  @ParameterizedTest
  @MethodSource("ofTheKick")
  void aFitThatThrowsCostsOneKick(Throwable thrown) {
    LiveMonitor monitor = monitor(Optional.empty(), thrown);
    match.feed(monitor, 0);
    monitor.finish();
    while (monitor.poll()) {
      // Each call does one piece.
    }
    oneKickIsLost(monitor);
    assertThat(monitor.snapshot().listenerFailures()).isZero();
  }

  @ParameterizedTest
  @MethodSource("ofTheKick")
  void itCostsNoThread(Throwable thrown) throws InterruptedException {
    List<Thread> threads = Collections.synchronizedList(new ArrayList<>());
    ExecutorService background =
        Executors.newSingleThreadExecutor(
            task -> {
              threads.add(new Thread(task));
              return threads.get(threads.size() - 1);
            });
    LiveMonitor monitor = monitor(Optional.of(background), thrown);
    match.feed(monitor, 0);
    monitor.finish();
    background.shutdown();
    assertThat(background.awaitTermination(200, TimeUnit.SECONDS)).isTrue();
    assertThat(threads).hasSize(1);
    oneKickIsLost(monitor);
  }

  /** The vision thread of a host that fits within it, as a replay does. */
  @ParameterizedTest
  @MethodSource("ofTheKick")
  void itDoesNotReachTheThreadThatGivesFrames(Throwable thrown) {
    LiveMonitor monitor = monitor(Optional.of(Runnable::run), thrown);
    match.feed(monitor, 0);
    monitor.finish();
    oneKickIsLost(monitor);
  }

  @Test
  void noMemoryReachesTheHostThatPollsAndTheNextKicksAreFitted() {
    OutOfMemoryError none = new OutOfMemoryError("none left");
    LiveMonitor monitor = monitor(Optional.empty(), none);
    match.feed(monitor, 0);
    monitor.finish();
    assertThatThrownBy(
            () -> {
              while (monitor.poll()) {
                // Each call does one piece.
              }
            })
        .isSameAs(none);
    KickCounts now = monitor.snapshot().ball().counts();
    assertThat(now.dropped()).isPositive();
    while (monitor.poll()) {
      // Each call does one piece.
    }
    KickCounts counts = monitor.snapshot().ball().counts();
    assertThat(counts.dropped()).isEqualTo(now.dropped());
    assertThat(counts.waiting()).isZero();
    assertThat(counts.used() + counts.unused() + counts.dropped()).isEqualTo(soundKicks.size());
    assertThat(kicks).isNotEmpty().last().isEqualTo(soundKicks.get(soundKicks.size() - 1));
  }

  @Test
  void noMemoryReachesTheHostsExecutorAndTheNextFrameGoesOn() {
    OutOfMemoryError none = new OutOfMemoryError("none left");
    List<Throwable> heard = new ArrayList<>();
    Executor host =
        task -> {
          try {
            task.run();
          } catch (OutOfMemoryError e) {
            heard.add(e);
          }
        };
    LiveMonitor monitor = monitor(Optional.of(host), none);
    match.feed(monitor, 0);
    monitor.finish();
    assertThat(heard).containsExactly(none);
    assertThat(kicks).last().isEqualTo(soundKicks.get(soundKicks.size() - 1));
  }

  @Test
  void anyOtherPieceThatBreaksIsCounted() {
    LiveMonitor monitor = monitor(Optional.empty(), null);
    ofTheKick().forEach(thrown -> assertThat(monitor.guarded(() -> broken(thrown))).isTrue());
    assertThat(monitor.snapshot().listenerFailures()).isEqualTo(3);
    OutOfMemoryError none = new OutOfMemoryError();
    assertThatThrownBy(() -> monitor.guarded(() -> broken(none))).isSameAs(none);
  }

  private static boolean broken(Throwable thrown) {
    sneak(thrown);
    return true;
  }
}
