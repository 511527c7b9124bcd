package fieldcal.kick;

import static fieldcal.kick.FrameScene.KICKER;
import static fieldcal.kick.FrameScene.along;
import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whether the kicker had the ball at its front before. The kick happens at 2 s, along x; robots look along x. */
class DribbledKicksTest {
  private static final FlatModel FLAT = new FlatModel(-3, -0.28, 0.65);
  private static final double FRONT = 0.0965;

  private final FrameScene scene = new FrameScene().camera(0, 0, 0, -7, 7);

  private Kick kick() {
    List<Kick> kicks = scene.kicks(0, 5);
    assertThat(kicks).isNotEmpty();
    return kicks.get(kicks.size() - 1);
  }

  private FrameScene ballAndRobot(FrameScene.Path before, FrameScene.Path robot, double x) {
    BallTrajectory shot = FlatTrajectory.fromKick(FLAT, 2, x, 0, 4, 0);
    return scene.robot(KICKER, robot).ball(t -> t < 2 ? before.apply(t) : along(shot).apply(t));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.2, 0.4})
  void aRobotThatDrivesUpToARestingBallDoesNotDribble(double speed) {
    ballAndRobot(
        t -> new double[] {0, 0, 0},
        t -> new double[] {-FRONT + speed * Math.min(0, t - 2), 0, 0},
        0);
    assertThat(kick().afterDribbling()).isFalse();
  }

  @Test
  void aRobotThatTakesTheBallAlongDribbles() {
    // From 1 s on at 0.8 m/s.
    FrameScene.Path robot = t -> new double[] {0.8 * Math.max(0, t - 1) - FRONT, 0, 0};
    ballAndRobot(
        t -> new double[] {robot.apply(t)[0] + FRONT, 0, 0}, t -> robot.apply(Math.min(t, 2)), 0.8);
    Kick kick = kick();
    assertThat(kick.afterDribbling()).isTrue();
    assertThat(kick.withId(7).afterDribbling()).isTrue();
    assertThat(kick.withObservations(kick.observations()).afterDribbling()).isTrue();
  }

  @Test
  void aRobotThatCatchesAPassAndHoldsItDribbles() {
    BallTrajectory pass = FlatTrajectory.fromKick(FLAT, 0.5, 3, 0, -3.5, 0);
    double[] p = new double[3];
    pass.positionAt(1.5, p);
    double caught = p[0];
    scene.robot(FrameScene.OTHER, 3.11, 0);
    ballAndRobot(
        t -> t < 1.5 ? along(pass).apply(t) : new double[] {caught, 0, 0},
        t -> new double[] {caught - FRONT, 0, 0},
        caught);
    assertThat(kick().time()).isBetween(1.98, 2.02);
    assertThat(kick().afterDribbling()).isTrue();
  }

  @Test
  void aRobotThatRedirectsAPassDoesNotDribble() {
    BallTrajectory pass = FlatTrajectory.fromKick(FLAT, 1, 3, 0, -3.5, 0);
    double[] p = new double[3];
    pass.positionAt(2, p);
    double met = p[0];
    scene.robot(FrameScene.OTHER, 3.11, 0);
    ballAndRobot(along(pass), t -> new double[] {met - FRONT, 0, 0}, met);
    assertThat(kick().time()).isBetween(1.98, 2.02);
    assertThat(kick().afterDribbling()).isFalse();
  }
}
