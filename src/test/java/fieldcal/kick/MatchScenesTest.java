package fieldcal.kick;

import static fieldcal.kick.FrameScene.KICKER;
import static fieldcal.kick.FrameScene.OTHER;
import static fieldcal.kick.FrameScene.along;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What matches do to balls, scene by scene. The kick, where there is one, happens at 1 s. */
class MatchScenesTest {
  private static final FlatModel FLAT = new FlatModel(-3, -0.28, 0.65);

  /** Of a ball that a robot stops, m/s. */
  private static final double SLOW = 0.4;

  private final FrameScene scene = new FrameScene();

  private static Kick only(List<Kick> kicks) {
    assertThat(kicks).hasSize(1);
    return kicks.get(0);
  }

  private static double[] positionAt(BallTrajectory path, double t) {
    double[] p = new double[3];
    path.positionAt(t, p);
    return p;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.8, 1.5, 2.5})
  void aRobotThatRunsIntoARestingBallDoesNotKick(double speed) {
    // The ball leaves 25 % faster than the robot comes, as off a hard plate.
    BallTrajectory off = FlatTrajectory.fromKick(FLAT, 1, 0, 0, 1.25 * speed, 0.1);
    scene.camera(0, 0, 0, -7, 7).ball(off);
    scene.robot(KICKER, t -> new double[] {-0.11 + speed * (Math.min(t, 1.2) - 1), 0, 0});
    assertThat(scene.kicks(0, 5)).isEmpty();
  }

  @Test
  void aKickWhileDrivingIsAKick() {
    BallTrajectory kick = FlatTrajectory.fromKick(FLAT, 1, 0, 0, 4, 0.1);
    scene.camera(0, 0, 0, -7, 7).ball(kick);
    scene.robot(KICKER, t -> new double[] {-0.11 + Math.min(t, 1.2) - 1, 0, 0});
    assertThat(only(scene.kicks(0, 6)).robot()).contains(KICKER);
  }

  @Test
  void aWhiteSpotBesideTheWayIsNotTheBall() {
    BallTrajectory path = FlatTrajectory.fromKick(FLAT, 1, -3, 0, 4, 0);
    scene.camera(-3, 0, 0, -7, 1).camera(3, 0, 0, -1.2, 7);
    scene.ball(path).robot(KICKER, -3.11, 0).ball(t -> new double[] {-1, 0.04, 0});
    Kick kick = only(scene.kicks(0, 14));
    assertThat(kick.end()).isEqualTo(KickEnd.LEFT_FIELD);
    assertThat(kick.endTime()).isGreaterThan(4.8);
  }

  @Test
  void aBallThatItsKickerHidesAtFirstIsFoundAndWasKickedBefore() {
    // Held for a second, then hidden until 0.12 s after the kick.
    BallTrajectory path = FlatTrajectory.fromKick(FLAT, 1, 0, 0, 3, 0);
    scene.camera(-5, 0, 0, -7, 7).robot(KICKER, -0.0965, 0);
    scene.ball(t -> t > 0.6 && t < 1.12 ? null : along(path).apply(t));
    Kick kick = only(scene.kicks(0, 4));
    assertThat(kick.time()).isEqualTo(1, within(0.03));
    assertThat(kick.x()).isEqualTo(0, within(0.05));
    assertThat(kick.robot()).contains(KICKER);
    assertThat(kick.fromRest()).isFalse();
  }

  @Test
  void aBallThatARobotHidesWhileItPassesGoesOn() {
    BallTrajectory path = FlatTrajectory.fromKick(FLAT, 1, -4, 0, 3, 0);
    double met = 2;
    double x = positionAt(path, met)[0];
    scene.camera(0, 0, 0, -7, 7).robot(KICKER, -4.11, 0).robot(OTHER, x, 0.13);
    scene.ball(t -> Math.abs(t - met) < 0.1 ? null : along(path).apply(t));
    Kick kick = only(scene.kicks(0, 12));
    assertThat(kick.end()).isEqualTo(KickEnd.STOPPED);
    assertThat(kick.endTime()).isGreaterThan(5);
  }

  @Test
  void aBallThatItsCatcherHidesEndsWhereItWasSeenLast() {
    BallTrajectory path = FlatTrajectory.fromKick(FLAT, 1, -4, 0, 3, 0);
    double caught = 2.5;
    double x = positionAt(path, caught)[0];
    scene.camera(0, 0, 0, -7, 7).robot(KICKER, -4.11, 0).robot(OTHER, x + 0.11, 0);
    // Seen again, still there, after most of a second.
    scene.ball(
        t ->
            t < caught - 0.05
                ? along(path).apply(t)
                : t < 2.9 ? null : new double[] {x + 0.002, 0, 0});
    Kick kick = only(scene.kicks(0, 6));
    assertThat(kick.end()).isEqualTo(KickEnd.TOUCHED_ROBOT);
    assertThat(kick.endTime()).isBetween(caught - 0.1, caught + 0.01);
    Observations seen = kick.observations();
    assertThat(seen.time(seen.size() - 1)).isLessThan(caught);
  }

  @Test
  void aShotIntoTheNextRobotIsOneKick() {
    // Three cameras; the last sees the ball only after it was stopped, a tenth of a second later.
    BallTrajectory path = FlatTrajectory.fromKick(FLAT, 1, 0, 0, 5.5, 0);
    double stopped = 1.11;
    double x = positionAt(path, stopped)[0];
    scene.camera(-2, 0.01, 0, -7, 3).camera(2, -0.01, 0, -3, 7).camera(3, 0, 0, 0.2, 7);
    scene.robot(KICKER, -0.0965, 0).robot(OTHER, x + 0.11, 0);
    scene.ball(t -> t < stopped ? along(path).apply(t) : new double[] {x, 0, 0});
    Kick kick = only(scene.kicks(0, 3));
    assertThat(kick.end()).isEqualTo(KickEnd.TOUCHED_ROBOT);
    assertThat(kick.endTime()).isEqualTo(stopped, within(0.03));
  }

  @Test
  void swappedNumbersChangeNothing() {
    BallTrajectory path = FlatTrajectory.fromKick(FLAT, 1, -3, 0, 4, 0);
    scene.camera(0, 0, 0, -7, 7).ball(path).robot(KICKER, -3.11, 0).robot(OTHER, 2, 2);
    List<VisionFrame> frames = new ArrayList<>();
    for (VisionFrame f : scene.frames(0, 8)) {
      boolean swapped = f.captureTime() > 0.9 && f.captureTime() < 0.96;
      List<RobotDetection> robots =
          f.robots().stream()
              .map(
                  r ->
                      new RobotDetection(
                          swapped ? r.id().equals(KICKER) ? OTHER : KICKER : r.id(),
                          r.x(),
                          r.y(),
                          r.orientation(),
                          r.confidence(),
                          r.height()))
              .toList();
      frames.add(
          new VisionFrame(
              f.cameraId(),
              f.frameNumber(),
              f.captureTime(),
              f.sentTime(),
              f.cameraClockTime(),
              f.balls(),
              robots));
    }
    Kick kick = only(scene.kicks(frames));
    assertThat(kick.robot()).contains(KICKER);
    assertThat(kick.time()).isEqualTo(1, within(0.012));
  }

  @Test
  void aSlowBallThatARobotStopsEndsBeforeTheRobot() {
    BallTrajectory path = FlatTrajectory.fromKick(FLAT, 1, -3, 0, 2, 0);
    double stopped = 1;
    while (SLOW < speed(path, stopped)) {
      stopped += 0.01;
    }
    double end = stopped;
    double x = positionAt(path, end)[0];
    scene.camera(0, 0, 0, -7, 7).robot(KICKER, -3.11, 0).robot(OTHER, x + 0.11, 0);
    scene.ball(t -> t < end ? along(path).apply(t) : new double[] {x, 0, 0});
    Kick kick = only(scene.kicks(0, 9));
    assertThat(kick.endTime()).isLessThan(end + 0.01);
  }

  private static double speed(BallTrajectory path, double t) {
    return (positionAt(path, t + 0.005)[0] - positionAt(path, t)[0]) / 0.005;
  }

  @Test
  void aSteepChipThatIsProjectedAsideHasItsKicker() {
    BallTrajectory chip =
        ChipTrajectory.fromKick(new ChipModel(0.75, 0.9, 0.5, -0.28), 1, 0, 3.6, 0, -1.2, 3.3);
    scene.camera(-3, 0, 0, -7, 7).camera(3, 0, 0, -7, 7).ball(chip).robot(KICKER, 0, 3.71);
    Kick kick = only(scene.kicks(0, 6));
    assertThat(kick.robot()).contains(KICKER);
    assertThat(kick.time()).isEqualTo(1, within(0.02));
  }
}
