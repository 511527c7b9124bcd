package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Velocity;
import java.util.List;

/**
 * Limits every velocity before it is sent: no robot closes in on another, or on the edge of the area, faster than it can still brake; before a bystander that stands, even if that one pulls out. Our
 * robots give way to a robot that drives into them.
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

  /** Distance from the edge of the area at which robots are held, m: a little beyond their targets, so that they reach these. */
  private static final double HELD = 0.75 * PlayArea.RESERVE;

  /**
   * Speed per distance from there, 1/s, outward before it and inward beyond. For robots that follow as usual, times their delay of 0.13 s, this is 1.3: from π/2 on such a control oscillates.
   * Others drive outward more calmly.
   */
  private static final double GAIN = 10;

  /** The part of its speed with which any robot may drive beside its way: 5°; chosen, a robot of which this was not found out yet must stay inside, too. */
  private static final double BESIDE = 0.09;

  /** Acceleration with which a bystander may pull out, m/s²: the most that ER-Force orders its robots of 2020 (robotics-erlangen/framework, config/robots/generation_2020.txt, strategy). */
  private static final double BYSTANDER = 3;

  /** A contact that is no faster harms nobody, m/s: the goal of the play. */
  private static final double HARMLESS = 0.1;

  /** Speed beside its way that a turning robot may have anywhere, m/s: a turn while it creeps hardly matters. */
  private static final double TURNED = 0.1;

  private static final int ROUNDS = 3;

  private final PlayArea area;
  private final double braking;
  private final double clearance;

  Safety(PlayArea area, PlayLimits limits) {
    this.area = area;
    braking = limits.braking();
    clearance = limits.clearance();
  }

  /** How a robot can react: its delay, s, its deceleration, m/s², and the part of the usual gains that it tolerates. */
  private record Able(double delay, double braking, double calm) {}

  /** How far it is to where a robot is held, in the four directions, when it begins to do what it is ordered now, m; negative beyond. */
  private record Room(double right, double left, double up, double down) {}

  /** The velocity nearest to the wanted one that is safe for a robot that follows its orders this late. */
  Velocity limited(
      Robot robot, Velocity wanted, Following following, List<Robot> others, List<Robot> ours) {
    double[] v = {wanted.vx(), wanted.vy()};
    double calm = following.calm();
    Able able = new Able(Math.max(DELAY, following.late()), calm * braking, calm);
    Room room = room(robot, following, able);
    v[0] *= alongEdge(Math.min(room.up(), room.down()));
    v[1] *= alongEdge(Math.min(room.right(), room.left()));
    double later = Math.max(0, following.late() - Following.USUAL);
    double turn = turnInside(room, robot, later, able, v);
    double angular = Math.max(-turn, Math.min(turn, wanted.angular()));
    double beside = BESIDE + later * Math.abs(angular);
    for (int round = 0; round < ROUNDS; round++) {
      for (Robot other : others) {
        if (!other.id().equals(robot.id())) {
          keepApart(robot, other, ours.contains(other), following, able, v);
        }
      }
      keepInside(room, robot, beside, able, v);
    }
    return new Velocity(v[0], v[1], angular);
  }

  private void keepApart(
      Robot robot, Robot other, boolean ours, Following following, Able able, double[] v) {
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
    double gap =
        distance - 2 * PlayArea.ROBOT_RADIUS - 0.5 * clearance - following.beyond(robot, nx, ny);
    double ahead = gap - Math.max(0, mine + theirs) * able.delay();
    double allowed;
    if (ahead < 0) {
      allowed = -APART * Math.min(1, -ahead / 0.03) - (ours ? 0 : Math.max(0, theirs));
    } else {
      // Two of our robots share the distance that is left; the motion of others is subtracted.
      double share = ours && theirs > 0.02 ? 0.5 : 1;
      allowed = share * Math.sqrt(2 * able.braking() * ahead) - (ours ? 0 : Math.max(0, theirs));
      allowed = Math.min(allowed, 8 * ahead);
      if (!ours) {
        allowed =
            Math.min(allowed, Math.max(HARMLESS, beforeReach(ahead, able) - Math.max(0, theirs)));
      }
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

  /**
   * Fastest closing speed from which a robot stops before a bystander that may begin to drive towards it now: with the speed v, its delay t and its braking b, v² / 2b + a (t + v / b)² / 2 is the
   * distance between them.
   */
  private static double beforeReach(double ahead, Able able) {
    double perBraking = BYSTANDER / able.braking();
    double squared = (1 + perBraking) / (2 * able.braking());
    double linear = perBraking * able.delay();
    double free = ahead - 0.5 * BYSTANDER * able.delay() * able.delay();
    return free > 0
        ? (Math.sqrt(linear * linear + 4 * squared * free) - linear) / (2 * squared)
        : 0;
  }

  private Room room(Robot robot, Following following, Able able) {
    double x = area.length() / 2 + area.margin() - HELD;
    double y = area.width() / 2 + area.margin() - HELD;
    return new Room(
        ahead(x - robot.x() - following.beyond(robot, 1, 0), robot.vx(), able),
        ahead(x + robot.x() - following.beyond(robot, -1, 0), -robot.vx(), able),
        ahead(y - robot.y() - following.beyond(robot, 0, 1), robot.vy(), able),
        ahead(y + robot.y() - following.beyond(robot, 0, -1), -robot.vy(), able));
  }

  /** A robot drives beside its way by a part of the speed that it has, or will have when it does what it is ordered: outward, if it comes to the worst. */
  private static void keepInside(Room room, Robot robot, double beside, Able able, double[] v) {
    double speed = Math.max(robot.speed(), Math.hypot(v[0], v[1]));
    double besideX = beside * Math.max(Math.abs(robot.vy()), Math.abs(v[1]));
    double besideY = beside * Math.max(Math.abs(robot.vx()), Math.abs(v[0]));
    double left = besideX - outward(room.left(), speed, able);
    double right = outward(room.right(), speed, able) - besideX;
    double down = besideY - outward(room.down(), speed, able);
    double up = outward(room.up(), speed, able) - besideY;
    v[0] = Math.max(left, Math.min(right, v[0]));
    v[1] = Math.max(down, Math.min(up, v[1]));
  }

  /**
   * Fastest turn, rad/s, of a robot that follows later than usual by {@code later}. What it is ordered is meant for the direction that it looks to as far as that is known: one that turns drives
   * beside its way by the angle that it has turned meanwhile. Robots that follow as usual turn as they want.
   */
  private static double turnInside(Room room, Robot robot, double later, Able able, double[] v) {
    double speedX = Math.max(Math.abs(robot.vx()), Math.abs(v[0]));
    double speedY = Math.max(Math.abs(robot.vy()), Math.abs(v[1]));
    double speed = Math.hypot(speedX, speedY);
    double x = outward(Math.min(room.left(), room.right()), speed, able);
    double y = outward(Math.min(room.down(), room.up()), speed, able);
    double angle = Math.min(Math.max(TURNED, x) / speedY, Math.max(TURNED, y) / speedX);
    return later > 0 ? angle / later : Double.POSITIVE_INFINITY;
  }

  private static double ahead(double room, double speed, Able able) {
    return room - Math.max(0, speed) * able.delay();
  }

  /**
   * Part of the speed along an edge that a robot keeps beyond the place where it is held; none at the edge. It drives beside its way by a part of its speed, and its wheels need their force to turn it
   * inward.
   */
  private static double alongEdge(double ahead) {
    return Math.max(0, Math.min(1, 1 + ahead / HELD));
  }

  /**
   * Fastest outward when there is this much room; inward when there is none, where a late robot that swings does no harm. A robot that is told to stand brakes along its way: the faster it is along
   * the edge, the longer it goes on outward.
   */
  private static double outward(double ahead, double speed, Able able) {
    if (ahead < 0) {
      return Math.max(-APART, GAIN * ahead);
    }
    double even = Math.min(able.calm() * GAIN, 2 * able.braking() / speed) * ahead;
    return Math.min(even, Math.sqrt(able.braking() * ahead));
  }
}
