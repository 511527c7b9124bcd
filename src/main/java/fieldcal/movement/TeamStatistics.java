package fieldcal.movement;

import java.util.Map;
import java.util.TreeMap;

/** All that is counted of one team's robots: manoeuvres, speeds, pictures, and the league's histograms. Exactly mergeable; bounded. Mutable, for one thread. */
public final class TeamStatistics {
  private static final double SPEED_BIN = 0.01;
  private static final int SPEED_BINS = 800;

  /** Driving at constant speed: hardly any acceleration, m/s² … */
  private static final double CRUISING = 0.4;

  /** … that changes the speed by a small part, … */
  private static final double CRUISING_CHANGE = 0.05;

  /** … for so long, s. */
  private static final double CRUISING_TIME = 0.15;

  /** Speeds that are less certain do not count, m/s. */
  private static final double UNCERTAIN = 0.04;

  /** So many standard errors below what was measured, a speed was certainly reached, even by the luckiest of a thousand manoeuvres. */
  private static final double SURE = 3;

  /** Which part of a change of velocity must go into the speed, for a manoeuvre to be accelerating or braking and not a turn. */
  private static final double MOSTLY = 0.5;

  /** Numbers of robots that are kept apart: those of the rules. */
  private static final int ROBOTS = 16;

  private final ManoeuvreTable accelerating = new ManoeuvreTable();
  private final ManoeuvreTable braking = new ManoeuvreTable();
  private final Histogram topSpeeds = new Histogram(SPEED_BIN, SPEED_BINS);
  private final Histogram sureSpeeds = new Histogram(SPEED_BIN, SPEED_BINS);
  private int robots;
  private final Map<Integer, Histogram> cruising = new TreeMap<>();
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
    double sine = Math.sin(direction);
    if (share > MOSTLY) {
      accelerating.add(a, m.accelerationError(), m.speed(), sine * sine);
    } else if (share < -MOSTLY) {
      braking.add(a, m.accelerationError(), m.speed(), sine * sine);
    }
    double endError = Math.hypot(m.velocityError(), 0.5 * m.duration() * m.accelerationError());
    robots |= 1 << Math.min(m.robot().number(), ROBOTS);
    if (endError < UNCERTAIN) {
      // Where corners are round, the speeds of the sharp ones are never reached.
      double inside = Math.min(m.corner(), 0.5 * m.duration());
      double top = Math.max(m.speedAfter(inside), m.speedAfter(m.duration() - inside));
      topSpeeds.add(top);
      sureSpeeds.add(Math.max(0, top - SURE * endError));
    }
    boolean cruises =
        a < CRUISING
            && change < CRUISING_CHANGE * m.speed()
            && m.duration() > CRUISING_TIME
            && m.velocityError() < UNCERTAIN;
    if (cruises) {
      cruising
          .computeIfAbsent(Math.min(m.robot().number(), ROBOTS), robot -> speeds())
          .add(m.speed());
    }
    draw(m, a, direction);
  }

  private static Histogram speeds() {
    return new Histogram(SPEED_BIN, SPEED_BINS);
  }

  private void draw(Manoeuvre m, double a, double direction) {
    if (a > ManoeuvreTable.WEAKEST && m.accelerationError() < 0.5) {
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
    topSpeeds.merge(other.topSpeeds);
    sureSpeeds.merge(other.sureSpeeds);
    robots |= other.robots;
    other.cruising.forEach(
        (robot, speeds) -> cruising.computeIfAbsent(robot, key -> speeds()).merge(speeds));
    ownFrame.merge(other.ownFrame);
    againstSpeed.merge(other.againstSpeed);
    league.merge(other.league);
    manoeuvres += other.manoeuvres;
  }

  void clear() {
    accelerating.clear();
    braking.clear();
    topSpeeds.clear();
    sureSpeeds.clear();
    robots = 0;
    cruising.clear();
    ownFrame.clear();
    againstSpeed.clear();
    league.clear();
    manoeuvres = 0;
  }

  ManoeuvreTable acceleratingManoeuvres() {
    return accelerating;
  }

  ManoeuvreTable brakingManoeuvres() {
    return braking;
  }

  /** The higher speed of both ends of each manoeuvre whose speeds are well known. */
  Histogram topSpeeds() {
    return topSpeeds;
  }

  /** Of the same manoeuvres, a speed that each certainly had. */
  Histogram sureSpeeds() {
    return sureSpeeds;
  }

  /** How many robots were seen to manoeuvre. */
  int robots() {
    return Integer.bitCount(robots);
  }

  /** Tells each robot that was seen to manoeuvre as a cell. */
  void robotCells(MovementCells.Sink sink) {
    for (int robot = 0; robot <= ROBOTS; robot++) {
      if ((robots >> robot & 1) == 1) {
        sink.cell(robot, robot, Double.NaN, 1);
      }
    }
  }

  /** Adds what {@link #robotCells} told; false when there is no such robot. */
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

  /** Made when it is not there. */
  Histogram cruisingOf(int robot) {
    return cruising.computeIfAbsent(robot, key -> speeds());
  }

  /** Speeds of manoeuvres at constant velocity, by the robot's number. */
  Map<Integer, Histogram> cruising() {
    return cruising;
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
   * @return the picture
   */
  public Grid ownFrame() {
    return ownFrame;
  }

  /**
   * Change of speed (y, m/s², negative when braking) against speed (x, m/s).
   *
   * @return the picture
   */
  public Grid againstSpeed() {
    return againstSpeed;
  }

  /**
   * What the league's estimator counts.
   *
   * @return its three histograms
   */
  public LeagueStatistics league() {
    return league;
  }
}
