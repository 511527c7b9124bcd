package fieldcal.movement;

import fieldcal.vision.RobotId;

/** All that is counted of one team's robots: manoeuvres, speeds, two-dimensional histograms, and the league's histograms. Two of them merge exactly, and memory is bounded. Mutable, for one thread. */
public final class TeamStatistics {
  /** Turns that change the rate of turning by less do not count, rad/s: a robot that faces a ball which passes it at 2 m/s, 1 m away, turns so fast without any hurry. */
  public static final double LEAST_TURN = 2;

  /** A manoeuvre counts as accelerating or braking if at least this part of its change of velocity changes the speed; otherwise it is a curve. */
  private static final double SHARE_OF_SPEED = 0.5;

  /** Number of robots that are kept apart: those of the rules. */
  private static final int ROBOTS = 16;

  private final ManoeuvreTables accelerating = new ManoeuvreTables(ManoeuvreTable.Scale.DRIVING);
  private final ManoeuvreTables braking = new ManoeuvreTables(ManoeuvreTable.Scale.DRIVING);
  private final SpeedTable speeds = new SpeedTable(SpeedTable.Scale.DRIVING);
  private final ManoeuvreTables turningFaster = new ManoeuvreTables(ManoeuvreTable.Scale.TURNING);
  private final ManoeuvreTables turningSlower = new ManoeuvreTables(ManoeuvreTable.Scale.TURNING);
  private final SpeedTable turnSpeeds = new SpeedTable(SpeedTable.Scale.TURNING);
  private int robots;
  private final Grid ownFrame = Grid.centred(0.25, 80);
  private final Grid againstSpeed = new Grid(0, 0.1, 60, -10, 0.25, 80);
  private final LeagueStatistics league = new LeagueStatistics();
  private long manoeuvres;

  /** Nothing counted yet. */
  TeamStatistics() {}

  void add(Manoeuvre m) {
    manoeuvres++;
    double a = m.acceleration();
    double first = m.speedAfter(0);
    double last = m.speedAfter(m.duration());
    double change = a * m.duration();
    double share = (last - first) / change;
    double direction = Math.atan2(m.ay(), m.ax()) - m.orientation();
    int robot = number(m.robot());
    robots |= 1 << robot;
    if (share > SHARE_OF_SPEED) {
      accelerating.of(robot).add(a, m.accelerationError(), m.speed(), direction);
    } else if (share < -SHARE_OF_SPEED) {
      braking.of(robot).add(a, m.accelerationError(), m.speed(), direction);
    }
    // Where corners are round, the speeds of sharp corners are never reached.
    double inside = Math.min(m.corner(), 0.5 * m.duration());
    double top = Math.max(m.speedAfter(inside), m.speedAfter(m.duration() - inside));
    speeds.add(
        robot,
        m.duration(),
        a,
        m.accelerationError(),
        m.speed(),
        m.velocityError(),
        top,
        m.overshoot());
    draw(m, a, direction);
  }

  private static int number(RobotId robot) {
    return Math.min(robot.number(), ROBOTS);
  }

  void add(Turn t) {
    int robot = number(t.robot());
    double a = Math.abs(t.angularAcceleration());
    double speed = t.rateAfter(0.5 * t.duration());
    // Where it reverses its sense of rotation it does both, one after the other, with the same
    // motors.
    if (t.growth() > LEAST_TURN) {
      turningFaster.of(robot).add(a, t.accelerationError(), speed, Double.NaN);
    } else if (t.growth() < -LEAST_TURN) {
      turningSlower.of(robot).add(a, t.accelerationError(), speed, Double.NaN);
    }
    double inside = Math.min(t.corner(), 0.5 * t.duration());
    double top = Math.max(t.rateAfter(inside), t.rateAfter(t.duration() - inside));
    turnSpeeds.add(
        robot,
        t.duration(),
        a,
        t.accelerationError(),
        speed,
        t.velocityError(),
        top,
        t.overshoot());
  }

  private void draw(Manoeuvre m, double a, double direction) {
    if (a > ManoeuvreTable.Scale.DRIVING.weakest() && m.accelerationError() < 0.5) {
      ownFrame.add(a * Math.cos(direction), a * Math.sin(direction), m.detections());
    }
    if (m.accelerationError() < 0.5) {
      int steps = Math.min(50, m.detections());
      for (int i = 0; i < steps; i++) {
        double after = m.duration() * (i + 0.5) / steps;
        againstSpeed.add(m.speedAfter(after), m.speedGrowth(after), 1);
      }
    }
  }

  void merge(TeamStatistics other) {
    accelerating.merge(other.accelerating);
    braking.merge(other.braking);
    speeds.merge(other.speeds);
    turningFaster.merge(other.turningFaster);
    turningSlower.merge(other.turningSlower);
    turnSpeeds.merge(other.turnSpeeds);
    robots |= other.robots;
    ownFrame.merge(other.ownFrame);
    againstSpeed.merge(other.againstSpeed);
    league.merge(other.league);
    manoeuvres += other.manoeuvres;
  }

  void clear() {
    accelerating.clear();
    braking.clear();
    speeds.clear();
    turningFaster.clear();
    turningSlower.clear();
    turnSpeeds.clear();
    robots = 0;
    ownFrame.clear();
    againstSpeed.clear();
    league.clear();
    manoeuvres = 0;
  }

  ManoeuvreTables acceleratingManoeuvres() {
    return accelerating;
  }

  ManoeuvreTables brakingManoeuvres() {
    return braking;
  }

  SpeedTable speeds() {
    return speeds;
  }

  /** Turns that became faster by at least {@link #LEAST_TURN}. */
  ManoeuvreTables turningFaster() {
    return turningFaster;
  }

  /** Turns that became slower by at least {@link #LEAST_TURN}. */
  ManoeuvreTables turningSlower() {
    return turningSlower;
  }

  SpeedTable turnSpeeds() {
    return turnSpeeds;
  }

  /** How many robots were seen to manoeuvre. */
  int robots() {
    return Integer.bitCount(robots);
  }

  /** Reports each robot that was seen to manoeuvre as a cell. */
  void robotCells(MovementCells.Sink sink) {
    for (int robot = 0; robot <= ROBOTS; robot++) {
      if ((robots >> robot & 1) == 1) {
        sink.cell(robot, robot, Double.NaN, 1);
      }
    }
  }

  /** Adds what {@link #robotCells} reported; false when there is no such robot. */
  boolean addRobot(int robot) {
    boolean known = robot >= 0 && robot <= ROBOTS;
    if (known) {
      robots |= 1 << robot;
    }
    return known;
  }

  boolean addManoeuvres(long count) {
    manoeuvres += Math.max(0, count);
    return count >= 0;
  }

  /**
   * Pieces of constant acceleration that were fitted, whatever they were used for.
   *
   * @return their number
   */
  public long manoeuvres() {
    return manoeuvres;
  }

  /**
   * Accelerations in the robot's own frame: x along its front, y to its left, m/s²; counted in detections.
   *
   * @return the live histogram
   */
  public Grid ownFrame() {
    return ownFrame;
  }

  /**
   * Change of speed (y, m/s², negative when braking) against speed (x, m/s).
   *
   * @return the live histogram
   */
  public Grid againstSpeed() {
    return againstSpeed;
  }

  /**
   * The counts of the league's estimator.
   *
   * @return its three histograms
   */
  public LeagueStatistics league() {
    return league;
  }
}
