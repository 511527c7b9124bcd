package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Velocity;
import java.util.List;

/**
 * Limits every velocity before it is sent: no robot closes in on another, or on the edge of the area, faster than it can still brake. Our robots give way to a robot that drives into them.
 */
final class Safety {
  /** From camera to wheel and back, s; more for robots that follow later. */
  private static final double DELAY = 0.06;

  /** How fast robots that are too close move apart, m/s. */
  private static final double APART = 0.4;

  /** A robot that closes in faster than allowed by more than this must only brake, m/s. */
  private static final double LATE = 0.15;

  /** The part of its sideways motion that it keeps then. */
  private static final double ASIDE = 0.9;

  /** Inward speed per distance beyond, 1/s: a robot that drives 4° beside its way along the edge at 2.5 m/s is held within 2 cm. */
  private static final double PUSH_BACK = 10;

  private static final int ROUNDS = 3;

  private final PlayArea area;
  private final double braking;
  private final double clearance;

  Safety(PlayArea area, PlayLimits limits) {
    this.area = area;
    braking = limits.braking();
    clearance = limits.clearance();
  }

  /** How a robot can react: its delay, s, and its deceleration, m/s². */
  private record Able(double delay, double braking) {}

  /** The velocity nearest to the wanted one that is safe for a robot that follows its orders this late. */
  Velocity limited(
      Robot robot, Velocity wanted, Following following, List<Robot> others, List<Robot> ours) {
    double[] v = {wanted.vx(), wanted.vy()};
    Able able = new Able(Math.max(DELAY, following.late()), following.calm() * braking);
    for (int round = 0; round < ROUNDS; round++) {
      for (Robot other : others) {
        if (!other.id().equals(robot.id())) {
          keepApart(robot, other, ours.contains(other), able, v);
        }
      }
      keepInside(robot, able, v);
    }
    return new Velocity(v[0], v[1], wanted.angular());
  }

  private void keepApart(Robot robot, Robot other, boolean ours, Able able, double[] v) {
    double dx = other.x() - robot.x();
    double dy = other.y() - robot.y();
    double distance = Math.hypot(dx, dy);
    if (distance > 3 || distance == 0) {
      return;
    }
    double nx = dx / distance;
    double ny = dy / distance;
    double theirs = -(other.vx() * nx + other.vy() * ny);
    double mine = robot.vx() * nx + robot.vy() * ny;
    double gap = distance - 2 * PlayArea.ROBOT_RADIUS - 0.5 * clearance;
    double ahead = gap - Math.max(0, mine + theirs) * able.delay();
    double allowed;
    if (ahead < 0) {
      allowed = -APART * Math.min(1, -ahead / 0.03) - (ours ? 0 : Math.max(0, theirs));
    } else {
      // Two of our robots share the distance that is left; the motion of others is subtracted.
      double share = ours && theirs > 0.02 ? 0.5 : 1;
      allowed = share * Math.sqrt(2 * able.braking() * ahead) - (ours ? 0 : Math.max(0, theirs));
      allowed = Math.min(allowed, 8 * ahead);
    }
    if (mine > Math.max(0, allowed) + LATE) {
      // The wheels use all their force to brake: turning aside meanwhile would weaken that.
      v[0] = allowed * nx + ASIDE * (robot.vx() - mine * nx);
      v[1] = allowed * ny + ASIDE * (robot.vy() - mine * ny);
      return;
    }
    double closing = v[0] * nx + v[1] * ny;
    if (closing > allowed) {
      v[0] -= (closing - allowed) * nx;
      v[1] -= (closing - allowed) * ny;
    }
  }

  private void keepInside(Robot robot, Able able, double[] v) {
    v[0] = inside(robot.x(), robot.vx(), able, v[0], area.length() / 2 + area.margin());
    v[1] = inside(robot.y(), robot.vy(), able, v[1], area.width() / 2 + area.margin());
  }

  private static double inside(
      double position, double speed, Able able, double wanted, double limit) {
    double low = -outward(position + limit, -speed, able);
    double high = outward(limit - position, speed, able);
    return Math.max(low, Math.min(high, wanted));
  }

  /** Fastest outward when there is this much room; inward when there is none. */
  private static double outward(double room, double speed, Able able) {
    double ahead = room - 0.75 * PlayArea.RESERVE - Math.max(0, speed) * able.delay();
    return ahead < 0 ? Math.max(-APART, PUSH_BACK * ahead) : Math.sqrt(able.braking() * ahead);
  }
}
