package fieldcal.archive.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.BallState;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.gamelog.TrackerFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Trackers whose faults are known, over kicks that are known. */
class TrackerAuditTest {
  private static final FlatModel MODEL = new FlatModel(-3.5, -0.3, 0.64);
  private static final int KICKS = 20;

  /** Half a minute for each, so that every ball stops. */
  private static List<TrackerAudit.KnownKick> kicks() {
    Random random = new Random(1);
    List<TrackerAudit.KnownKick> kicks = new ArrayList<>();
    for (int i = 0; i < KICKS; i++) {
      double start = 30.0 * i + 2;
      double speed = 2 + 4 * random.nextDouble();
      double direction = 2 * Math.PI * random.nextDouble();
      FlatTrajectory path =
          FlatTrajectory.fromKick(
              MODEL, start, 0, 0, speed * Math.cos(direction), speed * Math.sin(direction));
      kicks.add(
          new TrackerAudit.KnownKick(start, path.restTime() + 0.5, 0, 0, speed, true, true, path));
    }
    return kicks;
  }

  private static TrackerFrame frame(
      double time, Optional<TrackerFrame.Ball> ball, Optional<TrackerFrame.Kick> kick) {
    return new TrackerFrame("Made up", "1", time, ball, kick, 12);
  }

  /** Behind by a delay, with noise; tells speeds 4 % too large, stops 0.1 m too far and 0.5 s too late; misses every fifth kick and invents three. */
  private static TrackerWatch.Source tracker(double delay, double noise) {
    Random random = new Random(2);
    TrackerWatch watch = new TrackerWatch();
    int number = 0;
    for (TrackerAudit.KnownKick kick : kicks()) {
      boolean misses = number++ % 5 == 0;
      FlatTrajectory path = (FlatTrajectory) kick.path();
      BallState rest = path.stateAt(path.restTime());
      double scale = 1 + 0.1 / Math.hypot(rest.x(), rest.y());
      BallState first = path.stateAt(kick.start() + 1e-9);
      TrackerFrame.Kick told =
          new TrackerFrame.Kick(
              0.02,
              0,
              1.04 * first.vx(),
              1.04 * first.vy(),
              0,
              kick.start() + 0.03,
              path.restTime() + 0.5,
              scale * rest.x(),
              scale * rest.y(),
              Optional.empty());
      for (double t = kick.start() - 1; t < kick.end() + 1; t += 0.01) {
        BallState s = path.stateAt(Math.max(kick.start(), t - delay));
        boolean moving = t - delay > kick.start();
        TrackerFrame.Ball ball =
            new TrackerFrame.Ball(
                s.x() + noise * random.nextGaussian(),
                s.y() + noise * random.nextGaussian(),
                0,
                moving ? s.vx() : 0,
                moving ? s.vy() : 0,
                0);
        boolean tells = !misses && t > kick.start() + 0.1 && t < kick.end();
        watch.accept(frame(t, Optional.of(ball), tells ? Optional.of(told) : Optional.empty()));
      }
    }
    for (int i = 0; i < 3; i++) {
      TrackerFrame.Kick never =
          new TrackerFrame.Kick(
              3, 3, 5, 0, 0, 1000 + i, Double.NaN, Double.NaN, Double.NaN, Optional.empty());
      watch.accept(frame(1000.2 + i, Optional.empty(), Optional.of(never)));
    }
    return watch.sources().get(0);
  }

  @Test
  void everyFaultIsMeasured() {
    TrackerAudit audit = TrackerAudit.of(tracker(0.02, 0.003), kicks());
    assertThat(audit.delay()).isEqualTo(0.02, within(0.001));
    assertThat(audit.positionErrorWithoutDelay()).isEqualTo(0.003 * Math.sqrt(2), within(0.0005));
    assertThat(audit.positionError()).isGreaterThan(3 * audit.positionErrorWithoutDelay());
    assertThat(audit.velocityError()).isBetween(0.005, 0.2);
    assertThat(audit.reported()).isEqualTo(16 + 3);
    assertThat(audit.matched()).isEqualTo(16);
    assertThat(audit.missed()).isEqualTo(4);
    assertThat(audit.invented()).isEqualTo(3);
    double mean =
        kicks().stream().mapToDouble(TrackerAudit.KnownKick::speed).average().orElseThrow();
    assertThat(audit.speedBias()).isEqualTo(0.04 * mean, within(0.03));
    assertThat(audit.speedScatter()).isBetween(0.01, 0.1);
    assertThat(audit.stops()).isEqualTo(16);
    assertThat(audit.stopPositionError()).isEqualTo(0.1, within(1e-3));
    assertThat(audit.stopTimeError()).isEqualTo(0.5, within(1e-3));
  }

  @Test
  void aPerfectTrackerHasNoFault() {
    TrackerAudit audit = TrackerAudit.of(tracker(0, 0), kicks());
    assertThat(audit.delay()).isEqualTo(0, within(1e-4));
    assertThat(audit.positionError()).isLessThan(1e-4);
    assertThat(audit.velocityError()).isLessThan(1e-4);
  }

  @Test
  void aFrameFromTheFutureCostsItselfAlone() {
    TrackerWatch watch = new TrackerWatch();
    TrackerFrame.Ball ball = new TrackerFrame.Ball(1, 2, 0, 0, 0, 0);
    for (double time : new double[] {1, 1e6, 2, 3, 3, 2.5}) {
      watch.accept(frame(time, Optional.of(ball), Optional.empty()));
    }
    TrackerWatch.Source source = watch.sources().get(0);
    assertThat(source.size()).isEqualTo(5);
    assertThat(source.from(2.2)).isEqualTo(2);
    assertThat(source.time(2)).isEqualTo(2.5);
    assertThat(source.x(4)).isEqualTo(1);
    assertThat(source.frames()).isEqualTo(6);
  }

  @Test
  void withoutKicksNothingIsKnown() {
    TrackerAudit audit = TrackerAudit.of(tracker(0, 0), List.of());
    assertThat(audit.samples()).isZero();
    assertThat(audit.delay()).isNaN();
    assertThat(audit.positionError()).isNaN();
    assertThat(audit.speedBias()).isNaN();
    assertThat(audit.stopPositionError()).isNaN();
    assertThat(audit.invented()).isEqualTo(19);
  }
}
