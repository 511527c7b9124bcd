package fieldcal.kick;

import static fieldcal.kick.FrameScene.KICKER;
import static fieldcal.kick.FrameScene.OTHER;
import static fieldcal.kick.FrameScene.along;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.camera.Camera;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes on which it is clear what a kick is. The kick, where there is one, happens at 1 s. */
class KickFinderTest {
  private static final FlatModel FLAT = new FlatModel(-3, -0.28, 0.65);
  private static final ChipModel CHIP = new ChipModel(0.75, 0.9, 0.5, -0.28);

  private final FrameScene scene = new FrameScene();

  private static BallTrajectory flat(double x, double y, double vx, double vy) {
    return FlatTrajectory.fromKick(FLAT, 1, x, y, vx, vy);
  }

  private FrameScene oneCamera() {
    return scene.camera(0, 0, 0, -7, 7);
  }

  private FrameScene kicked(double x, double vx) {
    return oneCamera().ball(flat(x, 0.5, vx, 0)).robot(KICKER, x - Math.signum(vx) * 0.11, 0.5);
  }

  private static Kick only(List<Kick> kicks) {
    assertThat(kicks).hasSize(1);
    return kicks.get(0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.2, 2, 4, 6.5})
  void aRestingBallThatIsKickedIsAKick(double speed) {
    Kick kick = only(kicked(-5, speed).kicks(0, 9));
    assertThat(kick.id()).isEqualTo(1);
    assertThat(kick.time()).isEqualTo(1, within(0.012));
    assertThat(kick.x()).isEqualTo(-5, within(0.01));
    assertThat(kick.y()).isEqualTo(0.5, within(0.01));
    assertThat(kick.vx()).isEqualTo(speed, within(0.1 * speed));
    assertThat(kick.vy()).isEqualTo(0, within(0.1));
    assertThat(kick.robot()).contains(KICKER);
    assertThat(kick.fromRest()).isTrue();
    assertThat(kick.observations().time(0)).isBetween(0.3, 0.55);
    // Every detection from then on, unfiltered.
    long expected = Math.round((kick.endTime() - kick.observations().time(0)) * 73);
    assertThat((long) kick.observations().size()).isBetween(expected - 2, expected + 2);
  }

  /** A kicker that fires late pushes the ball for 45 ms at 0.35 m/s: the kick is made 16 mm from where the ball lay. */
  @ParameterizedTest
  @ValueSource(doubles = {2, 4, 6.5})
  void aBallThatIsPushedBeforeIsKickedWhereThePushEnds(double speed) {
    double length = 0.045 * 0.35;
    BallTrajectory kicked = flat(-5 + length, 0.5, speed, 0);
    oneCamera()
        .ball(
            t ->
                t < 1
                    ? new double[] {-5 + 0.35 * Math.max(0, t - 0.955), 0.5, 0}
                    : FrameScene.along(kicked).apply(t))
        .robot(KICKER, -5.11, 0.5);
    Kick kick = only(scene.kicks(0, 9));
    assertThat(kick.time()).isEqualTo(1, within(3 * kick.timeError()));
    assertThat(kick.timeError()).isLessThan(0.002);
    assertThat(kick.x()).isEqualTo(-5 + length, within(0.01));
    assertThat(kick.fromRest()).isFalse();
    assertThat(kick.observations().time(0)).isBetween(1.0, 1.03);
  }

  /** A ball that rises as fast as it comes nearer is projected to where it lay; it seems to be kicked a tenth of a second late. */
  @ParameterizedTest
  @ValueSource(doubles = {3, 3.5, 4})
  void aChipTowardsTheCameraIsKickedWhenItLeavesTheGround(double speed) {
    double elevation = Math.toRadians(50);
    double vx = speed * Math.cos(elevation);
    double vz = speed * Math.sin(elevation);
    ChipTrajectory chip = ChipTrajectory.fromKick(ChipModel.typical(), 1, -5, 0, vx, 0, vz);
    oneCamera().noise(0.001).ball(chip).robot(KICKER, -5.11, 0);
    Kick kick = only(scene.kicks(0, 9));
    assertThat(kick.time()).isEqualTo(1, within(0.02));
    // The camera takes its height for a distance.
    assertThat(kick.x()).isEqualTo(-5, within(0.04));
    assertThat(kick.fromRest()).isTrue();
    assertThat(kick.observations().time(0)).isLessThan(0.8);
  }

  /** What a robot does with a ball that it hides nobody knows. */
  @Test
  void aBallThatIsHiddenUntilItIsKickedIsNotKnownToHaveRested() {
    BallTrajectory kicked = flat(-5, 0.5, 4, 0);
    oneCamera()
        .ball(t -> t > 0.9 && t < 1 ? null : FrameScene.along(kicked).apply(t))
        .robot(KICKER, -5.11, 0.5);
    Kick kick = only(scene.kicks(0, 9));
    assertThat(kick.fromRest()).isFalse();
    assertThat(kick.timeError()).isEqualTo(Kick.CROSSING_ERROR);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1, 1.57, 2.5, 4, 4.71})
  void everyDirectionIsFound(double direction) {
    double vx = 3 * Math.cos(direction);
    double vy = 3 * Math.sin(direction);
    oneCamera()
        .ball(flat(0, 0, vx, vy))
        .robot(KICKER, -0.11 * Math.cos(direction), -0.11 * Math.sin(direction));
    Kick kick = only(scene.kicks(0, 8));
    assertThat(kick.time()).isEqualTo(1, within(0.012));
    assertThat(kick.robot()).contains(KICKER);
  }

  @Test
  void aStillBallIsNoKick() {
    oneCamera().noise(0.003).ball(t -> new double[] {1, 1, 0}).robot(KICKER, 0.89, 1);
    assertThat(scene.kicks(0, 20)).isEmpty();
  }

  @Test
  void aRollingBallThatComesIntoViewIsNoKick() {
    BallTrajectory path = flat(-4, 0, 4, 0);
    oneCamera().ball(t -> t < 1.5 ? null : along(path).apply(t));
    assertThat(scene.kicks(0, 8)).isEmpty();
  }

  @Test
  void aBallThatIsSeenTooShortlyToBeKnownToRestDidNot() {
    // The robot nudges it for as long as it is seen.
    BallTrajectory path = flat(-5, 0.5, 3, 0);
    oneCamera().noise(0.002).robot(KICKER, -5.11, 0.5);
    scene.ball(
        t ->
            t < 0.88
                ? null
                : t < 1 ? new double[] {-5, 0.5 - 0.05 * (1 - t), 0} : along(path).apply(t));
    Kick kick = only(scene.kicks(0, 9));
    assertThat(kick.time()).isEqualTo(1, within(0.012));
    assertThat(kick.fromRest()).isFalse();
    assertThat(kick.observations().time(0)).isGreaterThan(0.98);
  }

  @Test
  void aBallRedirectedWithMoreSpeedIsAKickThatDidNotStartAtRest() {
    BallTrajectory pass = FlatTrajectory.fromKick(FLAT, 1, -3, 0, 3, 0);
    double at = 2.2;
    double[] p = new double[3];
    pass.positionAt(at, p);
    BallTrajectory shot = FlatTrajectory.fromKick(FLAT, at, p[0], p[1], 1, 5);
    oneCamera()
        .ball(t -> along(t < at ? pass : shot).apply(t))
        .robot(KICKER, -3.11, 0)
        .robot(OTHER, p[0] + 0.06, p[1] - 0.1);
    List<Kick> kicks = scene.kicks(0, 8);
    assertThat(kicks).hasSize(2);
    assertThat(kicks.get(0).end()).isEqualTo(KickEnd.TOUCHED_ROBOT);
    assertThat(kicks.get(0).endTime()).isEqualTo(at, within(0.03)).isLessThan(at + 0.005);
    assertThat(kicks.get(1).fromRest()).isFalse();
    assertThat(kicks.get(1).robot()).contains(OTHER);
    assertThat(kicks.get(1).time()).isEqualTo(at, within(0.015));
    assertThat(kicks.get(1).observations().time(0)).isGreaterThan(at - 0.02);
  }

  @ParameterizedTest
  @CsvSource({"-0.8, 0.3", "-0.5, 1.2", "0.4, -1.5"})
  void aBallThatBouncesOffARobotIsNoKick(double vx, double vy) {
    BallTrajectory pass = FlatTrajectory.fromKick(FLAT, 1, -3, 0, 3, 0);
    double at = 2.2;
    double[] p = new double[3];
    pass.positionAt(at, p);
    BallTrajectory off = FlatTrajectory.fromKickWithSpin(FLAT, at, p[0], p[1], vx, vy, vx, vy);
    double size = Math.hypot(vx, vy);
    oneCamera()
        .ball(t -> along(t < at ? pass : off).apply(t))
        .robot(KICKER, -3.11, 0)
        .robot(OTHER, p[0] - 0.11 * (vx / size - 1) / 1.5, p[1] - 0.11 * vy / size);
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    scene.frames(0, 8).forEach(finder::accept);
    finder.finish();
    Kick kick = only(kicks);
    assertThat(finder.counts().deflections()).isEqualTo(1);
    assertThat(kick.robot()).contains(KICKER);
    assertThat(kick.end()).isEqualTo(KickEnd.TOUCHED_ROBOT);
    assertThat(kick.endTime()).isEqualTo(at, within(0.08)).isLessThan(at + 0.01);
  }

  @Test
  void aPushedBallIsNoKick() {
    // A robot drives into the ball and pushes it along at 0.5 m/s.
    FrameScene.Path ball = t -> new double[] {Math.max(0, 0.5 * (t - 1)), 0, 0};
    oneCamera().ball(ball).robot(KICKER, t -> new double[] {-0.11 + 0.5 * (t - 1), 0, 0});
    assertThat(scene.kicks(0, 5)).isEmpty();
  }

  @Test
  void aDribbledBallIsNoKick() {
    // The robot drives off with the ball at its dribbler, faster than any push.
    FrameScene.Path robot =
        t ->
            new double[] {
              t < 1 ? 0 : t < 2 ? 0.5 * 1.5 * (t - 1) * (t - 1) : 0.75 + 1.5 * (t - 2), 0, 0
            };
    oneCamera().ball(t -> new double[] {robot.apply(t)[0] + 0.105, 0, 0}).robot(KICKER, robot);
    assertThat(scene.kicks(0, 4)).isEmpty();
  }

  @Test
  void falseDetectionsAreNoKicks() {
    SplittableRandom random = new SplittableRandom(3);
    oneCamera().ball(t -> new double[] {1, 1, 0}).robot(KICKER, 0.89, 1);
    for (int i = 0; i < 3; i++) {
      scene.ball(
          t ->
              random.nextDouble() < 0.1
                  ? new double[] {random.nextDouble(-5, 5), random.nextDouble(-4, 4), 0}
                  : null);
    }
    // A cluster beside a robot, as a shirt or a shoe gives.
    scene.robot(OTHER, -2, -2);
    scene.ball(
        t ->
            t > 3 && t < 6 && random.nextDouble() < 0.6
                ? new double[] {
                  -2.1 + random.nextDouble(-0.05, 0.05), -2 + random.nextDouble(-0.05, 0.05), 0
                }
                : null);
    assertThat(scene.kicks(0, 15)).isEmpty();
  }

  @Test
  void aSecondBallAtRestChangesNothing() {
    Kick alone = only(kicked(-5, 5).kicks(0, 9));
    FrameScene two = new FrameScene().camera(0, 0, 0, -7, 7).ball(flat(-5, 0.5, 5, 0));
    two.robot(KICKER, -5.11, 0.5).ball(t -> new double[] {0, 2, 0});
    Kick kick = only(two.kicks(0, 9));
    assertThat(kick.end()).isEqualTo(alone.end());
    assertThat(kick.observations().size()).isEqualTo(alone.observations().size());
    for (int i = 0; i < kick.observations().size(); i++) {
      assertThat(kick.observations().y(i)).isLessThan(0.6);
    }
  }

  @Test
  void twoCamerasThatDisagreeSeeOneKick() {
    scene.camera(-3, 0.02, 0, -7, 1.5).camera(3, -0.02, 0, -1.5, 7);
    scene.ball(flat(-1, 0.5, 4, 0)).robot(KICKER, -1.11, 0.5);
    Kick kick = only(scene.kicks(0, 9));
    assertThat(kick.time()).isEqualTo(1, within(0.012));
    assertThat(kick.observations().cameras()).containsExactly(0, 1);
    assertThat(seenBy(kick, 1)).isGreaterThan(200);
    assertThat(kick.end()).isEqualTo(KickEnd.LEFT_FIELD);
  }

  private static long seenBy(Kick kick, int camera) {
    return Arrays.stream(cameras(kick)).filter(c -> c == camera).count();
  }

  private static int[] cameras(Kick kick) {
    int[] of = new int[kick.observations().size()];
    Arrays.setAll(of, i -> kick.observations().camera(i));
    return of;
  }

  @ParameterizedTest
  @CsvSource({"-3, 2.6, 3.0", "-2, 3.2, 3.2", "3.5, -2.5, 2.8"})
  void aChipThatCrossesIntoAnotherCameraIsOneKick(double x, double vx, double vz) {
    BallTrajectory chip = ChipTrajectory.fromKick(CHIP, 1, x, 0.5, vx, 0.3, vz);
    scene.camera(-3, 0.02, 0, -7, 1).camera(3, -0.02, 0, -1, 7);
    scene.ball(chip).robot(KICKER, x - Math.signum(vx) * 0.11, 0.5);
    Kick kick = only(scene.kicks(0, 12));
    assertThat(kick.time()).isEqualTo(1, within(0.015));
    assertThat(kick.observations().cameras()).containsExactly(0, 1);
    long total =
        scene.frames(0, 12).stream()
            .filter(f -> !f.balls().isEmpty())
            .filter(
                f ->
                    f.captureTime() > kick.observations().time(0)
                        && f.captureTime() < kick.endTime())
            .count();
    assertThat((double) kick.observations().size()).isGreaterThan(0.97 * total);
  }

  /** Cameras that were moved, with new calibrations that cannot be used: where they hung before says nothing. */
  @Test
  void withoutTheCamerasOfAnEarlierGeometryTheyHaveNoPosition() {
    BallTrajectory chip = ChipTrajectory.fromKick(CHIP, 1, -1.6, 0.5, 2.6, 0.3, 5);
    scene.camera(-3, 0.02, 0, -7, 1).camera(3, -0.02, 0, -1, 7);
    scene.ball(chip).robot(KICKER, -1.71, 0.5);
    List<VisionFrame> frames = scene.frames(0, 12);
    List<Integer> found = new ArrayList<>();
    for (List<Map<Integer, Camera>> told :
        List.of(
            List.of(scene.cameras()),
            List.of(Map.<Integer, Camera>of()),
            List.of(scene.cameras(), Map.<Integer, Camera>of()))) {
      List<Kick> kicks = new ArrayList<>();
      KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
      told.forEach(cameras -> finder.geometry(scene.geometry(), cameras));
      frames.forEach(finder::accept);
      finder.finish();
      found.add(kicks.stream().mapToInt(k -> k.observations().size()).sum());
    }
    assertThat(found.get(1)).isNotEqualTo(found.get(0));
    assertThat(found.get(2)).isEqualTo(found.get(1));
  }

  @Test
  void aBallThatStopsEndsStopped() {
    BallTrajectory path = flat(-5, 0.5, 2.5, 0);
    Kick kick = only(kicked(-5, 2.5).kicks(0, 12));
    assertThat(kick.end()).isEqualTo(KickEnd.STOPPED);
    assertThat(kick.endTime()).isEqualTo(path.restTime(), within(0.5));
  }

  @Test
  void aBallThatCrossesTheLineEndsThere() {
    Kick kick = only(kicked(3, 5).kicks(0, 6));
    assertThat(kick.end()).isEqualTo(KickEnd.LEFT_FIELD);
    Observations o = kick.observations();
    assertThat(o.x(o.size() - 1)).isEqualTo(6, within(0.1));
  }

  @Test
  void aBallThatIsCaughtEndsTouched() {
    BallTrajectory path = flat(-4, 0, 4, 0);
    double[] p = new double[3];
    path.positionAt(2.5, p);
    double stop = p[0];
    oneCamera()
        .ball(t -> t < 2.5 ? along(path).apply(t) : new double[] {stop, 0, 0})
        .robot(KICKER, -4.11, 0)
        .robot(OTHER, stop + 0.11, 0);
    Kick kick = only(scene.kicks(0, 6));
    assertThat(kick.end()).isEqualTo(KickEnd.TOUCHED_ROBOT);
    assertThat(kick.endTime()).isEqualTo(2.5, within(0.06)).isLessThan(2.505);
  }

  @Test
  void aBallThatPassesCloseByARobotGoesOn() {
    oneCamera().ball(flat(-5, 0, 4, 0)).robot(KICKER, -5.11, 0).robot(OTHER, -3, 0.125);
    Kick kick = only(scene.kicks(0, 12));
    assertThat(kick.end()).isIn(KickEnd.STOPPED, KickEnd.LEFT_FIELD);
    assertThat(kick.endTime()).isGreaterThan(4);
  }

  @Test
  void aBallThatNobodySeesAnyMoreIsLost() {
    BallTrajectory path = flat(-5, 0.5, 4, 0);
    oneCamera().robot(KICKER, -5.11, 0.5).ball(t -> t < 2 ? along(path).apply(t) : null);
    Kick kick = only(scene.kicks(0, 5));
    assertThat(kick.end()).isEqualTo(KickEnd.LOST);
    assertThat(kick.endTime()).isEqualTo(2, within(0.02));
  }

  @Test
  void theEndOfTheRecordingEndsTheKick() {
    Kick kick = only(kicked(-5, 4).kicks(0, 2.5));
    assertThat(kick.end()).isEqualTo(KickEnd.RECORDING_ENDED);
    assertThat(kick.endTime()).isEqualTo(2.5, within(0.02));
  }

  @Test
  void aGapInTheRecordingEndsTheKick() {
    List<VisionFrame> frames = kicked(-5, 4).frames(0, 9);
    frames.removeIf(f -> f.captureTime() > 2 && f.captureTime() < 3.5);
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    frames.forEach(finder::accept);
    finder.finish();
    Kick kick = only(kicks);
    assertThat(kick.end()).isEqualTo(KickEnd.RECORDING_ENDED);
    assertThat(kick.endTime()).isLessThan(2.01);
    assertThat(finder.counts().recordingGaps()).isEqualTo(1);
  }

  @Test
  void duplicateFramesAreCountedOnce() {
    List<VisionFrame> frames = kicked(-5, 4).frames(0, 9);
    List<VisionFrame> doubled = new ArrayList<>();
    frames.forEach(f -> doubled.addAll(List.of(f, f)));
    assertSameKick(only(scene.kicks(frames)), only(scene.kicks(doubled)));
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), k -> {});
    doubled.forEach(finder::accept);
    assertThat(finder.counts().staleFrames()).isEqualTo(frames.size());
  }

  private static void assertSameKick(Kick a, Kick b) {
    assertThat(b.time()).isEqualTo(a.time());
    assertThat(b.end()).isEqualTo(a.end());
    assertThat(b.observations().size()).isEqualTo(a.observations().size());
  }

  @Test
  void aClockThatJumpsBackStartsAnew() {
    List<VisionFrame> frames = new ArrayList<>(kicked(-5, 4).frames(0, 2));
    frames.replaceAll(f -> at(f, f.captureTime() + 1000));
    frames.addAll(scene.frames(0, 9));
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    frames.forEach(finder::accept);
    finder.finish();
    assertThat(finder.counts().clockJumps()).isEqualTo(1);
    assertThat(kicks).hasSize(2);
    assertThat(kicks.get(0).end()).isEqualTo(KickEnd.RECORDING_ENDED);
    assertThat(kicks.get(0).time()).isEqualTo(1001, within(0.012));
    assertThat(kicks.get(1).time()).isEqualTo(1, within(0.012));
    assertThat(kicks.get(1).id()).isEqualTo(2);
  }

  private static VisionFrame at(VisionFrame f, double t) {
    return new VisionFrame(
        f.cameraId(), f.frameNumber(), t, t + 0.01, f.cameraClockTime(), f.balls(), f.robots());
  }

  @Test
  void framesOutOfOrderAreSkippedAndCounted() {
    List<VisionFrame> frames = kicked(-5, 4).frames(0, 9);
    for (int i = 10; i + 1 < frames.size(); i += 10) {
      VisionFrame f = frames.get(i);
      frames.set(i, frames.get(i + 1));
      frames.set(i + 1, f);
    }
    Kick kick = only(scene.kicks(frames));
    assertThat(kick.time()).isEqualTo(1, within(0.015));
    for (int i = 1; i < kick.observations().size(); i++) {
      assertThat(kick.observations().time(i)).isGreaterThan(kick.observations().time(i - 1));
    }
  }

  @Test
  void lossAndOutagesAreSurvived() {
    SplittableRandom random = new SplittableRandom(8);
    List<VisionFrame> frames = kicked(-5, 4).frames(0, 9);
    frames.removeIf(
        f -> random.nextDouble() < 0.35 || f.captureTime() > 2 && f.captureTime() < 2.2);
    Kick kick = only(scene.kicks(frames));
    assertThat(kick.time()).isEqualTo(1, within(0.03));
    assertThat(kick.endTime()).isGreaterThan(4);
  }

  @Test
  void withoutGeometryKicksAreFoundAllTheSame() {
    List<VisionFrame> frames = kicked(3, 5).frames(0, 6);
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    frames.forEach(finder::accept);
    finder.finish();
    Kick kick = only(kicks);
    assertThat(kick.time()).isEqualTo(1, within(0.012));
    // Nobody knows where the lines are: the ball is lost where the camera's view ends.
    assertThat(kick.end()).isEqualTo(KickEnd.LOST);
  }

  @Test
  void manyKicksAreNumberedInTheOrderTheyEnd() {
    List<BallTrajectory> paths = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      paths.add(FlatTrajectory.fromKick(FLAT, 1 + 10 * i, -4 + i, 0, 2, 0));
    }
    oneCamera()
        .ball(t -> along(paths.get((int) Math.min(3, t / 10))).apply(t))
        .robot(KICKER, t -> new double[] {-4.11 + (int) Math.min(3, t / 10), 0, 0});
    List<Kick> kicks = scene.kicks(0, 40);
    assertThat(kicks.stream().map(Kick::id).toList()).containsExactly(1, 2, 3, 4);
    for (int i = 0; i < 4; i++) {
      assertThat(kicks.get(i).time()).isEqualTo(1 + 10 * i, within(0.012));
    }
  }

  @Test
  void settingsMustBePositive() {
    assertThatThrownBy(() -> new KickFinderSettings(0.7, 0.6, 0.2, Double.NaN, 0.35, 0.5, 0.6))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("NaN");
  }
}
