package fieldcal.movement;

import java.util.Map;
import java.util.TreeMap;

/** How fast the robots of a team were: in manoeuvres at constant speed, and at most. Two of them merge exactly. Mutable, for one thread. */
final class SpeedTable {
  /** Constant speed changes by a small part, … */
  private static final double CRUISING_CHANGE = 0.05;

  /** … for so long, s. */
  private static final double CRUISING_TIME = 0.15;

  /** A speed that lies so many standard errors below the measured one was certainly reached, even if the measured one is the largest of a thousand. */
  private static final double SURE = 3;

  private final Scale scale;
  private final Histogram tops;
  private final Histogram sure;
  private final Map<Integer, Histogram> cruising = new TreeMap<>();

  /**
   * What is usual for a kind of speed.
   *
   * @param bin width of a bin of the histograms
   * @param bins number of bins
   * @param uncertain speeds with a larger standard error do not count
   * @param cruising largest acceleration at constant speed
   * @param slowest least speed that counts; slower robots creep
   */
  record Scale(double bin, int bins, double uncertain, double cruising, double slowest) {
    /** Of driving, m/s and m/s². */
    static final Scale DRIVING = new Scale(0.01, 800, 0.04, 0.4, 0.3);

    /** Of turning, rad/s and rad/s²: what 0.15 s of two cameras with 10 mrad of noise resolve. */
    static final Scale TURNING = new Scale(0.05, 1000, 0.4, 5, 2);
  }

  SpeedTable(Scale scale) {
    this.scale = scale;
    tops = histogram();
    sure = histogram();
  }

  private Histogram histogram() {
    return new Histogram(scale.bin(), scale.bins());
  }

  /**
   * Counts a manoeuvre.
   *
   * @param robot number
   * @param duration s
   * @param acceleration size of it
   * @param accelerationError its standard error
   * @param speed in the middle
   * @param speedError standard error of the speed in the middle
   * @param top the higher speed of both ends
   * @param overshoot by how much that may exceed the robot's true speed, in addition to its error
   */
  void add(
      int robot,
      double duration,
      double acceleration,
      double accelerationError,
      double speed,
      double speedError,
      double top,
      double overshoot) {
    double endError = Math.hypot(speedError, 0.5 * duration * accelerationError);
    if (endError < scale.uncertain()) {
      tops.add(top);
      sure.add(Math.max(0, top - overshoot - SURE * endError));
    }
    boolean cruises =
        acceleration < scale.cruising()
            && acceleration * duration < CRUISING_CHANGE * speed
            && duration > CRUISING_TIME
            && speedError < scale.uncertain();
    if (cruises) {
      cruisingOf(robot).add(speed);
    }
  }

  void merge(SpeedTable other) {
    tops.merge(other.tops);
    sure.merge(other.sure);
    other.cruising.forEach((robot, speeds) -> cruisingOf(robot).merge(speeds));
  }

  void clear() {
    tops.clear();
    sure.clear();
    cruising.clear();
  }

  Scale scale() {
    return scale;
  }

  /** The higher speed of both ends of each manoeuvre whose speeds are well known. */
  Histogram tops() {
    return tops;
  }

  /** A speed that the robot certainly had, of each of the same manoeuvres. */
  Histogram sure() {
    return sure;
  }

  /** The speeds of one robot at constant speed; made when it is not there. */
  Histogram cruisingOf(int robot) {
    return cruising.computeIfAbsent(robot, key -> histogram());
  }

  /** Speeds of manoeuvres at constant speed, by the robot's number. */
  Map<Integer, Histogram> cruising() {
    return cruising;
  }

  /** The same of all robots. */
  Histogram cruisingOfAll() {
    Histogram all = histogram();
    cruising.values().forEach(all::merge);
    return all;
  }
}
