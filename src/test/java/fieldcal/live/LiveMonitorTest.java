package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.movement.PlayPhase;
import fieldcal.vision.Epoch;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LiveMonitorTest {
  private static final Epoch EPOCH = new Epoch(1_763_000_000_000_000_000L);

  private final LiveMonitor monitor =
      new LiveMonitor(
          LiveSettings.defaults().withLimitsInterval(1), EPOCH, LiveListener.NONE, Runnable::run);

  private static VisionFrame frame(int camera, double time) {
    return new VisionFrame(camera, 0, time, time, Double.NaN, List.of(), List.of());
  }

  private static VisionFrame frame(double time, double x) {
    RobotDetection robot = new RobotDetection(new RobotId(Team.YELLOW, 1), x, 0, 0, 1, 0.14);
    return new VisionFrame(0, 0, time, time, Double.NaN, List.of(), List.of(robot));
  }

  @Test
  void beforeAnythingCameThereIsNothing() {
    LiveSnapshot s = monitor.snapshot();
    assertThat(s.frames()).isZero();
    assertThat(s.time()).isNaN();
    assertThat(s.cameras()).isEmpty();
    assertThat(s.phase()).isEqualTo(PlayPhase.UNKNOWN);
    assertThat(s.ball().parameters()).hasSize(BallParameter.values().length);
    assertThat(s.ball().of(BallParameter.ACC_ROLL).median()).isNaN();
    assertThat(monitor.poll()).isFalse();
    monitor.finish();
  }

  @Test
  void camerasAreWatched() {
    for (int i = 0; i < 750; i++) {
      monitor.accept(frame(0, i / 75.0));
      if (i < 300 || i > 400 && i < 500) {
        monitor.accept(frame(1, i / 75.0 + 0.003));
        monitor.accept(frame(1, i / 75.0 + 0.003));
      }
    }
    List<CameraHealth> cameras = monitor.snapshot().cameras();
    assertThat(cameras.get(0).rateHz()).isCloseTo(75, within(0.01));
    assertThat(cameras.get(0).frames()).isEqualTo(750);
    assertThat(cameras.get(0).gaps()).isZero();
    assertThat(cameras.get(1).repeated()).isEqualTo(399);
    assertThat(cameras.get(1).gaps()).isEqualTo(1);
    assertThat(cameras.get(1).longestGap()).isCloseTo(102 / 75.0, within(1e-6));
    assertThat(cameras.get(1).silentFor()).isCloseTo(250 / 75.0, within(0.01));
    assertThat(cameras.get(1).noiseMm()).isNaN();
    assertThat(cameras.get(1).calibrated()).isFalse();
  }

  @Test
  void strayFramesAreLeftOutAndTimeCanBeginAnew() {
    for (int i = 0; i < 100; i++) {
      monitor.accept(frame(0, i * 0.01));
    }
    monitor.accept(frame(0, 5000));
    monitor.accept(frame(0, Double.NaN));
    monitor.accept(frame(0, 1.01));
    assertThat(monitor.snapshot().strayFrames()).isEqualTo(2);
    assertThat(monitor.snapshot().clockJumps()).isZero();
    // Somebody sets the clock back by an hour.
    for (int i = 0; i < 100; i++) {
      monitor.accept(frame(0, -3600 + i * 0.01));
    }
    LiveSnapshot s = monitor.snapshot();
    assertThat(s.clockJumps()).isEqualTo(1);
    assertThat(s.strayFrames()).isEqualTo(4);
    assertThat(s.frames()).isEqualTo(101 + 98);
    assertThat(s.time()).isCloseTo(1_763_000_000.0 - 3600 + 0.99, within(1e-5));
  }

  @Test
  void countingBeginsAnewInABreakAndTheLastEstimateStays() {
    Random random = new Random(3);
    double t = 0;
    monitor.phase(PlayPhase.RUNNING);
    for (int i = 0; i < 3000; i++, t += 0.0133) {
      monitor.accept(frame(t, 2 * Math.sin(1.3 * t) + 0.001 * random.nextGaussian()));
    }
    MovementSnapshot playing = monitor.snapshot().movement();
    assertThat(playing.counted()).isGreaterThan(2000);
    assertThat(playing.limits()).containsKeys(Team.YELLOW, Team.BLUE);
    double velocity = playing.limits().get(Team.YELLOW).velocity().value();
    assertThat(velocity).isBetween(2.0, 3.0);

    monitor.phase(PlayPhase.BREAK);
    MovementSnapshot paused = monitor.snapshot().movement();
    assertThat(paused.breaks()).isEqualTo(1);
    assertThat(paused.counted()).isZero();
    assertThat(paused.refused()).isZero();
    assertThat(paused.limits()).isEmpty();
    assertThat(paused.beforeBreak().get(Team.YELLOW).velocity().value())
        .isCloseTo(velocity, within(0.2));
    for (int i = 0; i < 1000; i++, t += 0.0133) {
      monitor.accept(frame(t, 4 * Math.sin(3 * t)));
    }
    monitor.phase(PlayPhase.RUNNING);
    for (int i = 0; i < 3000; i++, t += 0.0133) {
      monitor.accept(frame(t, 1 * Math.sin(1.3 * t) + 0.001 * random.nextGaussian()));
    }
    monitor.finish();
    assertThat(monitor.snapshot().movement().limits().get(Team.YELLOW).velocity().value())
        .isBetween(1.0, 1.6);
  }

  @Test
  void robotsThatMoveOtherwiseThanConfiguredAreWarnedAboutOnce() {
    List<String> told = new ArrayList<>();
    LiveMonitor watching =
        new LiveMonitor(
            LiveSettings.defaults().withLimitsInterval(5),
            EPOCH,
            new LiveListener() {
              @Override
              public void limitWarningRaised(LimitWarning warning) {
                told.add("raised: " + warning.text());
              }

              @Override
              public void limitWarningCleared(LimitWarning warning) {
                told.add("cleared: " + warning.text());
              }
            },
            Runnable::run);
    watching.configured(Team.YELLOW, new ConfiguredLimits(1.5, Double.NaN, Double.NaN));
    watching.configured(Team.BLUE, new ConfiguredLimits(1.5, 3, 3));
    Random random = new Random(3);
    double t = 0;
    for (int i = 0; i < 6000; i++, t += 0.0133) {
      watching.accept(frame(t, 2 * Math.sin(1.3 * t) + 0.001 * random.nextGaussian()));
    }
    assertThat(told).hasSize(1);
    assertThat(told.get(0))
        .startsWith("raised: velocity of yellow is ")
        .contains("more than the configured 1.50");
    assertThat(watching.snapshot().movement().warnings())
        .singleElement()
        .satisfies(w -> assertThat(w.deviation()).isBetween(0.5, 1.0));
    watching.configured(Team.YELLOW, new ConfiguredLimits(2.6, Double.NaN, Double.NaN));
    for (int i = 0; i < 1000; i++, t += 0.0133) {
      watching.accept(frame(t, 2 * Math.sin(1.3 * t) + 0.001 * random.nextGaussian()));
    }
    assertThat(told).hasSize(2);
    assertThat(told.get(1)).startsWith("cleared: velocity of yellow");
    assertThat(watching.snapshot().movement().warnings()).isEmpty();
  }

  /** Tasks that wait for each other would block the threads of the host. */
  @Test
  void whileAKickIsFittedNoOtherTaskBegins() {
    SimulatedMatch match = SimulatedMatch.play(8, 0.5, -0.28);
    LiveSettings settings = LiveSettings.defaults();
    KickJudge judge = new KickJudge(settings, match.recording().epoch());
    Deque<Runnable> tasks = new ArrayDeque<>();
    Iterator<VisionFrame> frames = match.recording().frames().iterator();
    LiveMonitor[] watching = new LiveMonitor[1];
    List<Integer> begun = new ArrayList<>();
    watching[0] =
        new LiveMonitor(
            settings,
            match.recording().epoch(),
            LiveListener.NONE,
            Optional.of(tasks::add),
            (kick, cameras, start, roll) -> {
              // The match goes on while it is fitted.
              frames.forEachRemaining(watching[0]::accept);
              begun.add(tasks.size());
              return judge.judge(kick, cameras, start, roll);
            });
    watching[0].geometry(match.recording().geometry());
    while (frames.hasNext()) {
      watching[0].accept(frames.next());
      if (!tasks.isEmpty()) {
        tasks.remove().run();
      }
    }
    watching[0].finish();
    while (!tasks.isEmpty()) {
      tasks.remove().run();
    }
    assertThat(begun).hasSizeGreaterThan(2).containsOnly(0);
    KickCounts counts = watching[0].snapshot().ball().counts();
    assertThat(counts.waiting()).isZero();
    assertThat(counts.used() + counts.unused()).isEqualTo(begun.size());
  }

  @Test
  void kicksOutsideOfPlayDoNotCount() {
    SimulatedMatch match = SimulatedMatch.play(8, 0.5, -0.28);
    LiveMonitor halted =
        new LiveMonitor(
            LiveSettings.defaults(), match.recording().epoch(), LiveListener.NONE, Runnable::run);
    halted.geometry(match.recording().geometry());
    halted.phase(PlayPhase.HALTED);
    match.recording().frames().forEach(halted::accept);
    halted.finish();
    KickCounts counts = halted.snapshot().ball().counts();
    assertThat(counts.found()).isPositive();
    assertThat(counts.outsidePlay()).isEqualTo(counts.found());
    assertThat(counts.used()).isZero();
  }
}
