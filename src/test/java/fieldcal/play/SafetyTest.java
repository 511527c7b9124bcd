package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Velocity;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever is wanted, a robot that accelerates within its limits and hears of it late hits nobody and stays inside. */
class SafetyTest {
  private static final PlayArea AREA = new PlayArea(4, 3, 0.2, 0);
  private static final double TICK = 0.01;
  private static final double ACCELERATION = 3;
  private static final int DELAY = 3;

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 22, 29})
  void nobodyIsHit(long seed) {
    Random random = new Random(seed);
    Safety safety = new Safety(AREA, PlayLimits.DEFAULT);
    Following following = new Following(PlayLimits.DEFAULT.braking());
    Robot standing = new Robot(FakeField.THIRD, 0, 0, 0, 0, 0, 0);
    double x = -1.5;
    double y = 0.1;
    double vx = 0;
    double vy = 0;
    Velocity wanted = Velocity.ZERO;
    Deque<Velocity> onTheWay = new ArrayDeque<>();
    for (int i = 0; i < 6000; i++) {
      if (i % 8 == 0) {
        // Mostly past the other robot, now on one side of it, now on the other.
        double angle = Math.atan2(-y, -x) + random.nextGaussian();
        double speed = 2.5 * random.nextDouble();
        wanted = new Velocity(speed * Math.cos(angle), speed * Math.sin(angle), 0);
      }
      Robot robot = new Robot(FakeField.YELLOW, x, y, 0, vx, vy, 0);
      onTheWay.add(
          safety.limited(robot, wanted, following, List.of(robot, standing), List.of(robot)));
      if (onTheWay.size() > DELAY) {
        Velocity told = onTheWay.remove();
        double dx = told.vx() - vx;
        double dy = told.vy() - vy;
        double change = Math.hypot(dx, dy);
        double share = change > ACCELERATION * TICK ? ACCELERATION * TICK / change : 1;
        vx += share * dx;
        vy += share * dy;
      }
      x += vx * TICK;
      y += vy * TICK;
      double distance = Math.hypot(x, y);
      double closing = -(vx * x + vy * y) / distance;
      assertThat(distance > 0.18 || closing < 0.1)
          .as("tick %d: %.3f m apart, closing in at %.2f m/s", i, distance, closing)
          .isTrue();
      assertThat(AREA.clearance(x, y)).as("tick %d", i).isPositive();
    }
  }
}
