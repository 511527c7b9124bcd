package fieldcal.simulation;

import fieldcal.simulation.imaging.RobotView;
import fieldcal.simulation.imaging.Scene;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.physics.BallEvent;
import fieldcal.simulation.physics.BallHistory;
import fieldcal.simulation.physics.BallIntegrator;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.BallTrace;
import fieldcal.simulation.robot.Contact;
import fieldcal.simulation.robot.RobotCharacter;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.EndReason;
import fieldcal.simulation.truth.KickKind;
import fieldcal.simulation.truth.KickLog;
import fieldcal.simulation.truth.KickTruth.KickCommand;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Ball and robots on a field. Robots obey the commands they were given last; {@link #tick} moves everything by {@link #TICK}. Not thread-safe.
 */
public final class SimulatedWorld implements Scene {
  /** Time between two commands, s. */
  public static final double TICK = 0.005;

  /** Distance beyond the lines at which a ball has left the field, m. */
  public static final double OUT = 0.25;

  private static final int SUBSTEPS = 5;

  /** Time that a kicker needs to recharge, s. */
  private static final double RECHARGE = 0.1;

  /** Height up to which a kicker and a dribbler reach the ball, m. */
  private static final double KICKER_HEIGHT = 0.03;

  private final FieldSize field;
  private final BallBody ball = new BallBody();
  private final BallHistory history = new BallHistory();
  private final KickLog kicks = new KickLog(history);
  private final BallIntegrator integrator;
  private final double ballRadius;
  private final Kicker kicker;
  private final List<SimulatedRobot> robots;
  private final double[] readyToKick;
  private final RobotHistory robotHistory = new RobotHistory();
  private final BallTrace trace;

  private long ticks;
  private double time;
  private final Set<RobotCharacter> characters = EnumSet.noneOf(RobotCharacter.class);
  private final double[] touchedSince;
  private final RandomStream secondStroke;
  private double slippedAt = Double.NEGATIVE_INFINITY;
  private int heldSteps;
  private double heldVx;
  private double heldVy;
  private SimulatedRobot holder;
  private double holdAside;
  private String purpose = "kick";
  private double carriedUntil = Double.NEGATIVE_INFINITY;
  private double carryX;
  private double carryY;

  /**
   * A world with the ball at rest at the centre.
   *
   * @param field the field
   * @param physics laws of the ball
   * @param behaviour how kicks differ from commands
   * @param robots the robots, yellow first, by number
   * @param seed of the simulation
   */
  public SimulatedWorld(
      FieldSize field,
      BallPhysics physics,
      KickBehaviour behaviour,
      List<SimulatedRobot> robots,
      long seed) {
    this.field = field;
    this.robots = List.copyOf(robots);
    integrator = new BallIntegrator(physics);
    ballRadius = physics.ball().radius();
    kicker = new Kicker(behaviour, ballRadius, seed);
    secondStroke = RandomStream.of(seed, "second stroke");
    readyToKick = new double[this.robots.size()];
    touchedSince = new double[this.robots.size()];
    Arrays.fill(touchedSince, Double.NaN);
    trace =
        new BallTrace() {
          @Override
          public void node(double at, BallBody body) {
            history.node(at, body);
            kicks.node(at, body);
          }

          @Override
          public void event(BallEvent event) {
            kicks.event(event);
          }
        };
    history.node(0, ball);
    robotHistory.add(0, views());
  }

  /** Moves everything by one tick. */
  public void tick() {
    for (int i = 1; i <= SUBSTEPS; i++) {
      // Computed from the tick's number, so that rounding errors do not add up.
      double next = (ticks * SUBSTEPS + i) * (TICK / SUBSTEPS);
      for (SimulatedRobot robot : robots) {
        robot.move(next - time);
      }
      moveBall(next);
      time = next;
      if (carriedUntil < time) {
        meetRobots();
        leaveField();
      }
    }
    ticks++;
    robotHistory.add(time, views());
    history.forgetBefore(time - 0.5);
  }

  private void moveBall(double next) {
    if (carriedUntil >= time) {
      history.hiddenNode(next, ball);
      if (carriedUntil < next) {
        ball.place(carryX, carryY);
        history.hiddenNode(next, ball);
        history.node(next, ball);
      }
    } else if (holder != null) {
      hold(next);
    } else {
      integrator.advance(ball, time, next, trace);
    }
  }

  private void hold(double next) {
    double ahead = SimulatedRobot.FRONT + ballRadius;
    double cos = Math.cos(holder.orientation());
    double sin = Math.sin(holder.orientation());
    double x = holder.x() + ahead * cos - holdAside * sin;
    double y = holder.y() + ahead * sin + holdAside * cos;
    double vx = (x - ball.x()) / (next - time);
    double vy = (y - ball.y()) / (next - time);
    // In the first step the ball is moved to its place at the dribbler.
    boolean slips = heldSteps++ > 0 && slips(vx, vy, next - time);
    heldVx = slips || heldSteps > 1 ? vx : holder.vx();
    heldVy = slips || heldSteps > 1 ? vy : holder.vy();
    ball.place(x, y);
    history.node(next, ball);
    if (slips) {
      slippedAt = next;
      letRoll(0.9 * vx, 0.9 * vy, next);
    } else if (!holder.command().dribbler() && !holder.command().kick().armed()) {
      boolean rollsOff = characters.contains(RobotCharacter.SLIPPING_DRIBBLER);
      double off = rollsOff ? RobotCharacter.ROLLS_OFF : 0;
      double aside = off * holdAside / SimulatedRobot.MOUTH;
      SimulatedRobot from = holder;
      release();
      if (rollsOff) {
        letRoll(from.vx() + off * cos - aside * sin, from.vy() + off * sin + aside * cos, next);
      }
    }
  }

  /** Whether friction is too little for what the holder does. */
  private boolean slips(double vx, double vy, double span) {
    if (!characters.contains(RobotCharacter.SLIPPING_DRIBBLER)) {
      return false;
    }
    double cos = Math.cos(holder.orientation());
    double sin = Math.sin(holder.orientation());
    double ax = (vx - heldVx) / span;
    double ay = (vy - heldVy) / span;
    double pull = Math.max(0, -(ax * cos + ay * sin));
    double side = -ax * sin + ay * cos;
    double pulled = Math.max(0, -(vx * cos + vy * sin));
    return Math.hypot(pull, side) > RobotCharacter.HELD_ACCELERATION
        || Math.hypot(pulled, vx * sin - vy * cos) > RobotCharacter.HELD_SPEED;
  }

  /** The ball rolls on its own from now on. */
  private void letRoll(double vx, double vy, double at) {
    if (holder != null) {
      release();
    }
    ball.launch(vx, vy, 0, -vy / ballRadius, vx / ballRadius, 0);
    history.node(at, ball);
  }

  private void meetRobots() {
    for (int i = 0; i < robots.size(); i++) {
      SimulatedRobot robot = robots.get(i);
      if (Math.abs(robot.x() - ball.x()) > 0.15 || Math.abs(robot.y() - ball.y()) > 0.15) {
        continue;
      }
      Contact contact = Contact.of(robot, ball, ballRadius);
      Kick order = robot.command().kick();
      boolean reachable = contact.inMouth() && ball.z() < KICKER_HEIGHT;
      if (order.armed() && time >= readyToKick[i] && fires(i, contact)) {
        readyToKick[i] = time + RECHARGE;
        kick(robot, order);
      } else if (robot != holder && contact.touches()) {
        if (robot.command().dribbler() && reachable && time - slippedAt > RobotCharacter.LOST_FOR) {
          stop(robot);
        } else {
          deflect(robot, contact);
        }
      }
    }
  }

  /** Whether an armed kicker fires now. */
  private boolean fires(int robot, Contact contact) {
    boolean low = ball.z() < KICKER_HEIGHT;
    if (!characters.contains(RobotCharacter.LATE_KICKER)) {
      return contact.inMouth() && low;
    }
    boolean near = contact.atMouth() && contact.penetration() > -RobotCharacter.KICKER_REACH && low;
    if (!near) {
      touchedSince[robot] = Double.NaN;
    } else if (Double.isNaN(touchedSince[robot]) && contact.inMouth()) {
      touchedSince[robot] = time;
    }
    boolean due = time - touchedSince[robot] >= RobotCharacter.DEAD_TIME;
    if (due) {
      touchedSince[robot] = Double.NaN;
    }
    return due;
  }

  private void release() {
    holder = null;
    kicks.endHold(time);
  }

  private void kick(SimulatedRobot robot, Kick order) {
    release();
    KickCommand command =
        new KickCommand(
            order.speed(), Math.IEEEremainder(robot.orientation(), 2 * Math.PI), order.elevation());
    kicker.kick(robot, command, ball);
    if (characters.contains(RobotCharacter.UNEVEN_KICKER) && secondStroke.happens(0.5)) {
      double left = RobotCharacter.STRUCK_TWICE;
      ball.launch(
          left * ball.vx(),
          left * ball.vy(),
          left * ball.vz(),
          left * ball.spinX(),
          left * ball.spinY(),
          left * ball.spinZ());
    }
    if (characters.contains(RobotCharacter.LATE_KICKER)) {
      ball.launch(
          ball.vx() + robot.vx(),
          ball.vy() + robot.vy(),
          ball.vz(),
          ball.spinX(),
          ball.spinY(),
          ball.spinZ());
    }
    history.node(time, ball);
    kicks.begin(order.chip() ? KickKind.CHIP : KickKind.FLAT, purpose, time, ball, robot, command);
  }

  private void stop(SimulatedRobot robot) {
    kicks.end(time, EndReason.TOUCHED_ROBOT, Optional.of(robot.id()));
    kicks.beginHold(time, robot.id());
    holder = robot;
    heldSteps = 0;
    holdAside = robot.aside(ball.x(), ball.y());
    ball.place(ball.x(), ball.y());
    history.node(time, ball);
  }

  private void deflect(SimulatedRobot robot, Contact contact) {
    double relativeX = ball.vx() - robot.vx();
    double relativeY = ball.vy() - robot.vy();
    double approach = relativeX * contact.normalX() + relativeY * contact.normalY();
    if (approach >= 0) {
      return;
    }
    // Plastic against foam or plate; chosen, robots differ.
    double restitution = contact.atMouth() ? 0.25 : 0.4;
    double push = -(1 + restitution) * approach;
    double tangential = 0.75;
    double normalSpeed = approach + push;
    double alongX = relativeX - approach * contact.normalX();
    double alongY = relativeY - approach * contact.normalY();
    ball.launch(
        robot.vx() + normalSpeed * contact.normalX() + tangential * alongX,
        robot.vy() + normalSpeed * contact.normalY() + tangential * alongY,
        ball.z() > 0 ? ball.vz() : 0,
        0.5 * ball.spinX(),
        0.5 * ball.spinY(),
        0.5 * ball.spinZ());
    history.node(time, ball);
    // Contacts outside the field do not count as kicks.
    if (isInside()) {
      kicks.deflect(time, ball, robot);
    }
  }

  private boolean isInside() {
    return Math.abs(ball.x()) < field.length() / 2 + OUT
        && Math.abs(ball.y()) < field.width() / 2 + OUT;
  }

  private void leaveField() {
    double beyondX = Math.abs(ball.x()) - field.length() / 2;
    double beyondY = Math.abs(ball.y()) - field.width() / 2;
    if (beyondX < 0 && beyondY < 0) {
      return;
    }
    boolean inGoal = Math.abs(ball.y()) < field.goalWidth() / 2 && ball.z() < 0.16;
    if (beyondX > ballRadius && inGoal) {
      kicks.end(time, EndReason.GOAL, Optional.empty());
      wall(beyondX - field.goalDepth(), 1, 0);
    } else if (beyondX > OUT || beyondY > OUT) {
      kicks.end(time, EndReason.LEFT_FIELD, Optional.empty());
      wall(beyondX - field.boundary() - 0.1, 1, 0);
      wall(beyondY - field.boundary() - 0.1, 0, 1);
    }
  }

  /** Boards around the field take most of the ball's speed. */
  private void wall(double beyond, int alongX, int alongY) {
    double outward = alongX * ball.vx() * Math.signum(ball.x());
    outward += alongY * ball.vy() * Math.signum(ball.y());
    if (beyond > 0 && outward > 0) {
      double x = alongX == 1 ? -0.3 : 0.7;
      double y = alongY == 1 ? -0.3 : 0.7;
      ball.launch(x * ball.vx(), y * ball.vy(), ball.z() > 0 ? ball.vz() : 0, 0, 0, 0);
      history.node(time, ball);
    }
  }

  /**
   * Somebody takes the ball and lays it down elsewhere; cameras do not see it meanwhile.
   *
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   * @param duration until the ball lies there, s
   */
  public void carryBall(double x, double y, double duration) {
    kicks.end(time, EndReason.PLACED, Optional.empty());
    release();
    ball.place(ball.x(), ball.y());
    history.node(time, ball);
    carriedUntil = time + duration;
    carryX = x;
    carryY = y;
  }

  /**
   * Lays the ball down at once.
   *
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   */
  public void placeBall(double x, double y) {
    kicks.end(time, EndReason.PLACED, Optional.empty());
    release();
    ball.place(x, y);
    history.node(time, ball);
  }

  /**
   * What the robots are like from now on.
   *
   * @param like their characters; empty = ideal
   */
  public void robotsLike(Set<RobotCharacter> like) {
    characters.clear();
    characters.addAll(like);
  }

  /**
   * What the coming kicks are for, for the truth.
   *
   * @param name for example {@code pass}
   */
  public void purpose(String name) {
    purpose = name;
  }

  /** The recording is over: closes the open kick. */
  public void finish() {
    kicks.end(time, EndReason.RECORDING_ENDED, Optional.empty());
    kicks.endHold(time);
  }

  /**
   * Whether the ball is being carried.
   *
   * @return true while nobody can see it
   */
  public boolean ballCarried() {
    return carriedUntil >= time;
  }

  /**
   * Who holds the ball with its dribbler.
   *
   * @return the robot, if one does
   */
  public Optional<SimulatedRobot> holder() {
    return Optional.ofNullable(holder);
  }

  /**
   * The ball.
   *
   * @return its state now; read it, do not change it
   */
  public BallBody ball() {
    return ball;
  }

  /**
   * The robots.
   *
   * @return yellow first, by number
   */
  public List<SimulatedRobot> robots() {
    return robots;
  }

  /**
   * The kicks so far.
   *
   * @return the log
   */
  public KickLog kicks() {
    return kicks;
  }

  /**
   * Now.
   *
   * @return session time, s
   */
  public double time() {
    return time;
  }

  /**
   * The field.
   *
   * @return its size
   */
  public FieldSize field() {
    return field;
  }

  @Override
  public boolean ballAt(double at, double[] xyz) {
    return history.positionAt(at, xyz);
  }

  @Override
  public List<RobotView> robotsAt(double at) {
    return robotHistory.at(at);
  }

  private List<RobotView> views() {
    List<RobotView> views = new ArrayList<>(robots.size());
    for (SimulatedRobot robot : robots) {
      views.add(robot.view());
    }
    return views;
  }
}
