package fieldcal.play;

import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.RobotOrder.Pose;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Predicate;

/** Decides which robot kicks the ball next, and from where: preferably from where it lies, otherwise from the end of the line. */
final class Decider {
  /** Aims beside the receiver that are tried when a robot is in the way, rad. */
  private static final double[] ASIDE = {0, 0.08, -0.08, 0.18, -0.18, 0.3, -0.3};

  /** Width of carpet along the kick that must be free, to either side, m. */
  private static final double CORRIDOR = 0.28;

  /** Largest distance of a chip's start from the line where the cameras overlap, m. */
  private static final double CHIP_ASIDE = 0.45;

  /** Length of a flat kick's path over the square of its speed, s²/m: it slides to 0.65 of its speed at 3.1 m/s², then rolls at 0.28. */
  private static final double WAY_PER_SPEED_SQUARED = 0.85;

  /** How far a chip's hops go in all, in lengths of its first hop: an impact leaves 0.7 of the speed along the carpet, later ones 0.87, and each 0.5 of that upwards. */
  private static final double WAY_PER_HOP = 1.7;

  /** Distance that a chip must have left to roll, m: cameras are compared where it rolls. */
  private static final double CHIP_ROLLS = 1;

  private static final double GRAVITY = 9.81;

  /** A ball that a robot would carry for longer is kicked from where it lies, s. Chosen: less than half of the 4 s that taking it, turning it, letting go and backing off take. */
  private static final double LONG_CARRY = 1.5;

  /** Penalty of a robot that does not move, m: longer than any drive of the other. */
  private static final double STUCK = 100;

  private Decider() {}

  /**
   * A kick from where the ball lies, without carrying it.
   *
   * @param carry how each robot would carry the ball
   */
  static Optional<Task> withoutCarrying(
      Situation s, PlannedKick kick, double x, double y, IntFunction<Grip> carry) {
    return fromHere(s, kick, x, y).or(() -> fromAfar(s, kick, x, y, carry));
  }

  /** A kick from where the ball lies, on its line or near it, with the kicker that is quicker there. */
  static Optional<Task> fromHere(Situation s, PlannedKick kick, double x, double y) {
    return quickest(s, x, y, i -> from(s, kick, i, x, y));
  }

  /**
   * A kick back to the line from a ball within the lines that lies far off: it counts like any other, and brings the ball back sooner than a robot carries it.
   *
   * @param carry how each robot would carry the ball
   */
  static Optional<Task> fromAfar(
      Situation s, PlannedKick kick, double x, double y, IntFunction<Grip> carry) {
    PlayLine line = s.plan().lineOf(kick);
    return quickest(
        s,
        x,
        y,
        i -> {
          double way = Math.hypot(line.x(i) - x, line.y(i) - y);
          boolean afar = way / carry.apply(i).speed() > LONG_CARRY && s.area().within(x, y);
          return afar && s.plan().keepsTo(x)
              ? towardsEnd(s, kick, i, x, y, task -> isSafe(s, task))
              : Optional.empty();
        });
  }

  /** Whether the kicker gets behind the ball, and a ball that rolls as far as the line's end stays within the lines. */
  private static boolean isSafe(Situation s, Task task) {
    PlayLine line = s.plan().lineOf(task.kick());
    int end = task.other();
    double run = Math.hypot(line.x(end) - task.x(), line.y(end) - task.y());
    double x = task.x() + run * Math.cos(task.aim());
    double y = task.y() + run * Math.sin(task.aim());
    return s.area().within(x, y) && s.hasWay(task.kicker(), task.behind(), Task.AROUND);
  }

  private static Optional<Task> quickest(
      Situation s, double x, double y, IntFunction<Optional<Task>> taskOf) {
    Task best = null;
    double bestCost = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 2; i++) {
      Optional<Task> task = taskOf.apply(i);
      if (task.isPresent()) {
        double run = task.get().along(task.get().receiver().x(), task.get().receiver().y());
        double drive = Math.hypot(s.robot(i).x() - x, s.robot(i).y() - y);
        double cost = drive - 0.15 * run + (s.stuck(i) ? STUCK : 0);
        if (cost < bestCost) {
          bestCost = cost;
          best = task.get();
        }
      }
    }
    return Optional.ofNullable(best);
  }

  /** A kick by one robot from a place on its line or near it, if there is enough way, room behind the ball and nobody before it. */
  static Optional<Task> from(Situation s, PlannedKick kick, int kicker, double x, double y) {
    boolean inside = s.area().placingX(x) == x && s.area().placingY(y) == y;
    inside &= s.plan().contains(x, y);
    boolean onLine = !kick.chip() || s.plan().lineOf(kick).aside(x, y) < CHIP_ASIDE;
    return inside && onLine ? towardsEnd(s, kick, kicker, x, y, task -> true) : Optional.empty();
  }

  /** A kick from anywhere to the other robot's end of the line. */
  private static Optional<Task> towardsEnd(
      Situation s, PlannedKick kick, int kicker, double x, double y, Predicate<Task> allowed) {
    PlayLine line = s.plan().lineOf(kick);
    double toX = line.x(1 - kicker);
    double toY = line.y(1 - kicker);
    double run = Math.hypot(toX - x, toY - y);
    if (run < leastRun(line, kick)) {
      return Optional.empty();
    }
    double straight = Math.atan2(toY - y, toX - x);
    for (double aside : ASIDE) {
      double aim = straight + aside;
      double distance = Math.min(run, s.limits().receiverDistance());
      Pose receiver =
          new Pose(
              s.area().clampX(x + distance * Math.cos(aim)),
              s.area().clampY(y + distance * Math.sin(aim)),
              aim + Math.PI);
      Task task = new Task(kick, kicker, x, y, aim, receiver);
      if (isFree(s, task, distance) && allowed.test(task)) {
        return Optional.of(task);
      }
    }
    return Optional.empty();
  }

  private static double leastRun(PlayLine line, PlannedKick kick) {
    double share = 0.55 * line.length();
    double squared = kick.speed() * kick.speed();
    double hop = squared * Math.sin(2 * kick.elevation()) / GRAVITY;
    double way =
        kick.chip() ? WAY_PER_HOP * hop + CHIP_ROLLS : WAY_PER_SPEED_SQUARED * squared + 0.3;
    return Math.min(share, way);
  }

  /** Whether no third robot stands behind the ball or in its way. */
  static boolean isFree(Situation s, Task task, double distance) {
    Pose behind = task.behind();
    if (!s.area().free(behind.x(), behind.y())) {
      return false;
    }
    return inTheWay(s, task, distance).isEmpty();
  }

  /** A third robot in the way of a kick or of its kicker. */
  static Optional<Robot> inTheWay(Situation s, Task task, double distance) {
    return s.others().stream()
        .filter(
            r -> {
              double along = task.along(r.x(), r.y());
              double aside = Math.abs(task.aside(r.x(), r.y()));
              return along > -0.4 && along < distance + 0.2 && aside < CORRIDOR;
            })
        .findFirst();
  }

  /** The robot that carries the ball to its end sooner. */
  static int carrier(Situation s, PlannedKick kick) {
    PlayLine line = s.plan().lineOf(kick);
    double[] cost = new double[2];
    for (int i = 0; i < 2; i++) {
      cost[i] =
          s.ball().distance(s.robot(i).x(), s.robot(i).y()) / s.limits().driveSpeed()
              + s.ball().distance(line.x(i), line.y(i)) / s.limits().carrySpeed()
              + (s.stuck(i) ? STUCK / s.limits().carrySpeed() : 0);
    }
    return cost[0] <= cost[1] ? 0 : 1;
  }

  /** A kick from a robot's own end of the line, or from near it when a robot is there. */
  static Optional<Task> fromEnd(Situation s, PlannedKick kick, int kicker) {
    PlayLine line = s.plan().lineOf(kick);
    double length = line.length();
    double ux = (line.x(1 - kicker) - line.x(kicker)) / length;
    double uy = (line.y(1 - kicker) - line.y(kicker)) / length;
    double[][] shifts = {{0, 0}, {0.4, 0}, {0, 0.4}, {0, -0.4}, {0.9, 0}, {0.9, 0.4}, {0.9, -0.4}};
    for (double[] shift : shifts) {
      double x = s.area().placingX(line.x(kicker) + shift[0] * ux - shift[1] * uy);
      double y = s.area().placingY(line.y(kicker) + shift[0] * uy + shift[1] * ux);
      Optional<Task> task = from(s, kick, kicker, x, y);
      boolean occupied = s.others().stream().anyMatch(r -> Math.hypot(r.x() - x, r.y() - y) < 0.45);
      if (task.isPresent() && !occupied) {
        return task;
      }
    }
    return Optional.empty();
  }
}
