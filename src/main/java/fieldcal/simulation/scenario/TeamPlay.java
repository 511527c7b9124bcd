package fieldcal.simulation.scenario;

import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.TeamManner;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.SimulatedRobot;
import java.util.Comparator;
import java.util.List;

/** One team in play: a keeper, one robot at the ball, the others on the move. */
final class TeamPlay {
  private static final double HYSTERESIS = 0.4;

  /** Distance from its target within which a robot looks at the ball in any case, m; chosen, half of the way that it drives fast. */
  private static final double TURNS_WITHIN = 0.5;

  private final FieldSize field;
  private final RandomStream random;
  private final List<SimulatedRobot> robots;
  private final double[] targetX;
  private final double[] targetY;
  private final double[] targetUntil;
  private final TeamManner.Facing looks;
  private final BallHandler handler;

  private SimulatedRobot chaser;

  TeamPlay(
      FieldSize field, List<SimulatedRobot> robots, TeamManner.Facing looks, RandomStream random) {
    this.looks = looks;
    this.field = field;
    this.robots = robots;
    this.random = random;
    targetX = new double[robots.size()];
    targetY = new double[robots.size()];
    targetUntil = new double[robots.size()];
    handler = new BallHandler(field, robots, random);
  }

  List<SimulatedRobot> robots() {
    return robots;
  }

  /** How far the team's nearest field player is from the ball; picks it. */
  double reach(SimulatedWorld world) {
    BallBody ball = world.ball();
    SimulatedRobot receiver = handler.receiver(world);
    if (receiver != null) {
      chaser = receiver;
      return 0;
    }
    SimulatedRobot nearest =
        robots.stream()
            .skip(robots.size() > 1 ? 1 : 0)
            .min(Comparator.comparingDouble(r -> distance(r, ball)))
            .orElseThrow();
    if (chaser == null || distance(nearest, ball) < distance(chaser, ball) - HYSTERESIS) {
      chaser = nearest;
    }
    return world.holder().filter(robots::contains).isPresent() ? -1 : distance(chaser, ball);
  }

  /** Commands for the running game. */
  void play(SimulatedWorld world, int attack, boolean atTheBall) {
    SimulatedRobot holder = world.holder().filter(robots::contains).orElse(null);
    if (holder != null) {
      chaser = holder;
    }
    for (int i = 0; i < robots.size(); i++) {
      SimulatedRobot robot = robots.get(i);
      if (robot == chaser && atTheBall) {
        robot.command(handler.command(world, robot, attack));
      } else if (i == 0 && robots.size() > 1) {
        robot.command(keep(world, robot, attack));
      } else if (robot == chaser) {
        robot.command(press(world, robot, attack));
      } else {
        robot.command(roam(world, i, 0.5, Double.MAX_VALUE));
      }
    }
  }

  /** Commands while the ball must not be touched. */
  void stayAway(SimulatedWorld world, double maxSpeed) {
    handler.forget();
    for (int i = 0; i < robots.size(); i++) {
      robots.get(i).command(roam(world, i, 0.8, maxSpeed));
    }
  }

  void halt() {
    handler.forget();
    robots.forEach(r -> r.command(RobotCommand.HALT));
  }

  private RobotCommand keep(SimulatedWorld world, SimulatedRobot robot, int attack) {
    BallBody ball = world.ball();
    double goalX = -attack * field.length() / 2;
    double angle = Math.atan2(ball.y(), ball.x() - goalX);
    double x = goalX + 0.5 * Math.cos(angle);
    double y = 0.7 * Math.sin(angle);
    return Driving.to(world, robot, x, y, angle, 2);
  }

  /** Between the ball and the own goal, at a distance. */
  private RobotCommand press(SimulatedWorld world, SimulatedRobot robot, int attack) {
    BallBody ball = world.ball();
    double goalX = -attack * field.length() / 2;
    double angle = Math.atan2(-ball.y(), goalX - ball.x());
    double away = 0.7;
    return Driving.to(
        world,
        robot,
        ball.x() + away * Math.cos(angle),
        ball.y() + away * Math.sin(angle),
        angle + Math.PI,
        Double.MAX_VALUE);
  }

  private RobotCommand roam(SimulatedWorld world, int i, double clearance, double maxSpeed) {
    SimulatedRobot robot = robots.get(i);
    if (world.time() >= targetUntil[i]) {
      targetUntil[i] = world.time() + random.uniform(1.5, 3.5);
      targetX[i] = random.uniform(-0.45, 0.45) * field.length();
      targetY[i] = random.uniform(-0.45, 0.45) * field.width();
    }
    double x = targetX[i];
    double y = targetY[i];
    BallBody ball = world.ball();
    double away = Math.hypot(x - ball.x(), y - ball.y());
    if (away < clearance) {
      double scale = away == 0 ? 0 : clearance / away;
      x = ball.x() + (away == 0 ? clearance : scale * (x - ball.x()));
      y = ball.y() + scale * (y - ball.y());
    }
    boolean ahead =
        looks == TeamManner.Facing.TARGET
            && Math.hypot(x - robot.x(), y - robot.y()) > TURNS_WITHIN;
    double toBall = Math.atan2(ball.y() - robot.y(), ball.x() - robot.x());
    double facing = ahead ? Math.atan2(y - robot.y(), x - robot.x()) : toBall;
    double tooClose = Math.hypot(robot.x() - ball.x(), robot.y() - ball.y());
    if (tooClose < 0.6 * clearance) {
      // Off the ball first, the straight way.
      return RobotCommand.driveTo(
          robot.x() - 0.5 * Math.cos(toBall), robot.y() - 0.5 * Math.sin(toBall), toBall, maxSpeed);
    }
    return Driving.to(world, robot, x, y, facing, maxSpeed);
  }

  private static double distance(SimulatedRobot robot, BallBody ball) {
    // Where the ball will be in half a second matters more than where it is.
    return Math.hypot(
        robot.x() - ball.x() - 0.5 * ball.vx(), robot.y() - ball.y() - 0.5 * ball.vy());
  }
}
