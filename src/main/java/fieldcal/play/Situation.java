package fieldcal.play;

import fieldcal.play.PathPlanner.Circle;
import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Kick;
import fieldcal.play.RobotOrder.Pose;
import fieldcal.play.RobotOrder.Velocity;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** One tick as the steps see it: what there is, and what they order. */
final class Situation {
  /** A frame that comes later, or a robot that follows later, is too late to play, s; real visions are 0.03 to 0.15 s late. */
  static final double TOO_LATE = 0.3;

  private static final String FOLLOWS_LATE =
      ": it follows its commands too late, because of vision, the radio or the robot itself";

  /** How long a robot may drive on without being seen, s. */
  static final double ROBOT_UNSEEN = 0.25;

  private final PlayPlan plan;
  private final BallMemory ball;
  private final Driver driver;
  private final Safety safety;
  private final List<Motion> motions;
  private final List<Following> following;
  private final PlayWorld world;
  private final double passed;
  private final double visionDelay;
  private final List<Robot> seen;
  private final Robot[] ours = new Robot[2];
  private final Velocity[] velocities = {Velocity.ZERO, Velocity.ZERO};
  private final Pose[] targets = new Pose[2];
  private final Kick[] kicks = {Kick.NONE, Kick.NONE};
  private final boolean[] dribblers = new boolean[2];
  private String waiting;
  private WaitingFor waitingFor = WaitingFor.NOTHING;
  private BallRequest request;

  Situation(
      PlayPlan plan,
      BallMemory ball,
      Driver driver,
      Safety safety,
      List<Motion> motions,
      List<Following> following,
      PlayWorld world,
      double passed,
      double visionDelay) {
    this.plan = plan;
    this.ball = ball;
    this.driver = driver;
    this.safety = safety;
    this.motions = motions;
    this.following = following;
    this.world = world;
    this.passed = passed;
    this.visionDelay = visionDelay;
    // A robot that was taken off the field stays an obstacle for some seconds only.
    seen = world.robots().stream().filter(r -> world.time() - r.seen() < 3 && isFinite(r)).toList();
    for (Robot r : seen) {
      if (r.id().equals(plan.first())) {
        ours[0] = r;
      } else if (r.id().equals(plan.second())) {
        ours[1] = r;
      }
    }
  }

  private static boolean isFinite(Robot r) {
    return Double.isFinite(r.x() + r.y() + r.orientation() + r.vx() + r.vy());
  }

  PlayPlan plan() {
    return plan;
  }

  PlayLimits limits() {
    return plan.limits();
  }

  PlayArea area() {
    return plan.area();
  }

  PlayWorld world() {
    return world;
  }

  double time() {
    return world.time();
  }

  /** For how long the play has been running, s. Waits are measured with it: vision's clock may jump. */
  double passed() {
    return passed;
  }

  /** How late vision's frames arrive, s. */
  double visionDelay() {
    return visionDelay;
  }

  /** For how long something has not been seen that was seen then, beyond the delay of vision, s. */
  private double unseen(double seen) {
    return Math.max(0, world.time() - visionDelay - seen);
  }

  /**
   * How much later than usual a robot does what it is ordered, s: the delay of vision is not part of it, as far as it is known. Weak brakes count as lateness, too.
   */
  double heardLate(int index) {
    return Math.max(0, following.get(index).late() - Following.USUAL - visionDelay);
  }

  BallMemory ball() {
    return ball;
  }

  /** One of our robots; null when it is not seen, but then no step is called. */
  Robot robot(int index) {
    return ours[index];
  }

  boolean sees(int index) {
    return ours[index] != null && unseen(ours[index].seen()) < ROBOT_UNSEEN;
  }

  /** Whether one of our robots does not move, although it is commanded to drive. */
  boolean stuck(int index) {
    return motions.get(index).stuck();
  }

  /** Whether one of our robots has not moved for long enough that nothing else that it did not do is of interest. */
  boolean hardlyMoves(int index) {
    return motions.get(index).hardlyMoves();
  }

  String doesNotMove(int index) {
    return plan.robot(index) + " does not move";
  }

  double ballUnseen() {
    return unseen(ball.seen());
  }

  /** Robots that are not ours. */
  List<Robot> others() {
    return seen.stream().filter(r -> r != ours[0] && r != ours[1]).toList();
  }

  /** All robots but one of ours. */
  List<Robot> except(int index) {
    return seen.stream().filter(r -> r != ours[index]).toList();
  }

  /** Another robot than the given one of ours near a place. */
  Optional<Robot> near(double x, double y, double distance, int except) {
    return except(except).stream()
        .filter(r -> Math.hypot(r.x() - x, r.y() - y) < distance)
        .findFirst();
  }

  /** Distance from the ball to the point where a robot's dribbler holds one, m. */
  double fromDribbler(int index) {
    Robot r = ours[index];
    double x = r.x() + PlayArea.AT_DRIBBLER * Math.cos(r.orientation());
    double y = r.y() + PlayArea.AT_DRIBBLER * Math.sin(r.orientation());
    return ball.distance(x, y);
  }

  private List<Circle> obstacles(int index) {
    List<Circle> circles = new ArrayList<>();
    double radius = 2 * PlayArea.ROBOT_RADIUS + limits().clearance();
    for (Robot r : seen) {
      if (r != ours[index]) {
        circles.add(new Circle(r.x() + 0.2 * r.vx(), r.y() + 0.2 * r.vy(), radius));
      }
    }
    return circles;
  }

  private List<Circle> obstacles(int index, double ballClearance) {
    List<Circle> circles = obstacles(index);
    if (ballClearance > 0 && ball.known()) {
      circles.add(new Circle(ball.x(), ball.y(), ballClearance));
    }
    return circles;
  }

  /** Whether there is a way round all robots, and round the ball at a distance. */
  boolean hasWay(int index, Pose target, double ballClearance) {
    return driver.way(ours[index], target, obstacles(index, ballClearance)).isPresent();
  }

  /**
   * Drives round all robots, and round the ball at a distance; 0 ignores the ball.
   *
   * @return false when there is no way: it stands, and the reason is known
   */
  boolean drive(int index, Pose target, double speed, double ballClearance) {
    Optional<Velocity> driven =
        driver.to(
            ours[index],
            target,
            speed,
            following.get(index).calm(),
            obstacles(index, ballClearance));
    velocities[index] = driven.orElse(Velocity.ZERO);
    targets[index] = target;
    if (driven.isEmpty()) {
      waitFor(
          plan.robot(index) + " finds no way to its target",
          WaitingFor.robot(plan.robot(index)).at(target.x(), target.y()));
    }
    return driven.isPresent();
  }

  /**
   * Drives with a ball at the dribbler: as {@link #drive}, but speeding up, slowing down and turning no faster than the ball is held.
   *
   * @param before what it was ordered in the last tick
   * @param span since then, s
   * @return what it is ordered now
   */
  Velocity carry(int index, Pose target, Grip grip, Velocity before, double span) {
    Velocity wanted =
        driver
            .to(
                ours[index],
                target,
                grip.speed(),
                grip.acceleration(),
                following.get(index).calm(),
                obstacles(index))
            .orElse(Velocity.ZERO);
    double dx = wanted.vx() - before.vx();
    double dy = wanted.vy() - before.vy();
    double change = Math.hypot(dx, dy);
    double most = grip.acceleration() * span;
    double share = change > most ? most / change : 1;
    double turn = Math.max(-grip.turn(), Math.min(grip.turn(), wanted.angular()));
    velocities[index] = new Velocity(before.vx() + share * dx, before.vy() + share * dy, turn);
    // A host with a planner of its own would drive there as fast as it can.
    targets[index] = null;
    return velocities[index];
  }

  /** Drives straight, whatever is there. */
  void creep(int index, double vx, double vy, double orientation) {
    double angular =
        Driver.turn(ours[index].orientation(), orientation, following.get(index).calm());
    velocities[index] = new Velocity(vx, vy, angular);
    targets[index] = null;
  }

  /** Drives straight back, away from the ball. */
  void backOff(int index) {
    double front = ours[index].orientation();
    creep(index, -Task.BACK_OFF * Math.cos(front), -Task.BACK_OFF * Math.sin(front), front);
  }

  void dribble(int index) {
    dribblers[index] = true;
  }

  void arm(int index, Kick kick) {
    kicks[index] = kick;
  }

  /** Waits for something. If it is a robot of ours that follows its commands too late, this is told, too: nothing else may be amiss. */
  void waitFor(String reason, WaitingFor object) {
    boolean late =
        IntStream.range(0, 2)
            .filter(i -> object.robot().equals(Optional.of(plan.robot(i))))
            .anyMatch(i -> heardLate(i) > TOO_LATE);
    waiting = late ? reason + FOLLOWS_LATE : reason;
    waitingFor = object;
  }

  /** Waits for a robot of ours that shows that it follows its commands too late. */
  void waitForLate(String reason, int index) {
    waiting = plan.robot(index) + " " + reason + FOLLOWS_LATE;
    waitingFor = WaitingFor.robot(plan.robot(index));
  }

  /** The place of the ball, as far as it is known. */
  WaitingFor theBall() {
    return ball.known() ? WaitingFor.place(ball.x(), ball.y()) : WaitingFor.NOTHING;
  }

  Optional<String> waiting() {
    return Optional.ofNullable(waiting);
  }

  WaitingFor waitingFor() {
    return waitingFor;
  }

  void request(double x, double y, String reason) {
    request = new BallRequest(x, y, reason);
    waitFor(reason, WaitingFor.place(x, y));
  }

  /** The answer of this tick. */
  PlayAnswer answer() {
    List<Robot> both = new ArrayList<>();
    for (Robot r : ours) {
      if (r != null) {
        both.add(r);
      }
    }
    List<RobotOrder> orders = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      orders.add(
          ours[i] == null
              ? RobotOrder.stop(plan.robot(i))
              : new RobotOrder(
                  plan.robot(i),
                  safety.limited(ours[i], velocities[i], following.get(i), seen, both),
                  Optional.ofNullable(targets[i]),
                  kicks[i],
                  dribblers[i]));
    }
    return new PlayAnswer(orders, Optional.ofNullable(request));
  }
}
