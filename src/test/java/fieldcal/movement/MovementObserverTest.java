package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What must not change the limits, and what must not count. */
class MovementObserverTest {
  private static final RobotLimits YELLOW = RobotLimits.uniform(2.5, 3, 4);
  private static final RobotLimits BLUE = RobotLimits.uniform(3, 4, 5);

  private static MatchFrames match;
  private static MovementObserver plain;

  @BeforeAll
  static void simulate() {
    match = MatchFrames.of(4, 1.5, 17, 0.0035, YELLOW, BLUE);
    plain = match.observe();
  }

  @Test
  void duplicatedFramesChangeNothing() {
    MovementObserver twice = match.duplicated(3).observe();
    assertThat(twice.statistics().repeatedFrames()).isGreaterThan(4000);
    for (Team team : Team.values()) {
      assertThat(twice.limits(team)).isEqualTo(plain.limits(team));
    }
  }

  /** A damaged frame with the number of a camera that does not exist must not shut out a real one for a whole match. */
  @Test
  void aCameraTakesThePlaceOfOneThatIsGone() {
    MovementObserver observer = new MovementObserver();
    RobotDetection robot = new RobotDetection(new RobotId(Team.BLUE, 1), 0, 0, 0, 1, 0.145);
    long sent = 0;
    for (int i = 0; i < 5000; i++) {
      double t = 0.014 * i;
      for (int camera = 0; camera < 8; camera++) {
        // The first frame of all is a damaged one; camera 7 comes in later.
        int id = camera == 7 && i == 0 ? 77 : camera;
        observer.accept(new VisionFrame(id, 0, t, t, Double.NaN, List.of(), List.of(robot)));
        sent++;
      }
    }
    MovementStatistics statistics = observer.statistics();
    assertThat(statistics.surplusFrames()).isBetween(2000L, 2200L);
    assertThat(statistics.detections()).isEqualTo(sent - statistics.surplusFrames());
  }

  @Test
  void exchangedIdentitiesMoveNoPercentileByMoreThanABin() {
    sameWithin(match.exchanged(0.005, 1, 3).observe(), plain);
    sameWithin(match.exchanged(0.001, 40, 4).observe(), plain);
  }

  @Test
  void jumpsMoveNoPercentileByMoreThanABin() {
    MovementObserver jumping = match.jumping(0.01, 0.4, 5).observe();
    assertThat(jumping.statistics().refused()).isGreaterThan(200);
    sameWithin(jumping, plain);
  }

  private static void sameWithin(MovementObserver observer, MovementObserver reference) {
    for (Team team : Team.values()) {
      LeagueStatistics league = observer.statistics().of(team).league();
      LeagueStatistics clean = reference.statistics().of(team).league();
      for (double share : new double[] {0.05, 0.5, 0.75, 0.95, 0.995}) {
        same(league.velocity(), clean.velocity(), share);
        same(league.acceleration(), clean.acceleration(), share);
        same(league.braking(), clean.braking(), share);
      }
      TeamLimits found = observer.limits(team);
      TeamLimits expected = reference.limits(team);
      assertThat(found.velocity().value()).isEqualTo(expected.velocity().value(), within(0.02));
      assertThat(found.acceleration().value())
          .isEqualTo(expected.acceleration().value(), within(0.05));
      assertThat(found.braking().value()).isEqualTo(expected.braking().value(), within(0.1));
      assertThat(found.deviations()).isEmpty();
    }
  }

  private static void same(Histogram found, Histogram expected, double share) {
    assertThat(found.percentile(share))
        .as("percentile %s", share)
        .isEqualTo(expected.percentile(share), within(expected.width()));
  }

  @Test
  void aCameraThatReportsEverythingShiftedChangesNothing() {
    List<VisionFrame> frames = new ArrayList<>();
    for (VisionFrame f : match.frames()) {
      List<RobotDetection> robots = new ArrayList<>();
      for (RobotDetection r : f.robots()) {
        double shift = f.cameraId() == 0 ? 0.02 : 0;
        robots.add(
            new RobotDetection(
                r.id(), r.x() + shift, r.y(), r.orientation(), r.confidence(), r.height()));
      }
      frames.add(
          new VisionFrame(
              f.cameraId(),
              f.frameNumber(),
              f.captureTime(),
              Double.NaN,
              Double.NaN,
              List.of(),
              robots));
    }
    sameWithin(match.with(frames).observe(), plain);
  }

  @Test
  void onlyPlayCounts() {
    MovementObserver stopped = new MovementObserver();
    stopped.phase(PlayPhase.STOPPED);
    match.frames().forEach(stopped::accept);
    stopped.phase(PlayPhase.BREAK);
    match.frames().forEach(stopped::accept);
    stopped.finish();
    assertThat(stopped.statistics().counted()).isZero();
    assertThat(stopped.statistics().of(Team.BLUE).league().velocity().samples()).isZero();
    assertThat(stopped.limits(Team.BLUE).velocity().known()).isFalse();
    assertThat(stopped.limits(Team.BLUE).braking().note()).isNotEmpty();
  }

  /**
   * A robot to and fro that stays at the highest speed of each run for 0.09 s, which nobody sees at 4 mm of noise: the pieces of speeding up and of braking meet in a peak that is too high by up to 0.1 m/s.
   */
  @Test
  void aLowerBoundIsNotThePeakOfTwoPiecesThatMeet() {
    double fastest = 4.288;
    double stay = 0.09;
    Random random = new Random(7);
    MovementObserver observer = new MovementObserver();
    double time = 0;
    int number = 0;
    for (int run = 0; run < 60; run++) {
      double speed = run % 6 == 0 ? fastest : 3 + random.nextDouble();
      double faster = speed / 1.7;
      double end = faster + stay + speed / 4.7;
      double way = 0.5 * 1.7 * faster * faster + speed * stay + 0.5 * speed * speed / 4.7;
      for (double t = 0; t < end + 0.6; t += 1.0 / 140) {
        double x =
            t < faster
                ? 0.85 * t * t
                : t < faster + stay
                    ? 0.85 * faster * faster + speed * (t - faster)
                    : way - 0.5 * 4.7 * Math.pow(Math.max(0, end - t), 2);
        double place = (run % 2 == 0 ? x : way - x) + 0.004 * random.nextGaussian();
        RobotId id = new RobotId(Team.YELLOW, 1);
        RobotDetection robot =
            new RobotDetection(id, place, 0.004 * random.nextGaussian(), 0, 1, 0.15);
        observer.accept(
            new VisionFrame(
                number % 2,
                number / 2,
                time + t,
                Double.NaN,
                Double.NaN,
                List.of(),
                List.of(robot)));
        number++;
      }
      time += end + 0.6;
    }
    observer.finish();
    LimitEstimate velocity = observer.limits(Team.YELLOW).velocity();
    assertThat(velocity.reached()).isFalse();
    assertThat(velocity.value()).isBetween(0.92 * fastest, fastest);
  }

  @Test
  void withoutARefereeEverythingCounts() {
    MovementObserver all = new MovementObserver();
    match.frames().forEach(all::accept);
    all.finish();
    assertThat(all.statistics().refereeSeen()).isFalse();
    assertThat(plain.statistics().refereeSeen()).isTrue();
    assertThat(all.statistics().counted()).isGreaterThan(plain.statistics().counted());
    assertThat(all.limits(Team.YELLOW).acceleration().value()).isEqualTo(3, within(0.1));
  }

  @Test
  void theNoiseIsSeenAtRestAndInMotion() {
    assertThat(plain.statistics().standingNoiseMm()).isEqualTo(3.5, within(0.2));
    assertThat(plain.noise()).isEqualTo(0.0035, within(0.0003));
    assertThat(plain.statistics().standing().total()).isGreaterThan(5000);
  }

  @Test
  void partsMergeToTheWholeInAnyOrder() {
    MovementStatistics forth = new MovementStatistics();
    MovementStatistics back = new MovementStatistics();
    MovementStatistics other = match.exchanged(0.01, 5, 9).observe().statistics();
    forth.merge(plain.statistics());
    forth.merge(other);
    back.merge(other);
    back.merge(plain.statistics());
    for (Team team : Team.values()) {
      assertThat(LimitEstimator.estimate(team, forth.of(team)))
          .isEqualTo(LimitEstimator.estimate(team, back.of(team)));
      assertThat(forth.of(team).manoeuvres())
          .isEqualTo(plain.statistics().of(team).manoeuvres() + other.of(team).manoeuvres());
      assertThat(forth.of(team).ownFrame().total()).isEqualTo(back.of(team).ownFrame().total());
    }
    assertThat(forth.counted()).isEqualTo(plain.statistics().counted() + other.counted());
  }

  @Test
  void clearedItBeginsAnew() {
    MovementObserver observer = match.observe();
    observer.clear();
    assertThat(observer.statistics().of(Team.YELLOW).manoeuvres()).isZero();
    assertThat(observer.limits(Team.YELLOW).leagueVelocity().known()).isFalse();
    assertThat(observer.statistics().refereeSeen()).isTrue();
  }

  @Test
  void badFramesAreNoReasonToThrow() {
    MovementObserver observer = new MovementObserver();
    double[] odd = {Double.NaN, Double.POSITIVE_INFINITY, -1e300, 0, 1e300};
    for (int i = 0; i < 2000; i++) {
      List<RobotDetection> robots = new ArrayList<>();
      for (int k = 0; k < 3; k++) {
        robots.add(
            new RobotDetection(
                new RobotId(Team.YELLOW, i % 200),
                odd[(i + k) % odd.length],
                odd[(i / 2 + k) % odd.length],
                odd[(i / 3) % odd.length],
                1,
                Double.NaN));
      }
      double time = i % 97 == 0 ? odd[(i / 97) % odd.length] : i * 0.01;
      observer.accept(new VisionFrame(i % 20, i, time, Double.NaN, Double.NaN, List.of(), robots));
    }
    observer.finish();
    assertThat(observer.limits(Team.YELLOW).acceleration().known()).isFalse();
  }

  @Test
  void aClockThatJumpsBackIsFollowed() {
    MovementObserver observer = new MovementObserver();
    RobotId id = new RobotId(Team.YELLOW, 1);
    for (double start : new double[] {1000, 0}) {
      for (int i = 0; i < 100; i++) {
        observer.accept(
            new VisionFrame(
                0,
                i,
                start + i / 70.0,
                Double.NaN,
                Double.NaN,
                List.of(),
                List.of(new RobotDetection(id, i * 0.02, 0, 0, 1, 0.15))));
      }
    }
    observer.finish();
    assertThat(observer.statistics().counted()).isGreaterThan(190);
  }
}
