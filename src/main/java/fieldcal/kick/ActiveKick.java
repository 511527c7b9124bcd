package fieldcal.kick;

import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A kick whose ball is still being followed. */
final class ActiveKick {
  /** A camera whose newest detection is older no longer sees the ball, s. */
  private static final double LIVE = 0.06;

  /** Reports farther apart show a ball in the air, m: twice what cameras disagree by on the ground, plus the noise; a height of some 0.2 m shifts them as much. */
  private static final double AIRBORNE = 0.1;

  /** Two cameras agree on a ball in the last 0.2 m of its fall; it takes that long at 2 m/s, s. */
  private static final double FALL = 0.1;

  /** Number of detections in a row that must show it before a ball counts as in the air. */
  private static final int SURELY = 3;

  /** A ball that was just kicked is still near the robots around its kicker, s. */
  private static final double SOON = 0.05;

  /** A ball that comes back into view was hidden for longer than this, s. */
  private static final double JUST_SEEN = 0.05;

  /** A ball that ends nearer was nudged, or moved elsewhere while it was hidden; the weakest kick rolls this far, m. */
  private static final double SHORTEST = 0.3;

  /** A ball that was followed for less time was not kicked, s. */
  private static final double SHORTEST_FLIGHT = 0.04;

  /** No ball rolls longer: from 4 m/s at 0.2 m/s² it takes 20 s. What lasts longer is no kick and must not fill the memory, s. */
  private static final double LONGEST = 30;

  /** A slower ball rests, m/s; this is certain only if the error of its speed is as small. */
  private static final double STILL = 0.01;

  /** A ball that is faster has not stopped, m/s. */
  private static final double MOVING = 0.2;

  /** Fewer detections after the kick do not make a kick. */
  private static final int FEWEST = 5;

  /** The kick itself is found to a few milliseconds, s. */
  private static final double JUST_BEFORE = 0.01;

  /** The ball may have met a robot up to a frame after it was seen last, s. */
  private static final double FRAME = 0.014;

  private final JumpDetector.Jump jump;
  private final RobotId robot;
  private final boolean dribbled;
  private final KickFinderSettings settings;
  private final List<BallTrack> members = new ArrayList<>();
  private final List<BallTrack> others = new ArrayList<>();
  private final Observations.Builder observations = new Observations.Builder();
  private final ContactWatch contact;
  private final LineFit line = new LineFit();
  private final double[] xy = new double[2];
  private boolean leftKicker;
  private double farthest;
  private boolean entered;
  private BallTrack newest;
  private BallTrack source;
  private double outsideSince = Double.NaN;
  private int seenInTheAir;
  private boolean movedBefore;

  ActiveKick(JumpDetector.Jump jump, RobotId robot, boolean dribbled, KickFinderSettings settings) {
    this.jump = jump;
    this.robot = robot;
    this.dribbled = dribbled;
    this.settings = settings;
    contact = new ContactWatch(jump.time());
  }

  double time() {
    return jump.time();
  }

  /** Begins with the track in which the kick was found. The kick is found a tenth of a second late, so the ball may have met a robot meanwhile. */
  void startedBy(BallTrack track, RobotPoses robots) {
    source = track;
    join(track);
    for (int age = track.size() - 1; age >= 0; age--) {
      double t = track.time(age);
      if (t - jump.time() > SOON
          && ContactWatch.isNear(robots.distance(t, track.x(age), track.y(age), robot))) {
        contact.watchFrom(t);
        return;
      }
    }
  }

  /** The track in which the kick was found: another jump in it is another kick. */
  BallTrack source() {
    return source;
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
    boolean near = Math.hypot(newest.x(0) - x, newest.y(0) - y) < RecentEvents.SAME_BALL;
    return near && t - newest.lastTime() < settings.lostAfter() && newest.fitNewest(6, 0.15, line)
        ? line.speed()
        : 0;
  }

  /** Whether a ball that comes into view, or back into view, may well have moved there as it moves on. */
  boolean goesOn(BallTrack track, JumpDetector.Jump jump) {
    int age = 0;
    while (age < track.size() && track.time(age) > jump.time() - JUST_SEEN) {
      age++;
    }
    int oldest = Math.min(age + 8, track.size()) - 1;
    if (age >= track.size() || !(track.time(age) > time()) || !track.fit(age, oldest, line)) {
      return true;
    }
    double change = Math.hypot(jump.vx() - line.vx(), jump.vy() - line.vy());
    return change < 0.3 + 0.5 * line.speed();
  }

  /** Whether a track looked like this ball, but was something else. */
  boolean isOther(BallTrack track) {
    return others.contains(track);
  }

  /** A track turned out to show something else. */
  private void leave(BallTrack track) {
    members.remove(track);
    others.add(track);
    observations.drop(track.camera(), track.time(track.size() - 1));
    newest = members.get(0);
    for (BallTrack member : members) {
      newest = member.lastTime() > newest.lastTime() ? member : newest;
    }
  }

  /** Takes in a track that turned out to show this ball, with what it holds of the rest before the kick and of the flight. */
  void join(BallTrack track) {
    if (has(track)) {
      return;
    }
    double from = restStart(track);
    for (int age = track.size() - 1; age >= 0; age--) {
      if (track.time(age) >= from) {
        track.copyTo(age, observations);
        went(track.x(age), track.y(age));
      }
    }
    members.add(track);
    if (newest == null || track.lastTime() > newest.lastTime()) {
      newest = track;
    }
  }

  /**
   * Since when the ball lay still before the kick, at most {@code restSpan} before it and not before a robot last pushed it; the kick's time when that is not known. Robots often touch a ball before they kick it, and over a tenth of a second a slow ball looks like one at rest. Shortly before the kick is found it may already move: pushed, or as a chip that is projected to where it was.
   */
  private double restStart(BallTrack track) {
    double still = jump.fromRest() ? restStart(track, JUST_BEFORE) : jump.time();
    if (still < jump.time()) {
      return still;
    }
    double before = restStart(track, Departure.LATEST + JUST_BEFORE);
    movedBefore |= before < jump.time();
    return before;
  }

  private double restStart(BallTrack track, double before) {
    double end = jump.time() - before;
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
      boolean still = line.speed() < Math.max(STILL, 3 * line.velocityError());
      if (still && line.velocityError() < STILL && line.rms() < 0.02) {
        return track.time(first);
      }
    }
    return jump.time();
  }

  /** Takes a member's newest detection; returns why the kick ends with it, or null. */
  KickEnd update(BallTrack track, RobotPoses robots, PlayingArea area) {
    track.copyTo(0, observations);
    newest = track;
    double t = track.lastTime();
    double x = track.x(0);
    double y = track.y(0);
    went(x, y);
    leftKicker |= t - jump.time() > 0.1 && Math.hypot(x - jump.x(), y - jump.y()) > 0.3;
    seenInTheAir = inTheAir(track, t) ? seenInTheAir + 1 : 0;
    if (seenInTheAir >= SURELY) {
      contact.release();
    } else if (t - jump.time() > SOON) {
      double distance = robots.distance(t, x, y, leftKicker ? null : robot);
      if (contact.update(track, members, distance) == ContactWatch.Verdict.TOUCHED) {
        return KickEnd.TOUCHED_ROBOT;
      }
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
    if (t - jump.time() > LONGEST) {
      return KickEnd.LOST;
    }
    if (t - jump.time() < 0.5 || !stopped(track)) {
      return null;
    }
    if (track != source && movesElsewhere(track)) {
      leave(track);
      return null;
    }
    return contact.stoppedShort(track) ? KickEnd.TOUCHED_ROBOT : KickEnd.STOPPED;
  }

  private void went(double x, double y) {
    farthest = Math.max(farthest, Math.hypot(x - jump.x(), y - jump.y()));
  }

  /** Whether the ball was in the air until shortly before, so that a jump of its velocity may be a bounce. */
  boolean wasInTheAir(BallTrack track, double t) {
    return inTheAir(track, t - 0.02) || inTheAir(track, t - 0.05) || inTheAir(track, t - FALL);
  }

  /** Two cameras that report the same ball far apart see it in the air, where no robot touches it. */
  boolean inTheAir(BallTrack track, double t) {
    if (!track.positionAt(t, LIVE, line, xy)) {
      return false;
    }
    double x = xy[0];
    double y = xy[1];
    for (BallTrack other : members) {
      if (other.camera() != track.camera() && other.positionAt(t, LIVE, line, xy)) {
        // A ball that was just stopped is not where the other camera's last images send it.
        double guessed = t > other.lastTime() ? (t - other.lastTime()) * line.speed() : 0;
        if (Math.hypot(xy[0] - x, xy[1] - y) > AIRBORNE + guessed) {
          return true;
        }
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

  /** What one camera sees lying still is not the ball if another sees it moving. */
  private boolean movesElsewhere(BallTrack track) {
    for (BallTrack other : members) {
      if (other != track
          && track.lastTime() - other.lastTime() < LIVE
          && other.fitNewest(8, 0.15, line)
          && line.speed() > MOVING + 3 * line.velocityError()) {
        return true;
      }
    }
    return false;
  }

  /** Why the kick ends when no camera sees its ball any more. */
  KickEnd vanished(PlayingArea area, RobotPoses robots, KickEnd otherwise) {
    double t = newest.lastTime();
    double ahead = t + 0.1;
    if (newest.fitNewest(8, 0.15, line) && area.outside(line.x(ahead), line.y(ahead)) > 0) {
      return KickEnd.LEFT_FIELD;
    }
    boolean near = robots.distance(t, newest.x(0), newest.y(0), leftKicker ? null : robot) < 0.25;
    return near && otherwise == KickEnd.LOST ? KickEnd.TOUCHED_ROBOT : otherwise;
  }

  /** When the ball met the robot that touched it, or was seen last, s. */
  double touchTime() {
    return contact.watching() ? Math.min(contact.since(), lastTime()) : lastTime();
  }

  /** The finished kick, or null when it was too short. */
  Kick finish(KickEnd end, double endTime) {
    double last = endTime;
    boolean atRobot = end == KickEnd.TOUCHED_ROBOT || end == KickEnd.STOPPED;
    if (atRobot && contact.watching()) {
      // A slow ball that comes to rest beside a robot may have been stopped by it.
      last = Math.min(last, contact.since() - 0.005);
    } else if (end == KickEnd.LEFT_FIELD && !Double.isNaN(outsideSince)) {
      last = Math.min(last, outsideSince);
    }
    if (!(last > jump.time() + SHORTEST_FLIGHT) || farthest < SHORTEST) {
      return null;
    }
    Observations seen = observations.build().between(Double.NEGATIVE_INFINITY, last);
    // A ball that was hidden when it met a robot was under way for as long as it was seen.
    last = Math.min(last, seen.size() == 0 ? last : seen.time(seen.size() - 1) + FRAME);
    if (!(last > jump.time() + SHORTEST_FLIGHT) || seen.count(jump.time()) < FEWEST) {
      return null;
    }
    boolean rested = seen.size() > 0 && seen.time(0) < jump.time();
    if (!rested) {
      return kick(jump, false, end, last, seen, Kick.CROSSING_ERROR);
    }
    Departure from = Departure.of(seen, jump.time(), jump.vx(), jump.vy(), !movedBefore);
    return from.fromRest()
        ? kick(at(from, 0), true, end, last, seen, from.timeError())
        : kick(
            at(from, from.length() / jump.speed()),
            false,
            end,
            last,
            seen.between(from.over(), last),
            from.timeError());
  }

  /** The jump, moved to the time and the place of the kick; {@code pushed} is the length of the push as a time at the speed of the kick, s. */
  private JumpDetector.Jump at(Departure from, double pushed) {
    return new JumpDetector.Jump(
        from.time(),
        jump.x() + pushed * jump.vx(),
        jump.y() + pushed * jump.vy(),
        jump.vx(),
        jump.vy(),
        jump.vxBefore(),
        jump.vyBefore(),
        from.fromRest(),
        false);
  }

  private Kick kick(
      JumpDetector.Jump at,
      boolean fromRest,
      KickEnd end,
      double last,
      Observations seen,
      double timeError) {
    return new Kick(
        0,
        at.time(),
        at.x(),
        at.y(),
        at.vx(),
        at.vy(),
        Optional.ofNullable(robot),
        fromRest,
        end,
        last,
        seen,
        dribbled,
        timeError);
  }
}
