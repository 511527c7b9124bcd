package fieldcal.kick;

import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A kick whose ball is still being followed. */
final class ActiveKick {
  /** Cameras whose newest detection is that old no longer see the ball, s. */
  private static final double LIVE = 0.06;

  /** Twice what cameras disagree by on the ground, and the noise, m: some 0.2 m of height. */
  private static final double AIRBORNE = 0.1;

  /** A ball that ends nearer was nudged, or put elsewhere while it was hidden; the weakest kick rolls that far, m. */
  private static final double SHORTEST = 0.3;

  private final JumpDetector.Jump jump;
  private final RobotId robot;
  private final boolean dribbled;
  private final KickFinderSettings settings;
  private final List<BallTrack> members = new ArrayList<>();
  private final Observations.Builder observations = new Observations.Builder();
  private final ContactWatch contact = new ContactWatch();
  private final LineFit line = new LineFit();
  private final double[] xy = new double[2];
  private boolean leftKicker;
  private double farthest;
  private boolean entered;
  private BallTrack newest;
  private double outsideSince = Double.NaN;

  ActiveKick(JumpDetector.Jump jump, RobotId robot, boolean dribbled, KickFinderSettings settings) {
    this.jump = jump;
    this.robot = robot;
    this.dribbled = dribbled;
    this.settings = settings;
  }

  double time() {
    return jump.time();
  }

  JumpDetector.Jump jump() {
    return jump;
  }

  boolean kickedBy(RobotId candidate) {
    return candidate != null && candidate.equals(robot);
  }

  boolean has(BallTrack track) {
    return members.contains(track);
  }

  double lastTime() {
    return newest.lastTime();
  }

  BallTrack newest() {
    return newest;
  }

  List<BallTrack> members() {
    return members;
  }

  /** Whether a camera sees this ball around {@code t}. */
  boolean sees(int camera, double t) {
    for (BallTrack m : members) {
      if (m.camera() == camera && t - m.lastTime() < LIVE) {
        return true;
      }
    }
    return false;
  }

  /** How fast the ball was when last seen, if that was just before and near; else 0, m/s. */
  double speedNear(double t, double x, double y) {
    boolean near = Math.hypot(newest.x(0) - x, newest.y(0) - y) < KickFinder.SAME_BALL;
    return near && t - newest.lastTime() < settings.lostAfter() && newest.fitNewest(6, 0.15, line)
        ? line.speed()
        : 0;
  }

  /** Takes in a track that turned out to show this ball, with what it holds of the rest before the kick and of the flight. */
  void join(BallTrack track) {
    if (has(track)) {
      return;
    }
    double from = jump.fromRest() ? restStart(track) : jump.time();
    for (int age = track.size() - 1; age >= 0; age--) {
      if (track.time(age) >= from) {
        track.copyTo(age, observations);
      }
    }
    members.add(track);
    if (newest == null || track.lastTime() > newest.lastTime()) {
      newest = track;
    }
  }

  /** Since when the ball lay still before the kick, as far back as {@code restSpan} and without what a robot pushed. */
  private double restStart(BallTrack track) {
    double end = jump.time() - 0.01;
    int last = 0;
    while (last < track.size() && track.time(last) > end) {
      last++;
    }
    for (double span = settings.restSpan(); span > 0.1; span *= 0.7) {
      int first = last;
      while (first + 1 < track.size() && track.time(first + 1) > end - span) {
        first++;
      }
      if (first - last < 4 || !track.fit(last, first, line)) {
        return jump.time();
      }
      if (line.speed() < Math.max(0.01, 3 * line.velocityError()) && line.rms() < 0.02) {
        return track.time(first);
      }
    }
    return jump.time();
  }

  /** A member's newest detection; says why the kick ends with it, or null. */
  KickEnd update(BallTrack track, RobotPoses robots, PlayingArea area) {
    track.copyTo(0, observations);
    newest = track;
    double t = track.lastTime();
    double x = track.x(0);
    double y = track.y(0);
    farthest = Math.max(farthest, Math.hypot(x - jump.x(), y - jump.y()));
    leftKicker |= t - jump.time() > 0.1 && Math.hypot(x - jump.x(), y - jump.y()) > 0.3;
    double distance = robots.distance(t, x, y, leftKicker ? null : robot);
    boolean reachable = t - jump.time() > 0.05 && !inTheAir(track, t);
    if (reachable && contact.update(track, distance) == ContactWatch.Verdict.TOUCHED) {
      return KickEnd.TOUCHED_ROBOT;
    }
    double outside = area.outside(x, y);
    entered |= outside <= 0;
    if (outside <= 0 || !entered) {
      // A ball kicked from beyond a line first comes in.
      outsideSince = Double.NaN;
    } else if (Double.isNaN(outsideSince)) {
      outsideSince = t;
    } else if (outside > 0.1 || t - outsideSince > 0.15) {
      return KickEnd.LEFT_FIELD;
    }
    return t - jump.time() > 0.5 && stopped(track) ? KickEnd.STOPPED : null;
  }

  /** Two cameras that report the same ball far apart see it in the air, where no robot touches it. */
  boolean inTheAir(BallTrack track, double t) {
    if (!track.positionAt(t, LIVE, line, xy)) {
      return false;
    }
    double x = xy[0];
    double y = xy[1];
    for (BallTrack other : members) {
      if (other.camera() != track.camera()
          && other.positionAt(t, LIVE, line, xy)
          && Math.hypot(xy[0] - x, xy[1] - y) > AIRBORNE) {
        return true;
      }
    }
    return false;
  }

  private boolean stopped(BallTrack track) {
    return track.fitNewest(64, settings.stopSpan(), line)
        && line.count() >= 8
        && track.lastTime() - track.time(line.count() - 1) > 0.7 * settings.stopSpan()
        && line.speed() < Math.max(settings.stopSpeed(), 2 * line.velocityError());
  }

  /** Why a kick ends whose ball nobody sees any more. */
  KickEnd vanished(PlayingArea area, RobotPoses robots, KickEnd otherwise) {
    double t = newest.lastTime();
    double ahead = t + 0.1;
    if (newest.fitNewest(8, 0.15, line) && area.outside(line.x(ahead), line.y(ahead)) > 0) {
      return KickEnd.LEFT_FIELD;
    }
    boolean near = robots.distance(t, newest.x(0), newest.y(0), leftKicker ? null : robot) < 0.25;
    return near && otherwise == KickEnd.LOST ? KickEnd.TOUCHED_ROBOT : otherwise;
  }

  /** The finished kick, or null when nothing sustained came of it. */
  Kick finish(KickEnd end, double endTime) {
    double last = endTime;
    if (end == KickEnd.TOUCHED_ROBOT && contact.watching()) {
      last = Math.min(last, contact.since() - 0.005);
    } else if (end == KickEnd.LEFT_FIELD && !Double.isNaN(outsideSince)) {
      last = Math.min(last, outsideSince);
    }
    if (!(last > jump.time() + 0.05) || farthest < SHORTEST) {
      return null;
    }
    Observations seen = observations.build().between(Double.NEGATIVE_INFINITY, last);
    return new Kick(
        0,
        jump.time(),
        jump.x(),
        jump.y(),
        jump.vx(),
        jump.vy(),
        Optional.ofNullable(robot),
        jump.fromRest(),
        end,
        last,
        seen,
        dribbled);
  }
}
