package fieldcal.play;

import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayWorld.Ball;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A field just good enough to run the play on without the simulation: robots that accelerate at 4 m/s², a ball that rolls, kickers and dribblers. Everything can be switched off or moved by a test.
 */
final class FakeField {
  static final RobotId YELLOW = new RobotId(Team.YELLOW, 3);
  static final RobotId BLUE = new RobotId(Team.BLUE, 7);
  static final RobotId THIRD = new RobotId(Team.BLUE, 9);
  static final FieldGeometry GEOMETRY = FieldGeometry.of(12, 9, 1.8, 0.18, 0.3, List.of());
  static final double TICK = 0.02;
  private static final double ACCELERATION = 4;
  private static final double ROLLING = 0.4;

  /** A robot and what it was told. */
  static final class Body {
    double x;
    double y;
    double orientation;
    double vx;
    double vy;
    boolean visible = true;
    boolean obeys = true;
    double seen;
    RobotOrder order;
  }

  final Map<RobotId, Body> robots = new LinkedHashMap<>();
  double time;
  double ballX = 1;
  double ballY = 0.5;
  double ballVx;
  double ballVy;
  boolean ballVisible = true;
  double ballSeen;
  boolean vision = true;
  double visionTime;
  boolean kickersFire = true;
  boolean somebodyHelps = true;

  /** Faster than that a dribbler does not pull a ball, m/s. */
  double pullsUpTo = Double.POSITIVE_INFINITY;

  /** From a robot that is faster with it the ball jumps off, m/s. */
  double holdsUpTo = Double.POSITIVE_INFINITY;

  int lost;
  Permission permission = Permission.RUN;
  RobotId holder;
  Optional<BallRequest> request = Optional.empty();
  int requests;
  double nearest = Double.POSITIVE_INFINITY;
  double hardestContact;
  double farthestOut = Double.NEGATIVE_INFINITY;
  private double requestedSince = Double.NaN;

  FakeField() {
    put(YELLOW, -3, -2, 0);
    put(BLUE, 3, 2, Math.PI);
  }

  Body put(RobotId id, double x, double y, double orientation) {
    Body body = robots.computeIfAbsent(id, i -> new Body());
    body.x = x;
    body.y = y;
    body.orientation = orientation;
    body.seen = time;
    return body;
  }

  void ball(double x, double y) {
    ballX = x;
    ballY = y;
    ballVx = 0;
    ballVy = 0;
    holder = null;
  }

  PlayWorld world() {
    if (vision) {
      visionTime = time;
      ballSeen = ballVisible ? time : ballSeen;
    }
    List<Robot> seen = new ArrayList<>();
    robots.forEach(
        (id, b) -> {
          b.seen = vision && b.visible ? time : b.seen;
          seen.add(new Robot(id, b.x, b.y, b.orientation, b.vx, b.vy, b.seen));
        });
    Optional<Ball> ball = Optional.of(new Ball(ballX, ballY, ballVx, ballVy, ballSeen));
    return new PlayWorld(time, visionTime, ball, seen, permission);
  }

  /** One tick of play and field; answers what the play answered. */
  PlayAnswer tick(CalibrationPlay play) {
    PlayAnswer answer = play.tick(world());
    for (RobotOrder order : answer.orders()) {
      robots.get(order.robot()).order = order;
    }
    request = answer.request();
    help();
    step();
    return answer;
  }

  /** Everybody does what he was told last, for one tick. */
  void step() {
    time += TICK;
    robots.values().forEach(this::move);
    moveBall();
    measure();
  }

  /** Runs until it is over, at most so long. */
  void run(CalibrationPlay play, double seconds) {
    double end = time + seconds;
    while (time < end && !play.over()) {
      tick(play);
    }
  }

  private void help() {
    if (request.isEmpty()) {
      requestedSince = Double.NaN;
      return;
    }
    requestedSince = Double.isNaN(requestedSince) ? time : requestedSince;
    if (somebodyHelps && time - requestedSince > 2) {
      ball(request.get().x(), request.get().y());
      ballVisible = true;
      requestedSince = Double.NaN;
      requests++;
    }
  }

  private void move(Body b) {
    boolean obeys = b.obeys && b.order != null;
    double dvx = (obeys ? b.order.velocity().vx() : 0) - b.vx;
    double dvy = (obeys ? b.order.velocity().vy() : 0) - b.vy;
    double change = Math.hypot(dvx, dvy);
    double share = change > ACCELERATION * TICK ? ACCELERATION * TICK / change : 1;
    b.vx += share * dvx;
    b.vy += share * dvy;
    b.x += b.vx * TICK;
    b.y += b.vy * TICK;
    b.orientation += (obeys ? b.order.velocity().angular() : 0) * TICK;
  }

  private void moveBall() {
    for (Map.Entry<RobotId, Body> entry : robots.entrySet()) {
      Body b = entry.getValue();
      if (b.order != null) {
        touch(entry.getKey(), b);
      }
    }
    if (holder != null) {
      Body b = robots.get(holder);
      ballX = b.x + PlayArea.AT_DRIBBLER * Math.cos(b.orientation);
      ballY = b.y + PlayArea.AT_DRIBBLER * Math.sin(b.orientation);
      ballVx = b.vx;
      ballVy = b.vy;
      double pulled = -(b.vx * Math.cos(b.orientation) + b.vy * Math.sin(b.orientation));
      if (!b.order.dribbler() || pulled > pullsUpTo || Math.hypot(b.vx, b.vy) > holdsUpTo) {
        ballY += Math.hypot(b.vx, b.vy) > holdsUpTo ? 0.4 * Math.signum(-ballY) : 0;
        lost += b.order.dribbler() ? 1 : 0;
        holder = null;
        ballVx = 0;
        ballVy = 0;
      }
      return;
    }
    double speed = Math.hypot(ballVx, ballVy);
    double slower = speed > ROLLING * TICK ? 1 - ROLLING * TICK / speed : 0;
    ballVx *= slower;
    ballVy *= slower;
    ballX += ballVx * TICK;
    ballY += ballVy * TICK;
    boolean atBoards = Math.abs(ballX) > 6.4 || Math.abs(ballY) > 4.9;
    if (atBoards) {
      ballVx = 0;
      ballVy = 0;
    }
  }

  private void touch(RobotId id, Body b) {
    double cos = Math.cos(b.orientation);
    double sin = Math.sin(b.orientation);
    double ahead = (ballX - b.x) * cos + (ballY - b.y) * sin;
    double aside = -(ballX - b.x) * sin + (ballY - b.y) * cos;
    double reach = PlayArea.AT_DRIBBLER + 0.005 + Math.max(0, closing(b) * TICK);
    if (ahead < 0 || ahead > reach || Math.abs(aside) > 0.06) {
      return;
    }
    if (b.order.kick().armed() && kickersFire) {
      holder = null;
      double speed = b.order.kick().speed() * Math.cos(b.order.kick().elevation());
      ballVx = speed * cos;
      ballVy = speed * sin;
    } else if (b.order.dribbler() && b.obeys) {
      holder = id;
    } else if (closing(b) > 0) {
      ballX = b.x + PlayArea.AT_DRIBBLER * cos - aside * sin;
      ballY = b.y + PlayArea.AT_DRIBBLER * sin + aside * cos;
      ballVx = b.vx;
      ballVy = b.vy;
    }
  }

  private double closing(Body b) {
    return (b.vx - ballVx) * Math.cos(b.orientation) + (b.vy - ballVy) * Math.sin(b.orientation);
  }

  private void measure() {
    List<Body> all = List.copyOf(robots.values());
    for (int i = 0; i < all.size(); i++) {
      Body a = all.get(i);
      if (i < 2) {
        farthestOut = Math.max(farthestOut, Math.max(Math.abs(a.x) - 6, Math.abs(a.y) - 4.5));
      }
      for (int j = i + 1; j < all.size(); j++) {
        Body b = all.get(j);
        double dx = b.x - a.x;
        double dy = b.y - a.y;
        double distance = Math.hypot(dx, dy);
        nearest = Math.min(nearest, distance);
        if (distance < 0.18) {
          double closing = ((a.vx - b.vx) * dx + (a.vy - b.vy) * dy) / distance;
          hardestContact = Math.max(hardestContact, closing);
        }
      }
    }
  }
}
