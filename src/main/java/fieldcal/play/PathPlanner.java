package fieldcal.play;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Shortest way round circles and out of the goals: a visibility graph over points around the circles that are in the way, searched with Dijkstra's algorithm. Small: a dozen circles at most.
 */
final class PathPlanner {
  /** Corners of the polygon around a circle. */
  private static final int CORNERS = 10;

  private final PlayArea area;

  /** Something to drive round. */
  record Circle(double x, double y, double radius) {
    double distance(double px, double py) {
      return Math.hypot(px - x, py - y);
    }

    boolean blocks(double x0, double y0, double x1, double y1) {
      double dx = x1 - x0;
      double dy = y1 - y0;
      double squared = dx * dx + dy * dy;
      double t = squared == 0 ? 0 : ((x - x0) * dx + (y - y0) * dy) / squared;
      double share = Math.max(0, Math.min(1, t));
      return distance(x0 + share * dx, y0 + share * dy) < radius;
    }
  }

  /**
   * Where to drive next.
   *
   * @param x next corner, m
   * @param y next corner, m
   * @param length of the whole way, m
   * @param corner cosine of the turn at the next corner; -1 at the end of the way
   */
  record Way(double x, double y, double length, double corner) {}

  PathPlanner(PlayArea area) {
    this.area = area;
  }

  /** The way from one point to another; empty when there is none. */
  Optional<Way> way(double x, double y, double goalX, double goalY, List<Circle> circles) {
    double[] goal = outOf(circles, goalX, goalY);
    List<Circle> obstacles = new ArrayList<>();
    for (Circle c : circles) {
      // A robot within an obstacle may leave it, but not go deeper.
      double distance = c.distance(x, y);
      obstacles.add(
          distance < c.radius() ? new Circle(c.x(), c.y(), Math.max(0, distance - 1e-3)) : c);
    }
    if (isFree(x, y, goal[0], goal[1], obstacles)) {
      return Optional.of(new Way(goal[0], goal[1], Math.hypot(goal[0] - x, goal[1] - y), -1));
    }
    List<Circle> inTheWay =
        obstacles.stream().filter(c -> c.blocks(x, y, goal[0], goal[1])).toList();
    Way way = search(x, y, goal, inTheWay, obstacles);
    if (way == null && inTheWay.size() < obstacles.size()) {
      way = search(x, y, goal, obstacles, obstacles);
    }
    return Optional.ofNullable(way);
  }

  /** A goal that something stands on is moved to its edge. */
  private double[] outOf(List<Circle> circles, double goalX, double goalY) {
    double[] goal = {area.clampX(goalX), area.clampY(goalY)};
    for (int round = 0; round < 3; round++) {
      for (Circle c : circles) {
        double distance = c.distance(goal[0], goal[1]);
        if (distance < c.radius()) {
          double angle =
              distance == 0
                  ? Math.atan2(-goal[1], -goal[0])
                  : Math.atan2(goal[1] - c.y(), goal[0] - c.x());
          goal[0] = area.clampX(c.x() + (c.radius() + 1e-3) * Math.cos(angle));
          goal[1] = area.clampY(c.y() + (c.radius() + 1e-3) * Math.sin(angle));
        }
      }
    }
    return goal;
  }

  private Way search(
      double x, double y, double[] goal, List<Circle> around, List<Circle> obstacles) {
    List<double[]> nodes = new ArrayList<>();
    nodes.add(new double[] {x, y});
    nodes.add(goal);
    for (Circle c : around) {
      addCorners(c, obstacles, nodes);
    }
    addGoalCorners(obstacles, nodes);
    int n = nodes.size();
    double[] cost = new double[n];
    int[] before = new int[n];
    boolean[] done = new boolean[n];
    Arrays.fill(cost, Double.POSITIVE_INFINITY);
    cost[0] = 0;
    for (int i = nearest(cost, done); i >= 0 && i != 1; i = nearest(cost, done)) {
      done[i] = true;
      double[] from = nodes.get(i);
      for (int j = 1; j < n; j++) {
        double[] to = nodes.get(j);
        double sum = cost[i] + Math.hypot(to[0] - from[0], to[1] - from[1]);
        if (!done[j] && sum < cost[j] && isFree(from[0], from[1], to[0], to[1], obstacles)) {
          cost[j] = sum;
          before[j] = i;
        }
      }
    }
    return cost[1] < Double.POSITIVE_INFINITY ? firstLeg(nodes, before, cost[1]) : null;
  }

  private static Way firstLeg(List<double[]> nodes, int[] before, double length) {
    int after = -1;
    int next = 1;
    while (before[next] != 0) {
      after = next;
      next = before[next];
    }
    double[] start = nodes.get(0);
    double[] point = nodes.get(next);
    double corner = -1;
    if (after >= 0) {
      double[] beyond = nodes.get(after);
      double in = Math.atan2(point[1] - start[1], point[0] - start[0]);
      double out = Math.atan2(beyond[1] - point[1], beyond[0] - point[0]);
      corner = Math.cos(out - in);
    }
    return new Way(point[0], point[1], length, corner);
  }

  private void addCorners(Circle c, List<Circle> obstacles, List<double[]> nodes) {
    double radius = (c.radius() + 0.01) / Math.cos(Math.PI / CORNERS);
    for (int i = 0; i < CORNERS; i++) {
      double angle = 2 * Math.PI * i / CORNERS;
      add(c.x() + radius * Math.cos(angle), c.y() + radius * Math.sin(angle), obstacles, nodes);
    }
  }

  private void addGoalCorners(List<Circle> obstacles, List<double[]> nodes) {
    double x = area.length() / 2 - PlayArea.ROBOT_RADIUS - 0.03;
    double y = area.goalWidth() / 2 + PlayArea.ROBOT_RADIUS + 0.03;
    for (int i = 0; i < 4; i++) {
      add(i % 2 == 0 ? x : -x, i < 2 ? y : -y, obstacles, nodes);
    }
  }

  private void add(double x, double y, List<Circle> obstacles, List<double[]> nodes) {
    if (area.free(x, y) && obstacles.stream().noneMatch(c -> c.distance(x, y) < c.radius())) {
      nodes.add(new double[] {x, y});
    }
  }

  private static int nearest(double[] cost, boolean[] done) {
    int best = -1;
    for (int i = 0; i < cost.length; i++) {
      if (!done[i] && cost[i] < Double.POSITIVE_INFINITY && (best < 0 || cost[i] < cost[best])) {
        best = i;
      }
    }
    return best;
  }

  private boolean isFree(double x0, double y0, double x1, double y1, List<Circle> obstacles) {
    for (Circle c : obstacles) {
      if (c.blocks(x0, y0, x1, y1)) {
        return false;
      }
    }
    return !throughGoal(x0, y0, x1, y1, 1) && !throughGoal(x0, y0, x1, y1, -1);
  }

  private boolean throughGoal(double x0, double y0, double x1, double y1, int side) {
    double limit = area.length() / 2 - PlayArea.ROBOT_RADIUS - 0.01;
    double half = area.goalWidth() / 2 + PlayArea.ROBOT_RADIUS + 0.01;
    double a = side * x0 - limit;
    double b = side * x1 - limit;
    // A robot in a goal may come out of it.
    if (area.goalWidth() == 0 || b <= 0 && a <= 0 || a > 0 && Math.abs(y0) < half) {
      return false;
    }
    double from = a > 0 ? 0 : a / (a - b);
    double to = b > 0 ? 1 : a / (a - b);
    double yFrom = y0 + from * (y1 - y0);
    double yTo = y0 + to * (y1 - y0);
    return Math.min(yFrom, yTo) < half && Math.max(yFrom, yTo) > -half;
  }
}
