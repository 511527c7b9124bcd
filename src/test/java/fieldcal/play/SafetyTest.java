package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Velocity;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever is wanted, a robot that accelerates within its limits and hears of it late hits nobody and stays inside. */
class SafetyTest {
  private static final PlayArea AREA = new PlayArea(4, 3, 0.2, 0);
  private static final double TICK = 0.01;
  private static final double ACCELERATION = 3;
  private static final int DELAY = 3;

  /** Distance from the edge at which robots are held, m: 75 % of the play's reserve. */
  private static final double HELD = 0.75 * PlayArea.RESERVE;

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
    Wheels wheels = Wheels.prompt(TICK, DELAY, ACCELERATION);
    for (int i = 0; i < 6000; i++) {
      if (i % 8 == 0) {
        // Mostly past the other robot, now on one side of it, now on the other.
        double angle = Math.atan2(-y, -x) + random.nextGaussian();
        double speed = 2.5 * random.nextDouble();
        wanted = new Velocity(speed * Math.cos(angle), speed * Math.sin(angle), 0);
      }
      Robot robot = new Robot(FakeField.YELLOW, x, y, 0, vx, vy, 0);
      wheels.follow(
          safety.limited(robot, wanted, following, List.of(robot, standing), List.of(robot)));
      vx = wheels.vx();
      vy = wheels.vy();
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

  /**
   * As in a play in which a robot crept outward to a ball beyond the lines: vision had just seen it push back, since it knows velocities late, and then its camera stalled. The robot obeyed all the
   * same.
   */
  @ParameterizedTest
  @ValueSource(ints = {1, 5, 10, 20, 60})
  void whoIsNotSeenStaysInside(int seenFor) {
    Safety safety = new Safety(AREA, PlayLimits.DEFAULT);
    Following following = known();
    Velocity outward = new Velocity(0.24, 0.18, 0);
    double edge = AREA.width() / 2 + AREA.margin();
    double y = edge - 0.045;
    double vy = -0.07;
    double seenY = y;
    Velocity told = new Velocity(0.24, 0.15, 0);
    int stall = (int) Math.round(Situation.ROBOT_UNSEEN / TICK);
    for (int i = 0; i < seenFor + stall + 10; i++) {
      boolean isSeen = i < seenFor;
      seenY = isSeen ? y : seenY + TICK * vy;
      double seenAt = TICK * Math.min(i, seenFor - 1);
      Robot robot = new Robot(FakeField.YELLOW, 0, seenY, 0, 0.24, vy, seenAt);
      following.look(robot, TICK);
      // The play stops a robot that was not seen for so long.
      boolean stopped = i >= seenFor + stall;
      Velocity order =
          stopped
              ? Velocity.ZERO
              : safety.limited(robot, outward, following, List.of(robot), List.of(robot));
      following.update(robot, true, order, TICK);
      y += told.vy() * TICK;
      told = order;
      assertThat(y).as("tick %d", i).isLessThan(edge - HELD / 3);
    }
  }

  /**
   * A robot that is to drive along the edge, but still rolls back and outward, drives 4° beside its way and follows late: 70 ms from command to wheel, a lag of 0.1 s, at most 1.5 m/s². Its wheels
   * have not the force to speed up and to turn inward at once.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.06, 0.12})
  void whoFollowsLateStaysInside(double outward) {
    Safety safety = new Safety(new PlayArea(12, 9, 0.2, 0), PlayLimits.DEFAULT);
    Following following = new Following(PlayLimits.DEFAULT.braking());
    Wheels wheels = Wheels.sluggish(TICK, Math.toRadians(4));
    wheels.start(-0.5, outward);
    Deque<Robot> inSight = new ArrayDeque<>();
    double x = -5;
    double y = 4.6;
    double vx = -0.5;
    double vy = outward;
    double farthest = 0;
    for (int i = 0; i < 500; i++) {
      inSight.add(new Robot(FakeField.YELLOW, x, y, 0, vx, vy, i * TICK));
      // Vision knows velocities late.
      Robot late = inSight.size() > 8 ? inSight.remove() : inSight.peek();
      Robot robot = new Robot(FakeField.YELLOW, x, y, 0, late.vx(), late.vy(), i * TICK);
      following.look(robot, TICK);
      Velocity order =
          safety.limited(robot, new Velocity(1.8, 0, 0), following, List.of(robot), List.of(robot));
      wheels.follow(order);
      vx = wheels.vx();
      vy = wheels.vy();
      x += vx * TICK;
      y += vy * TICK;
      farthest = Math.max(farthest, y);
    }
    assertThat(4.7 - farthest).as("distance from the edge").isGreaterThan(HELD / 2);
    assertThat(x).as("it still gets ahead").isGreaterThan(-2);
  }

  /**
   * As in a play in which a bystander pulled out, and stopped in front of a robot that follows late: 70 ms from command to wheel, a lag of 0.1 s, at most 1.5 m/s². Our robot stands when they meet.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0.3, 0.5, 0.7, 0.85, 1, 1.2, 1.5})
  void whoPullsOutIsNotHit(double distance) {
    Safety safety = new Safety(new PlayArea(12, 9, 0.2, 0), PlayLimits.DEFAULT);
    Following following = new Following(PlayLimits.DEFAULT.braking());
    Wheels wheels = Wheels.sluggish(TICK, 0);
    Deque<Double> speeds = new ArrayDeque<>();
    Deque<Double> theirSpeeds = new ArrayDeque<>();
    double x = -5;
    double vx = 0;
    double theirs = 0;
    double their = 0;
    boolean pulls = false;
    for (int i = 0; i < 3000; i++) {
      pulls |= theirs - x < distance;
      // It stops a robot's width before ours, as bystanders do.
      boolean stops = theirs - x < 0.45;
      their = !pulls ? 0 : stops ? Math.max(0, their - 3.5 * TICK) : Math.min(1, their + 3 * TICK);
      theirs -= their * TICK;
      speeds.add(vx);
      theirSpeeds.add(-their);
      // Vision knows velocities late.
      boolean late = speeds.size() > 8;
      double vision = late ? speeds.remove() : 0;
      double other = late ? theirSpeeds.remove() : 0;
      Robot robot = new Robot(FakeField.YELLOW, x, 0, 0, vision, 0, i * TICK);
      Robot third = new Robot(FakeField.THIRD, theirs, 0, 0, other, 0, i * TICK);
      following.look(robot, TICK);
      Velocity order =
          safety.limited(
              robot, new Velocity(2, 0, 0), following, List.of(robot, third), List.of(robot));
      following.update(robot, true, order, TICK);
      wheels.follow(order);
      vx = wheels.vx();
      x += vx * TICK;
      assertThat(theirs - x > 0.18 || vx < 0.1)
          .as("tick %d: %.3f m apart, our robot drives %.2f m/s", i, theirs - x, vx)
          .isTrue();
    }
    assertThat(pulls || theirs - x < 0.6).as("it gets there").isTrue();
  }

  /** When vision fails, the play tells its robots to stand: they brake along their way. */
  @ParameterizedTest
  @ValueSource(ints = {5, 10, 20, 45, 90})
  void whoIsStoppedAtAnyMomentStaysInside(int degrees) {
    Safety safety = new Safety(new PlayArea(12, 9, 0.2, 0), PlayLimits.DEFAULT);
    Following following = known();
    double angle = Math.toRadians(degrees);
    Velocity outward = new Velocity(2.5 * Math.cos(angle), 2.5 * Math.sin(angle), 0);
    Wheels wheels = Wheels.prompt(TICK, DELAY, ACCELERATION);
    wheels.start(outward.vx(), outward.vy());
    double y = 3.5;
    double vx = outward.vx();
    double vy = outward.vy();
    for (int i = 0; i < 1000; i++) {
      Robot robot = new Robot(FakeField.YELLOW, 0, y, 0, vx, vy, i * TICK);
      following.look(robot, TICK);
      wheels.follow(safety.limited(robot, outward, following, List.of(robot), List.of(robot)));
      vx = wheels.vx();
      vy = wheels.vy();
      y += vy * TICK;
      double way = Math.max(0, vy) * (DELAY * TICK + Math.hypot(vx, vy) / (2 * ACCELERATION));
      assertThat(y + way).as("tick %d", i).isLessThan(4.7);
    }
  }

  /**
   * As in a play in which a robot drove beside its way and along the edge when the other one was taken off: it was told to stand, and went on outward for 9 cm while it braked. Nobody knows yet that it
   * drives beside its way.
   */
  @ParameterizedTest
  @CsvSource({"5, 4", "20, -4", "10, 4", "10, 0", "20, 4", "45, 4", "90, 4", "5, 6"})
  void whoFollowsLateAndIsStoppedAtAnyMomentStaysInside(int degrees, int beside) {
    Safety safety = new Safety(new PlayArea(12, 9, 0.2, 0), PlayLimits.DEFAULT);
    Following following = late();
    double angle = Math.toRadians(degrees);
    Velocity wanted = new Velocity(1.8 * Math.cos(angle), 1.8 * Math.sin(angle), 0);
    Wheels wheels = Wheels.sluggish(TICK, Math.toRadians(beside));
    Deque<Robot> inSight = new ArrayDeque<>();
    double y = 3.5;
    for (int i = 0; i < 1500; i++) {
      inSight.add(new Robot(FakeField.YELLOW, 0, y, 0, wheels.vx(), wheels.vy(), i * TICK));
      // Vision knows velocities late.
      Robot late = inSight.size() > 8 ? inSight.remove() : inSight.peek();
      Robot robot = new Robot(FakeField.YELLOW, 0, y, 0, late.vx(), late.vy(), i * TICK);
      following.look(robot, TICK);
      wheels.follow(safety.limited(robot, wanted, following, List.of(robot), List.of(robot)));
      y += wheels.vy() * TICK;
      assertThat(4.7 - y - overrun(wheels)).as("tick %d", i).isGreaterThan(0.01);
    }
    assertThat(y).as("it still gets near the edge").isGreaterThan(4.4);
  }

  /**
   * As in plays whose vision was 0.15 s late, with robots that heard after 0.12 s and followed with a lag of 0.25 s: they turned away while they drove along the edge, what they were ordered was meant
   * for where they had looked before, and they drove 0.25 m out.
   */
  @ParameterizedTest
  @CsvSource({"4.4, 2.9, 4.9", "4.4, 2.9, -3.5", "4, 2.9, 4.9", "4.4, 2.9, 0"})
  void whoTurnsAndFollowsLateStaysInside(double fromX, double fromY, double turn) {
    Safety safety = new Safety(new PlayArea(9, 6, 0, 0), PlayLimits.DEFAULT);
    Following following = new Following(PlayLimits.DEFAULT.braking());
    double x = fromX;
    double y = fromY;
    double heading = 0;
    double vx = 0;
    double vy = 0;
    double angular = 0;
    Deque<double[]> inSight = new ArrayDeque<>();
    Deque<double[]> onTheWay = new ArrayDeque<>();
    double farthest = -9;
    for (int i = 0; i < 400; i++) {
      inSight.add(new double[] {x, y, heading, vx, vy, angular});
      double[] seen = inSight.size() > 15 ? inSight.remove() : inSight.peek();
      double known = seen[2] + 0.15 * seen[5];
      Robot robot =
          new Robot(
              FakeField.YELLOW,
              seen[0] + 0.15 * seen[3],
              seen[1] + 0.15 * seen[4],
              known,
              seen[3],
              seen[4],
              i * TICK);
      following.look(robot, TICK);
      double left = Math.IEEEremainder(Math.copySign(3, turn) - known, 2 * Math.PI);
      Velocity wanted =
          new Velocity(0, -1.8, Math.max(-Math.abs(turn), Math.min(Math.abs(turn), 3 * left)));
      Velocity order = safety.limited(robot, wanted, following, List.of(robot), List.of(robot));
      following.update(robot, true, order, TICK);
      onTheWay.add(new double[] {order.vx(), order.vy(), order.angular(), known});
      double[] told = onTheWay.size() > 12 ? onTheWay.remove() : new double[4];
      double off = heading - told[3];
      double dx = told[0] * Math.cos(off) - told[1] * Math.sin(off) - vx;
      double dy = told[0] * Math.sin(off) + told[1] * Math.cos(off) - vy;
      double share = Math.min(1 / 0.25, 2.5 / Math.hypot(dx, dy)) * TICK;
      vx += dx == 0 && dy == 0 ? 0 : share * dx;
      vy += dx == 0 && dy == 0 ? 0 : share * dy;
      angular += (told[2] - angular) / 0.25 * TICK;
      x += vx * TICK;
      y += vy * TICK;
      heading += angular * TICK;
      farthest = Math.max(farthest, Math.max(Math.abs(x) - 4.5, y - 3));
      if (y < -1) {
        break;
      }
    }
    assertThat(farthest).as("how far outside").isLessThan(0);
    assertThat(y).as("it gets ahead").isLessThan(-1);
  }

  /** How far it goes on along y when it is told to stand, m. */
  private static double overrun(Wheels wheels) {
    Wheels stopped = wheels.copy();
    double y = 0;
    double farthest = 0;
    for (int i = 0; i < 300; i++) {
      stopped.follow(Velocity.ZERO);
      y += stopped.vy() * TICK;
      farthest = Math.max(farthest, y);
    }
    return farthest;
  }

  /** The gains for robots that follow late, as far as they are measured. */
  private static Following late() {
    Following following = new Following(PlayLimits.DEFAULT.braking());
    Wheels wheels = Wheels.sluggish(TICK, 0);
    Deque<Double> speeds = new ArrayDeque<>();
    for (int i = 0; i < 2000; i++) {
      Velocity order = new Velocity(Math.max(0, 1.8 - 0.013 * Math.max(0, i % 250 - 100)), 0, 0);
      speeds.add(wheels.vx());
      double speed = speeds.size() > 8 ? speeds.remove() : 0;
      Robot robot = new Robot(FakeField.YELLOW, 0, 0, 0, speed, 0, i * TICK);
      following.update(robot, true, order, TICK);
      wheels.follow(order);
    }
    return following;
  }

  /** The gains for robots that follow as usual. */
  private static Following known() {
    Following following = new Following(PlayLimits.DEFAULT.braking());
    for (int i = 0; i < 2000; i++) {
      double speed = Math.max(0, 2 - 0.02 * (i % 200));
      Robot robot = new Robot(FakeField.YELLOW, 0, 0, 0, speed + 0.1, 0, i * TICK);
      following.update(robot, true, new Velocity(speed, 0, 0), TICK);
    }
    return following;
  }
}
