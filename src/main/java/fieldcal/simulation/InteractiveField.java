package fieldcal.simulation;

import fieldcal.simulation.robot.RobotCharacter;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.scenario.Scenario;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/**
 * A simulated field whose robots are commanded from outside, tick by tick, while its cameras look on. Frames arrive with the delay of a real vision, commands with that of a radio. The same settings,
 * troubles and commands give the same frames. Not thread-safe.
 */
public final class InteractiveField {
  /** Delay from the command to the robot, s: a radio at 60 Hz and half a period of waiting. */
  private static final double RADIO = 0.02;

  /** Where robots are put that are not on the field, m. */
  private static final double AWAY = 500;

  private static final double THIRD_SPEED = 1;

  /** From a robot's centre to that of a ball that touches it, m. */
  private static final double STUCK_BEHIND = 0.112;

  private final SimulationSettings settings;
  private final Simulation simulation;
  private final SimulatedWorld world;
  private final RandomStream random;
  private final List<RobotId> players;
  private final List<FieldTrouble> troubles;
  private final Set<FieldTrouble> begun = new HashSet<>();
  private final Map<RobotId, double[]> absent = new HashMap<>();
  private final Deque<Sent> onTheWay = new ArrayDeque<>();
  private final Map<RobotId, RobotCommand> wanted = new HashMap<>();
  private final Set<RobotCharacter> characters = EnumSet.noneOf(RobotCharacter.class);
  private double[] thirdTarget;
  private FieldTrouble stuck;

  private record Sent(double arrives, RobotId robot, RobotCommand command) {}

  private final class Commanded implements Scenario {
    private final List<SimulatedRobot> robots;

    Commanded(List<SimulatedRobot> robots) {
      this.robots = robots;
    }

    @Override
    public List<SimulatedRobot> robots() {
      return robots;
    }

    @Override
    public void tick(SimulatedWorld now) {
      beforeTick();
    }

    @Override
    public boolean finished(SimulatedWorld now) {
      return false;
    }

    @Override
    public double progress(SimulatedWorld now) {
      return 0;
    }
  }

  private InteractiveField(
      SimulationSettings settings,
      List<SimulatedRobot> robots,
      List<FieldTrouble> troubles,
      double later) {
    this.settings = settings;
    this.troubles = List.copyOf(troubles);
    players = robots.stream().limit(2).map(SimulatedRobot::id).toList();
    random = RandomStream.of(settings.seed(), "interactive field");
    List<SimulatedRobot> sorted = new ArrayList<>(robots);
    sorted.sort(Comparator.comparing(SimulatedRobot::id));
    simulation = Simulation.interactive(settings, new Commanded(List.copyOf(sorted)), later);
    world = simulation.world();
    world.purpose("calibration");
    world.placeBall(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
  }

  /**
   * A field with two robots to be commanded, and two bystanders: blue 13 and yellow 14.
   *
   * @param settings field, physics, cameras, kickers, effects, seed; its scenario does not count
   * @param first one robot; neither blue 13 nor yellow 14
   * @param second the other
   * @param troubles what goes wrong
   * @return the field at time 0
   * @throws IllegalArgumentException when an effect leaves the range of the physics, or two robots have the same id
   */
  public static InteractiveField of(
      SimulationSettings settings, RobotId first, RobotId second, List<FieldTrouble> troubles) {
    return later(settings, first, second, troubles, 0);
  }

  /**
   * The same, as a second session on the same field: its clock begins later, so that recordings of both do not overlap.
   *
   * @param settings as in {@link #of}
   * @param first one robot
   * @param second the other
   * @param troubles what goes wrong
   * @param later by how much the session begins later, s
   * @return the field at time 0
   * @throws IllegalArgumentException as {@link #of}
   */
  public static InteractiveField later(
      SimulationSettings settings,
      RobotId first,
      RobotId second,
      List<FieldTrouble> troubles,
      double later) {
    FieldSize field = settings.field();
    List<SimulatedRobot> robots = new ArrayList<>();
    double x = field.length();
    double y = field.width();
    robots.add(robot(settings, first, -0.3 * x, -0.2 * y, 0));
    robots.add(robot(settings, second, 0.3 * x, 0.2 * y, Math.PI));
    robots.add(robot(settings, new RobotId(Team.BLUE, 13), -0.3 * x, 0.04 * y, 0.4));
    robots.add(robot(settings, new RobotId(Team.YELLOW, 14), 0.3 * x, -0.04 * y, 2));
    Set<RobotId> ids = new HashSet<>();
    for (SimulatedRobot robot : robots) {
      if (!ids.add(robot.id())) {
        throw new IllegalArgumentException(
            robot.id() + " would be there twice: name two other robots");
      }
    }
    return new InteractiveField(settings, robots, troubles, later);
  }

  private static SimulatedRobot robot(
      SimulationSettings settings, RobotId id, double x, double y, double orientation) {
    RobotLimits limits =
        Effects.limits(
            id.team() == Team.YELLOW ? settings.scenario().yellow() : settings.scenario().blue(),
            id.team(),
            settings.effects());
    return new SimulatedRobot(id, limits, 0.145, x, y, orientation);
  }

  /**
   * Commands a robot until the next command; it receives the command after the radio's delay.
   *
   * @param robot who; unknown ones are ignored
   * @param command what
   */
  public void command(RobotId robot, RobotCommand command) {
    onTheWay.add(new Sent(world.time() + RADIO, robot, command));
  }

  /**
   * What the robots are like from now on, in addition to the troubles.
   *
   * @param like their characters
   * @return this field
   */
  public InteractiveField robotsLike(Set<RobotCharacter> like) {
    characters.clear();
    characters.addAll(like);
    return this;
  }

  /**
   * Moves everything by {@link SimulatedWorld#TICK}.
   *
   * @param sink gets the packets that arrive meanwhile
   */
  public void step(Consumer<SimulatedPacket> sink) {
    boolean blind = is(FieldTrouble.Kind.NO_VISION);
    simulation.tick(
        packet -> {
          if (!blind) {
            sink.accept(packet);
          }
        });
  }

  private boolean is(FieldTrouble.Kind kind) {
    return troubles.stream().anyMatch(t -> t.kind() == kind && t.covers(world.time()));
  }

  private void beforeTick() {
    Set<RobotCharacter> now = charactersNow();
    double later = now.contains(RobotCharacter.SLUGGISH) ? RobotCharacter.HEARS_LATER : 0;
    while (!onTheWay.isEmpty() && onTheWay.peek().arrives() + later <= world.time()) {
      Sent sent = onTheWay.poll();
      wanted.put(sent.robot(), sent.command());
    }
    for (FieldTrouble trouble : troubles) {
      if (world.time() >= trouble.time() && begun.add(trouble)) {
        begin(trouble);
      }
    }
    world.robotsLike(now);
    for (SimulatedRobot robot : world.robots()) {
      RobotCommand command = obeyed(robot);
      boolean present = !absent.containsKey(robot.id());
      if (now.contains(RobotCharacter.DRIFTING) && present) {
        command = drifting(robot.id(), command);
      }
      if (now.contains(RobotCharacter.SLUGGISH) && present) {
        command = sluggish(robot, command);
      }
      robot.command(command);
    }
    bringBack();
    driveThird();
    stick();
  }

  private void stick() {
    if (stuck == null || !stuck.covers(world.time())) {
      return;
    }
    RobotId robot = players.get(stuck.robot() % 2);
    if (!absent.containsKey(robot)) {
      SimulatedRobot at = find(robot).orElseThrow();
      world.placeBall(
          at.x() - STUCK_BEHIND * Math.cos(at.orientation()),
          at.y() - STUCK_BEHIND * Math.sin(at.orientation()));
    }
  }

  private Set<RobotCharacter> charactersNow() {
    Set<RobotCharacter> now = EnumSet.noneOf(RobotCharacter.class);
    now.addAll(characters);
    if (is(FieldTrouble.Kind.SLIPPING_DRIBBLER)) {
      now.add(RobotCharacter.SLIPPING_DRIBBLER);
    }
    if (is(FieldTrouble.Kind.LATE_KICKER)) {
      now.add(RobotCharacter.LATE_KICKER);
    }
    if (is(FieldTrouble.Kind.DRIFTING)) {
      now.add(RobotCharacter.DRIFTING);
    }
    return now;
  }

  /** The two robots drive beside their way to opposite sides. */
  private RobotCommand drifting(RobotId robot, RobotCommand command) {
    int player = players.indexOf(robot);
    if (player < 0 || !(command.motion() instanceof RobotCommand.Velocity v)) {
      return command;
    }
    double beside = player == 0 ? RobotCharacter.BESIDE : -RobotCharacter.BESIDE;
    double cos = RobotCharacter.SLOWER * Math.cos(beside);
    double sin = RobotCharacter.SLOWER * Math.sin(beside);
    RobotCommand.Velocity driven =
        new RobotCommand.Velocity(
            v.vx() * cos - v.vy() * sin + RobotCharacter.CREEP,
            v.vx() * sin + v.vy() * cos,
            v.angular());
    return new RobotCommand(driven, command.kick(), command.dribbler());
  }

  /** A velocity between that of the robot and the commanded one. */
  private RobotCommand sluggish(SimulatedRobot robot, RobotCommand command) {
    if (!players.contains(robot.id()) || !(command.motion() instanceof RobotCommand.Velocity v)) {
      return command;
    }
    double dx = v.vx() - robot.vx();
    double dy = v.vy() - robot.vy();
    double change = Math.hypot(dx, dy) / RobotCharacter.FOLLOWS;
    double share = SimulatedWorld.TICK / RobotCharacter.FOLLOWS;
    share *= change > RobotCharacter.WEAK ? RobotCharacter.WEAK / change : 1;
    RobotCommand.Velocity driven =
        new RobotCommand.Velocity(robot.vx() + share * dx, robot.vy() + share * dy, v.angular());
    return new RobotCommand(driven, command.kick(), command.dribbler());
  }

  private RobotCommand obeyed(SimulatedRobot robot) {
    RobotCommand command = wanted.getOrDefault(robot.id(), RobotCommand.HALT);
    if (absent.containsKey(robot.id()) || troubled(FieldTrouble.Kind.ROBOT_STUCK, robot.id())) {
      return RobotCommand.HALT;
    }
    if (command.kick().armed() && is(FieldTrouble.Kind.MISSED_KICK)) {
      return new RobotCommand(command.motion(), Kick.NONE, command.dribbler());
    }
    if (command.kick().armed() && is(FieldTrouble.Kind.WEAK_KICK)) {
      Kick weak = new Kick(0.25 * command.kick().speed(), command.kick().elevation());
      return new RobotCommand(command.motion(), weak, command.dribbler());
    }
    return command;
  }

  private boolean troubled(FieldTrouble.Kind kind, RobotId robot) {
    return troubles.stream()
        .anyMatch(
            t ->
                t.kind() == kind
                    && t.covers(world.time())
                    && players.get(t.robot() % 2).equals(robot));
  }

  private void begin(FieldTrouble trouble) {
    double x = 0.5 * settings.field().length();
    double y = 0.5 * settings.field().width();
    double sideX = random.happens(0.5) ? 1 : -1;
    double sideY = random.happens(0.5) ? 1 : -1;
    double share = random.uniform(0, 1);
    RobotId concerned = players.get(trouble.robot() % 2);
    switch (trouble.kind()) {
      case BALL_OUTSIDE -> world.placeBall(sideX * x * share, sideY * (y + 0.05 + 0.3 * share));
      case BALL_IN_CORNER -> world.placeBall(sideX * (x - 0.05), sideY * (y - 0.02));
      case BALL_IN_GOAL -> world.placeBall(sideX * (x + 0.1), 0.3 * sideY * share);
      case BALL_HIDDEN -> world.carryBall(0.8 * x * sideX * share, 0.5 * y, trouble.duration());
      case BALL_AT_ROBOT ->
          find(concerned)
              .filter(r -> Math.abs(r.x()) < x && Math.abs(r.y()) < y)
              .ifPresent(r -> world.placeBall(r.x() - 0.13 * sideX, r.y() + 0.02 * sideY));
      case BALL_STUCK -> stuck = trouble;
      case ROBOT_GONE -> setPresent(concerned, false);
      case THIRD_ROBOT ->
          thirdTarget =
              new double[] {
                world.ball().x() + 0.35 * sideX, world.ball().y() + 0.35 * sideY * share
              };
      default -> {
        // Lasts for a while, and is checked where it matters.
      }
    }
  }

  private void bringBack() {
    for (RobotId player : players) {
      boolean gone = troubled(FieldTrouble.Kind.ROBOT_GONE, player);
      boolean taken = begun.stream().anyMatch(t -> t.kind() == FieldTrouble.Kind.ROBOT_GONE);
      if (taken && !gone && absent.containsKey(player)) {
        absent.computeIfPresent(
            player, (id, pose) -> PutDown.near(pose, world.robots(), settings.field()));
        setPresent(player, true);
      }
    }
  }

  /** A bystander with somewhere to go; it stops before it would hit anybody. */
  private void driveThird() {
    if (thirdTarget == null) {
      return;
    }
    SimulatedRobot third =
        world.robots().stream().filter(r -> !players.contains(r.id())).findFirst().orElseThrow();
    boolean there = is(FieldTrouble.Kind.THIRD_ROBOT);
    double x = there ? thirdTarget[0] : -0.3 * settings.field().length();
    double y = there ? thirdTarget[1] : 0.04 * settings.field().width();
    double distance = Math.hypot(x - third.x(), y - third.y());
    boolean blocked =
        world.robots().stream()
            .anyMatch(
                r -> {
                  double dx = r.x() - third.x();
                  double dy = r.y() - third.y();
                  boolean ahead = dx * (x - third.x()) + dy * (y - third.y()) > 0;
                  return r != third && ahead && Math.hypot(dx, dy) < 0.45;
                });
    third.command(
        blocked || distance < 0.02
            ? RobotCommand.HALT
            : RobotCommand.driveTo(x, y, third.orientation(), THIRD_SPEED));
  }

  /**
   * Takes a robot off the field, or puts it back where it was.
   *
   * @param robot who; unknown ones are ignored
   * @param present whether it is to be there
   */
  public void setPresent(RobotId robot, boolean present) {
    find(robot)
        .ifPresent(
            r -> {
              if (!present && !absent.containsKey(robot)) {
                absent.put(robot, new double[] {r.x(), r.y(), r.orientation()});
                r.place(AWAY + absent.size(), AWAY, 0);
              } else if (present && absent.containsKey(robot)) {
                double[] pose = absent.remove(robot);
                r.place(pose[0], pose[1], pose[2]);
              }
            });
  }

  /**
   * Puts a robot somewhere at rest; one that is off the field comes back there when it comes back.
   *
   * @param robot who; unknown ones are ignored
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   * @param orientation direction of its front, rad, 0 = along x, counter-clockwise
   */
  public void placeRobot(RobotId robot, double x, double y, double orientation) {
    if (absent.containsKey(robot)) {
      absent.put(robot, new double[] {x, y, orientation});
    } else {
      find(robot).ifPresent(r -> r.place(x, y, orientation));
    }
  }

  private Optional<SimulatedRobot> find(RobotId robot) {
    return world.robots().stream().filter(r -> r.id().equals(robot)).findFirst();
  }

  /**
   * Somebody lays the ball down; until then it is in the hand, where no camera sees it.
   *
   * @param x x in the field frame, m
   * @param y y in the field frame, m
   * @param seconds how long that takes, s
   */
  public void handBall(double x, double y, double seconds) {
    stuck = null;
    world.carryBall(x, y, seconds);
  }

  /**
   * Whether the referee says HALT.
   *
   * @return true while nobody may move
   */
  public boolean halted() {
    return is(FieldTrouble.Kind.HALT);
  }

  /**
   * Ball and robots as they are.
   *
   * @return the world; read it, do not change it
   */
  public SimulatedWorld world() {
    return world;
  }

  /**
   * The two robots to be commanded.
   *
   * @return in the order of creation
   */
  public List<RobotId> players() {
    return players;
  }

  /**
   * The geometry as published.
   *
   * @return field, cameras, ball models
   */
  public FieldGeometry geometry() {
    return simulation.geometry();
  }

  /**
   * The beginning of session time.
   *
   * @return session time zero
   */
  public Epoch epoch() {
    return simulation.epoch();
  }

  /**
   * The session is over.
   *
   * @param sink gets the packets that are still on their way
   * @return what really happened
   */
  public Truth finish(Consumer<SimulatedPacket> sink) {
    return simulation.finish(sink);
  }
}
