package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Velocity;
import java.util.ArrayDeque;
import java.util.Deque;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How late a robot follows is measured, whatever its orders. */
class FollowingTest {
  private static final double TICK = 0.01;
  private static final double BRAKING = 2;

  private final Following following = new Following(BRAKING);
  private final Deque<Double> onTheWay = new ArrayDeque<>();
  private double speed;

  /** A robot that does what it is told so many ticks later. */
  private void tick(double ordered, int delay, boolean seen) {
    onTheWay.add(ordered);
    if (onTheWay.size() > delay) {
      speed = onTheWay.remove();
    }
    Robot robot = new Robot(FakeField.YELLOW, 0, 0, 0, 0, speed, 0);
    following.update(robot, seen, new Velocity(0, ordered, 0), TICK);
  }

  private void drives(int delay, int times) {
    for (int i = 0; i < times; i++) {
      for (int k = 0; k < 100; k++) {
        tick(2, delay, true);
      }
      for (int k = 0; k < 150; k++) {
        tick(Math.max(0, 2 - k * TICK * BRAKING), delay, true);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 10, 25, 40})
  void theDelayIsFound(int delay) {
    drives(delay, 20);
    assertThat(following.late()).isCloseTo(delay * TICK, within(0.02));
  }

  @Test
  void whoIsNotKnownIsDrivenCalmly() {
    assertThat(following.calm()).isCloseTo(0.52, within(0.01));
    drives(5, 2);
    assertThat(following.calm()).isEqualTo(1);
  }

  /** It has not slowed down yet when it is to go on: that shows nothing of how late it is. */
  @Test
  void aShortBrakeOfALateRobotDoesNotMakeItQuick() {
    drives(25, 20);
    double before = following.late();
    for (int i = 0; i < 20; i++) {
      for (int k = 0; k < 100; k++) {
        tick(2, 25, true);
      }
      for (int k = 0; k < 10; k++) {
        tick(0, 25, true);
      }
    }
    assertThat(following.late()).isCloseTo(before, within(0.05));
  }

  @Test
  void whatIsNotSeenIsNotLearned() {
    drives(25, 20);
    double before = following.late();
    for (int k = 0; k < 100; k++) {
      tick(2, 25, true);
    }
    for (int k = 0; k < 100; k++) {
      tick(0, 0, false);
    }
    assertThat(following.late()).isEqualTo(before);
  }

  /** Its orders turn round before it has slowed down, again and again; so it would never be found to be late, and would swing for ever. */
  @Test
  void whoSwingsAroundItsTargetIsFoundToBeLate() {
    double x = 0.3;
    for (int i = 0; i < 2000; i++) {
      tick(Math.max(-0.4, Math.min(0.4, -4 * following.calm() * x)), 50, true);
      x += speed * TICK;
    }
    assertThat(following.late()).isBetween(0.35, 0.55);
    assertThat(Math.abs(x)).isLessThan(0.015);
  }
}
