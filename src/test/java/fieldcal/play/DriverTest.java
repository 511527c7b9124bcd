package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.play.PathPlanner.Circle;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import fieldcal.play.RobotOrder.Velocity;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DriverTest {
  private static final double TICK = 0.01;

  /** A robot's radius and that of a ball, m. */
  private static final double TOUCHES = 0.1115;

  /**
   * As in a play in which a robot drove across the field to get behind a ball in the corner, where the edge of the margin leaves it little room, and touched the ball. It follows late: 70 ms from
   * command to wheel, a lag of 0.1 s, at most 1.5 m/s².
   */
  @ParameterizedTest
  @ValueSource(doubles = {-1, -0.5, -0.25, 0, 0.25, 0.5, 1})
  void whoFollowsLateDoesNotTouchTheBallThatItDrivesRound(double startY) {
    double ballX = 4.45;
    double ballY = 2.98;
    PlayArea area = new PlayArea(9, 6, 0.2, 1);
    Driver driver = new Driver(new PathPlanner(area), PlayLimits.DEFAULT.braking());
    Safety safety = new Safety(area, PlayLimits.DEFAULT);
    Following following = new Following(PlayLimits.DEFAULT.braking());
    List<Circle> ball = List.of(new Circle(ballX, ballY, Task.AROUND));
    double aim = Math.atan2(-2.34 - ballY, -ballX);
    Pose behind = Task.behind(ballX, ballY, aim, Task.BEHIND);
    Wheels wheels = Wheels.sluggish(TICK, 0);
    Deque<Velocity> inSight = new ArrayDeque<>();
    double x = 0.6;
    double y = startY;
    double vx = 0;
    double vy = 0;
    for (int i = 0; i < 1000; i++) {
      // Vision knows velocities late.
      inSight.add(new Velocity(vx, vy, 0));
      Velocity late = inSight.size() > 8 ? inSight.remove() : Velocity.ZERO;
      Robot robot = new Robot(FakeField.YELLOW, x, y, aim, late.vx(), late.vy(), i * TICK);
      following.look(robot, TICK);
      Velocity wanted =
          driver
              .to(robot, behind, PlayLimits.DEFAULT.driveSpeed(), following.calm(), ball)
              .orElse(Velocity.ZERO);
      Velocity order = safety.limited(robot, wanted, following, List.of(robot), List.of(robot));
      following.update(robot, true, order, TICK);
      wheels.follow(order);
      vx = wheels.vx();
      vy = wheels.vy();
      x += vx * TICK;
      y += vy * TICK;
      assertThat(Math.hypot(x - ballX, y - ballY))
          .as("distance from the ball, tick %d", i)
          .isGreaterThan(TOUCHES);
    }
    double off = Math.hypot(x - behind.x(), y - behind.y());
    assertThat(off).as("distance from its place").isLessThan(0.02);
  }
}
