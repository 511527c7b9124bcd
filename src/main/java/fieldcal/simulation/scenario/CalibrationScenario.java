package fieldcal.simulation.scenario;

import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.physics.MotionPhase;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Two robots kick the ball to each other: flat kicks along the diagonals, chips along the half-way line. Others stand about. A ball that stopped far from the next kicker, or left the field, is
 * carried to it.
 */
public final class CalibrationScenario implements Scenario {
  /** How far from its place a kicker fetches the ball itself, m. */
  private static final double FETCH = 1.2;

  /** Distance of the dribbler from the ball's near side while a kicker waits: radius of the ball and 4 mm. */
  private static final double CLOSE = 0.0255;

  /** Time to get there, s. */
  private static final double SETTLING = 0.7;

  /** A kick that fails this often is left out, so that a robot that cannot make it does not try for ever. */
  private static final int MAX_ATTEMPTS = 4;

  private final ScenarioSettings settings;
  private final FieldSize field;
  private final List<KickPlan> plans;
  private final RandomStream random;
  private final List<SimulatedRobot> robots;
  private final SimulatedRobot[] players = new SimulatedRobot[2];

  private State state = State.PREPARE;
  private double since;
  private double pause = 0.5;
  private int next;
  private int attempts;
  private double aim;
  private int kicksBefore;
  private double restingSince = Double.NaN;

  private enum State {
    PREPARE,
    POSITION,
    DRIVE_UP,
    FOLLOW,
    DONE
  }

  /**
   * A scenario for the settings' kind of kicks.
   *
   * @param all the simulation's settings
   */
  public CalibrationScenario(SimulationSettings all) {
    settings = all.scenario();
    field = all.field();
    random = RandomStream.of(all.seed(), "calibration scenario");
    plans = KickPlan.of(settings, random);
    robots = createRobots();
    if (plans.isEmpty()) {
      state = State.DONE;
    }
  }

  private List<SimulatedRobot> createRobots() {
    boolean sameTeam = random.happens(0.5);
    int first = random.below(12);
    int second = (first + 1 + random.below(11)) % 12;
    RobotId[] ids = {
      new RobotId(Team.YELLOW, first), new RobotId(sameTeam ? Team.YELLOW : Team.BLUE, second)
    };
    List<SimulatedRobot> all = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      double side = i == 0 ? -1 : 1;
      players[i] =
          robot(ids[i], side * 0.3 * field.length(), side * 0.3 * field.width(), i * Math.PI);
      all.add(players[i]);
    }
    // Bystanders, off both diagonals and the half-way line.
    all.add(robot(new RobotId(Team.BLUE, 13), -0.3 * field.length(), 0.04 * field.width(), 0.4));
    all.add(robot(new RobotId(Team.YELLOW, 14), 0.3 * field.length(), -0.04 * field.width(), 2));
    all.sort(Comparator.comparing(SimulatedRobot::id));
    return List.copyOf(all);
  }

  private SimulatedRobot robot(RobotId id, double x, double y, double orientation) {
    RobotLimits limits = id.team() == Team.YELLOW ? settings.yellow() : settings.blue();
    return new SimulatedRobot(id, limits, random.uniform(0.14, 0.149), x, y, orientation);
  }

  @Override
  public List<SimulatedRobot> robots() {
    return robots;
  }

  @Override
  public boolean finished(SimulatedWorld world) {
    return state == State.DONE;
  }

  @Override
  public double progress(SimulatedWorld world) {
    return plans.isEmpty() ? 1 : (double) next / plans.size();
  }

  @Override
  public void tick(SimulatedWorld world) {
    noteRest(world);
    switch (state) {
      case PREPARE -> prepare(world);
      case POSITION -> position(world);
      case DRIVE_UP -> driveUp(world);
      case FOLLOW -> follow(world);
      case DONE -> {}
    }
  }

  private void noteRest(SimulatedWorld world) {
    boolean rests = world.ball().phase() == MotionPhase.RESTING && !world.ballCarried();
    if (!rests) {
      restingSince = Double.NaN;
    } else if (Double.isNaN(restingSince)) {
      restingSince = world.time();
    }
  }

  private void enter(State newState, SimulatedWorld world) {
    state = newState;
    since = world.time();
  }

  private KickPlan plan() {
    return plans.get(next);
  }

  private SimulatedRobot kicker() {
    return players[next % 2];
  }

  private SimulatedRobot receiver() {
    return players[1 - next % 2];
  }

  /** Where a player kicks from. */
  private double stationX(int player) {
    double side = player == 0 ? -1 : 1;
    return plan().chip() ? 0 : side * 0.38 * field.length();
  }

  private double stationY(int player) {
    double side = player == 0 ? -1 : 1;
    if (plan().chip()) {
      return side * 0.39 * field.width();
    }
    return side * (plan().mirrored() ? -1 : 1) * 0.34 * field.width();
  }

  private void prepare(SimulatedWorld world) {
    if (world.time() - since < pause) {
      return;
    }
    BallBody ball = world.ball();
    int player = next % 2;
    double x = stationX(player);
    double y = stationY(player);
    boolean inside =
        Math.abs(ball.x()) < field.length() / 2 - 0.2
            && Math.abs(ball.y()) < field.width() / 2 - 0.2;
    boolean near = Math.hypot(ball.x() - x, ball.y() - y) < FETCH;
    boolean rests = ball.phase() == MotionPhase.RESTING;
    // Far from the other robots the kicker can get round the ball.
    boolean free =
        robots.stream()
            .noneMatch(r -> r != kicker() && Math.hypot(r.x() - ball.x(), r.y() - ball.y()) < 0.3);
    if (!(inside && near && rests && free)) {
      double spread = plan().chip() ? 0.12 : 0.3;
      world.carryBall(x + random.uniform(-spread, spread), y + random.uniform(-0.3, 0.3), 0.7);
    }
    double offset = plan().aside();
    double targetX = stationX(1 - player);
    double targetY = stationY(1 - player);
    double fromX = inside && near && rests && free ? ball.x() : x;
    double fromY = inside && near && rests && free ? ball.y() : y;
    aim = Math.atan2(targetY - fromY, targetX - fromX) + offset;
    enter(State.POSITION, world);
  }

  private void position(SimulatedWorld world) {
    if (world.ballCarried()) {
      kicker().command(RobotCommand.HALT);
      placeReceiver(world);
      return;
    }
    BallBody ball = world.ball();
    kicker().command(BallApproach.command(kicker(), ball, aim, 2.5));
    placeReceiver(world);
    boolean calm = world.time() - restingSince > 0.7;
    if (calm && BallApproach.ready(kicker(), ball, aim)) {
      kicksBefore = world.kicks().finished().size();
      enter(State.DRIVE_UP, world);
    } else if (world.time() - since > 12) {
      giveUp(world);
    }
  }

  /** The receiver waits near the line of the kick, or well beside it. */
  private void placeReceiver(SimulatedWorld world) {
    int player = 1 - next % 2;
    double x = stationX(player);
    double y = stationY(player);
    BallBody ball = world.ball();
    double along = (x - ball.x()) * Math.cos(aim) + (y - ball.y()) * Math.sin(aim);
    double lineX = ball.x() + along * Math.cos(aim);
    double lineY = ball.y() + along * Math.sin(aim);
    double aside = plan().received() ? 0 : 0.5;
    double targetX = lineX - aside * Math.sin(aim);
    double targetY = lineY + aside * Math.cos(aim);
    if (Math.hypot(receiver().x() - ball.x(), receiver().y() - ball.y()) < 0.5) {
      return;
    }
    receiver().command(RobotCommand.driveTo(targetX, targetY, aim + Math.PI, 2.5));
  }

  private void driveUp(SimulatedWorld world) {
    BallBody ball = world.ball();
    if (world.kicks().running() || world.kicks().finished().size() > kicksBefore) {
      kicker().command(RobotCommand.HALT);
      enter(State.FOLLOW, world);
      return;
    }
    // Drives up to the ball, or just short of it to stand there first; then kicks.
    boolean waits = world.time() - since < plan().standing() + SETTLING;
    boolean stands = plan().standing() > 0 && waits;
    double reach = SimulatedRobot.FRONT + (stands ? CLOSE : 0);
    RobotCommand approach =
        RobotCommand.driveTo(
            ball.x() - reach * Math.cos(aim),
            ball.y() - reach * Math.sin(aim),
            aim,
            plan().driveUpSpeed());
    Kick order = new Kick(plan().speed(), plan().elevation());
    kicker().command(stands ? approach : approach.kicking(order));
    world.purpose("calibration");
    if (world.time() - since > 3) {
      giveUp(world);
    }
  }

  private void giveUp(SimulatedWorld world) {
    kicker().command(RobotCommand.HALT);
    world.carryBall(stationX(next % 2), stationY(next % 2), 0.7);
    pause = 0.8;
    attempts++;
    if (attempts == MAX_ATTEMPTS) {
      attempts = 0;
      next++;
    }
    enter(next == plans.size() ? State.DONE : State.PREPARE, world);
  }

  private void follow(SimulatedWorld world) {
    BallBody ball = world.ball();
    if (world.kicks().running() && world.time() - since < 30) {
      if (plan().received()) {
        receive(ball);
      }
      return;
    }
    List<KickTruth> kicks = world.kicks().finished();
    if (kicks.size() == kicksBefore) {
      // The kicker only pushed the ball.
      giveUp(world);
      return;
    }
    KickTruth last = kicks.get(kicks.size() - 1);
    double ended = last.time() + last.duration();
    if (world.time() - ended < 0.6) {
      return;
    }
    receiver().command(RobotCommand.HALT);
    next++;
    attempts = 0;
    pause = random.uniform(0.1, 0.5);
    enter(next == plans.size() ? State.DONE : State.PREPARE, world);
  }

  private void receive(BallBody ball) {
    double speed = ball.groundSpeed();
    if (speed < 0.1) {
      return;
    }
    SimulatedRobot r = receiver();
    double ux = ball.vx() / speed;
    double uy = ball.vy() / speed;
    double along = (r.x() - ball.x()) * ux + (r.y() - ball.y()) * uy;
    if (along < 0) {
      return;
    }
    double x = ball.x() + along * ux;
    double y = ball.y() + along * uy;
    double facing = Math.atan2(-uy, -ux);
    r.command(RobotCommand.driveTo(x, y, facing, 2.5).dribbling());
  }
}
