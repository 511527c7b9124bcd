package fieldcal.simulation.scenario;

import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.SimulatedRobot;
import java.util.List;

/** What a team's robot at the ball does: fetch, receive, redirect, dribble, pass, chip, shoot. */
final class BallHandler {
  private static final double GRAVITY = 9.81;
  private static final double MAX_REDIRECTION = 1;
  private static final double CHIP_ELEVATION = Math.toRadians(44);

  private final FieldSize field;
  private final List<SimulatedRobot> team;
  private final RandomStream random;

  private SimulatedRobot actor;
  private Plan plan;
  private double dribbleUntil;
  private SimulatedRobot receiver;
  private boolean redirects;
  private double meetX = Double.NaN;
  private double meetY;
  private int startedBefore;
  private double driveUpSince = Double.NaN;

  /** What to do with the ball. */
  private record Plan(
      String purpose,
      SimulatedRobot to,
      double x,
      double y,
      Kick kick,
      boolean grabs,
      boolean redirected) {

    Plan grabbing() {
      return new Plan(purpose, to, x, y, kick, true, redirected);
    }

    Plan following() {
      return to == null ? this : new Plan(purpose, to, to.x(), to.y(), kick, grabs, redirected);
    }
  }

  BallHandler(FieldSize field, List<SimulatedRobot> team, RandomStream random) {
    this.field = field;
    this.team = team;
    this.random = random;
  }

  void forget() {
    plan = null;
    actor = null;
    receiver = null;
    driveUpSince = Double.NaN;
  }

  /** The robot that a running pass is meant for; null when there is none. */
  SimulatedRobot receiver(SimulatedWorld world) {
    if (receiver != null && world.kicks().finished().size() > startedBefore) {
      receiver = null;
    }
    return started(world) > startedBefore ? receiver : null;
  }

  private static int started(SimulatedWorld world) {
    return world.kicks().finished().size() + (world.kicks().running() ? 1 : 0);
  }

  RobotCommand command(SimulatedWorld world, SimulatedRobot robot, int attack) {
    if (robot != actor) {
      actor = robot;
      plan = null;
      driveUpSince = Double.NaN;
    }
    BallBody ball = world.ball();
    if (world.holder().orElse(null) == robot) {
      return withBall(world, robot, attack);
    }
    double speed = ball.groundSpeed();
    if (receiver(world) == robot || speed > 0.7) {
      return intercept(world, robot, attack);
    }
    if (plan == null) {
      plan = choose(robot, attack);
    }
    if (plan.grabs() || speed > 0.05) {
      double angle = Math.atan2(ball.y() - robot.y(), ball.x() - robot.x());
      double turn = Math.IEEEremainder(angle - robot.orientation(), 2 * Math.PI);
      double distance = Math.hypot(ball.x() - robot.x(), ball.y() - robot.y());
      if (distance < 0.4 && Math.abs(turn) > 0.15) {
        return RobotCommand.driveTo(robot.x(), robot.y(), angle, 1);
      }
      // A little beyond the ball, so that the dribbler reaches it.
      double ahead = SimulatedRobot.FRONT + 0.01;
      return RobotCommand.driveTo(
              ball.x() - ahead * Math.cos(angle),
              ball.y() - ahead * Math.sin(angle),
              angle,
              distance < 0.4 ? 0.6 : 2.5)
          .dribbling();
    }
    return kickFromRest(world, robot);
  }

  private RobotCommand kickFromRest(SimulatedWorld world, SimulatedRobot robot) {
    BallBody ball = world.ball();
    double aim = Math.atan2(plan.y() - ball.y(), plan.x() - ball.x());
    if (Double.isNaN(driveUpSince)) {
      if (BallApproach.ready(robot, ball, aim)) {
        driveUpSince = world.time();
      }
      return BallApproach.command(robot, ball, aim, 2.5);
    }
    if (world.time() - driveUpSince > 2) {
      forget();
      return RobotCommand.HALT;
    }
    announce(world);
    return RobotCommand.driveTo(
            ball.x() - SimulatedRobot.FRONT * Math.cos(aim),
            ball.y() - SimulatedRobot.FRONT * Math.sin(aim),
            aim,
            0.4)
        .kicking(plan.kick());
  }

  private RobotCommand withBall(SimulatedWorld world, SimulatedRobot robot, int attack) {
    if (plan == null || !plan.grabs()) {
      plan = choose(robot, attack).grabbing();
      dribbleUntil = world.time() + (random.happens(0.4) ? random.uniform(0.4, 1.2) : 0.1);
    }
    plan = plan.following();
    double aim = Math.atan2(plan.y() - robot.y(), plan.x() - robot.x());
    boolean aligned = Math.abs(Math.IEEEremainder(aim - robot.orientation(), 2 * Math.PI)) < 0.02;
    if (world.time() < dribbleUntil) {
      double speed = 0.8;
      return new RobotCommand(
          new RobotCommand.Velocity(speed * Math.cos(aim), speed * Math.sin(aim), 0),
          Kick.NONE,
          true);
    }
    RobotCommand turn = RobotCommand.driveTo(robot.x(), robot.y(), aim, 0.5).dribbling();
    if (!aligned) {
      return turn;
    }
    announce(world);
    return turn.kicking(plan.kick());
  }

  /** The kick is about to happen: its purpose for the truth, and who is to receive it. */
  private void announce(SimulatedWorld world) {
    world.purpose(plan.purpose());
    receiver = plan.to();
    redirects = plan.redirected();
    meetX = Double.NaN;
    startedBefore = started(world);
  }

  private RobotCommand intercept(SimulatedWorld world, SimulatedRobot robot, int attack) {
    plan = null;
    driveUpSince = Double.NaN;
    BallBody ball = world.ball();
    double speed = ball.groundSpeed();
    if (speed < 0.3) {
      // A pass that is not under way yet: wait for it.
      return RobotCommand.driveTo(
          robot.x(), robot.y(), Math.atan2(ball.y() - robot.y(), ball.x() - robot.x()), 1);
    }
    double ux = ball.vx() / speed;
    double uy = ball.vy() / speed;
    double along = (robot.x() - ball.x()) * ux + (robot.y() - ball.y()) * uy;
    if (along < 0.1) {
      // Behind the ball: after it, mouth first.
      return RobotCommand.driveTo(
              ball.x() + 0.4 * ball.vx(),
              ball.y() + 0.4 * ball.vy(),
              Math.atan2(ball.y() - robot.y(), ball.x() - robot.x()),
              10)
          .dribbling();
    }
    double x = ball.x() + along * ux;
    double y = ball.y() + along * uy;
    double facing = Math.atan2(-uy, -ux);
    double aim = redirects && robot == receiver ? redirection(x, y, facing, attack) : Double.NaN;
    if (!Double.isNaN(aim)) {
      return redirect(world, ball, aim, along);
    }
    return RobotCommand.driveTo(x, y, facing, 10).dribbling();
  }

  /** Waits with the mouth on the ball's line, at a point that does not move with the robot. */
  private RobotCommand redirect(SimulatedWorld world, BallBody ball, double aim, double along) {
    double speed = ball.groundSpeed();
    double ux = ball.vx() / speed;
    double uy = ball.vy() / speed;
    if (Double.isNaN(meetX)) {
      meetX = ball.x() + along * ux;
      meetY = ball.y() + along * uy;
    }
    double toMeeting = (meetX - ball.x()) * ux + (meetY - ball.y()) * uy;
    double mouth = SimulatedRobot.FRONT + 0.02;
    double x = ball.x() + toMeeting * ux - mouth * Math.cos(aim);
    double y = ball.y() + toMeeting * uy - mouth * Math.sin(aim);
    world.purpose("redirect");
    return RobotCommand.driveTo(x, y, aim, 10).kicking(new Kick(5, 0));
  }

  /** Where to send the ball at the first touch: to the goal or a team mate, not too far from where it comes from; NaN if there is nobody. */
  private double redirection(double x, double y, double facing, int attack) {
    double toGoal = Math.atan2(-y, attack * field.length() / 2 - x);
    if (Math.abs(Math.IEEEremainder(toGoal - facing, 2 * Math.PI)) < MAX_REDIRECTION) {
      return toGoal;
    }
    for (SimulatedRobot mate : team) {
      double toMate = Math.atan2(mate.y() - y, mate.x() - x);
      double turn = Math.abs(Math.IEEEremainder(toMate - facing, 2 * Math.PI));
      if (mate != receiver && turn > 0.3 && turn < MAX_REDIRECTION) {
        return toMate;
      }
    }
    return Double.NaN;
  }

  private Plan choose(SimulatedRobot robot, int attack) {
    double goalX = attack * field.length() / 2;
    double goalDistance = Math.hypot(goalX - robot.x(), robot.y());
    boolean grabs = random.happens(0.4);
    SimulatedRobot mate = mate(robot);
    if (mate == null || goalDistance < 4 && random.happens(0.5)) {
      double y = random.uniform(-0.45, 0.45) * field.goalWidth();
      return new Plan("shot", null, goalX, y, new Kick(random.uniform(5, 6.3), 0), grabs, false);
    }
    double distance = Math.hypot(mate.x() - robot.x(), mate.y() - robot.y());
    if (distance > 1.5 && random.happens(0.22)) {
      // The first flight covers half of the way.
      double speed = Math.sqrt(0.5 * distance * GRAVITY / Math.sin(2 * CHIP_ELEVATION));
      double limited = Math.max(2.6, Math.min(6, speed));
      return new Plan(
          "chip_pass", mate, mate.x(), mate.y(), new Kick(limited, CHIP_ELEVATION), grabs, false);
    }
    double arrival = random.uniform(1.5, 2.5);
    double speed = Math.sqrt(arrival * arrival + 2 * 0.3 * distance) / 0.65;
    double limited = Math.max(1.8, Math.min(6.2, speed));
    return new Plan(
        "pass", mate, mate.x(), mate.y(), new Kick(limited, 0), grabs, random.happens(0.3));
  }

  /** Somebody to play to: not the keeper, not too close. */
  private SimulatedRobot mate(SimulatedRobot robot) {
    List<SimulatedRobot> mates =
        team.stream()
            .skip(1)
            .filter(m -> m != robot)
            .filter(m -> Math.hypot(m.x() - robot.x(), m.y() - robot.y()) > 1)
            .toList();
    return mates.isEmpty() ? null : mates.get(random.below(mates.size()));
  }
}
