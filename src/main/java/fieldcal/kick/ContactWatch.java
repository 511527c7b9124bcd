package fieldcal.kick;

import java.util.List;

/**
 * Decides whether a robot that the ball comes near touches it.
 *
 * <p>A ball passes a robot within centimetres, or flies over it, without being touched. So nearness only raises the question; the answer is whether the ball goes on as it came, for most of the cameras: each
 * one's detections after the encounter are compared with a line through its own before, so that what cameras disagree by does not matter. A ball that the robot hides gives no answer until it
 * comes out again. What was seen after a contact never enters a kick.
 */
final class ContactWatch {
  /** Robot radius 90 mm, ball radius 21.5 mm, and 30 mm for cameras that disagree, m. */
  private static final double CONTACT_DISTANCE = 0.142;

  /** Beyond this distance the encounter is over, m. */
  private static final double CLEAR = CONTACT_DISTANCE + 0.05;

  /** A touch changes the velocity by more than this share of it, and by more than 0.3 m/s. */
  private static final double SHARE = 0.25;

  private static final double LEAST_CHANGE = 0.3;

  /** A touch also moves the ball off its path by at least this, m. */
  private static final double LEAST_MISS = 0.03;

  /** A sliding ball decelerates by up to this on its own, m/s². */
  private static final double SLIDING = 4;

  /** Error of a resting ball's place and of the place where it came near a robot, m. */
  private static final double NOISE = 0.01;

  /** No carpet slows a rolling ball more, m/s²; twice what matches show. */
  private static final double ROLLING = 0.6;

  /** Largest share of its speed that a rolling ball loses while it passes a robot. */
  private static final double MOST_LOSS = 0.4;

  /** Cameras whose newest detection is older do not see the ball, s. */
  private static final double LIVE = 0.06;

  private static final double SPAN = 0.2;

  /** When the ball was hidden for longer, it is no longer known how it came, s. */
  private static final double HIDDEN = 0.6;

  private static final int BEFORE = 8;
  private static final int AFTER = 5;
  private static final int FEWEST = 4;

  private final double kicked;
  private boolean watching;
  private double since;
  private final LineFit before = new LineFit();
  private final LineFit after = new LineFit();

  /**
   * Watches one kick.
   *
   * @param kicked when, s; no detection before shows how the ball came
   */
  ContactWatch(double kicked) {
    this.kicked = kicked;
  }

  /** Verdict on one detection. */
  enum Verdict {
    FREE,
    WATCHING,
    TOUCHED
  }

  /** When the ball came near, s; meaningful after {@link Verdict#TOUCHED} or while watching. */
  double since() {
    return since;
  }

  boolean watching() {
    return watching;
  }

  /** Watches from an earlier time on: the ball came near a robot before the kick was found. */
  void watchFrom(double t) {
    watching = true;
    since = t;
  }

  static boolean isNear(double robotDistance) {
    return robotDistance <= CONTACT_DISTANCE;
  }

  /** Whether the ball, now at rest, would have rolled on from where it came near a robot. */
  boolean stoppedShort(BallTrack track) {
    if (!watching || !fitBefore(track, seenAfter(track))) {
      return false;
    }
    double way = Math.hypot(track.x(0) - before.x(since), track.y(0) - before.y(since));
    double least = before.speed() * before.speed() / (2 * ROLLING);
    return way < 0.5 * least - NOISE;
  }

  /** Balls in the air pass above robots. */
  void release() {
    watching = false;
  }

  /**
   * Looks at the newest detection.
   *
   * @param track that it belongs to
   * @param members all tracks of this ball
   * @param robotDistance from the nearest robot, m
   */
  Verdict update(BallTrack track, List<BallTrack> members, double robotDistance) {
    if (!watching) {
      if (!isNear(robotDistance)) {
        return Verdict.FREE;
      }
      watchFrom(track.lastTime());
      return Verdict.WATCHING;
    }
    int deflected = 0;
    int answers = 0;
    for (BallTrack member : members) {
      int after = seenAfter(member);
      if (after >= FEWEST && track.lastTime() - member.lastTime() < LIVE && fit(member, after)) {
        answers++;
        deflected += deflected(member) ? 1 : 0;
      }
    }
    if (2 * deflected > answers) {
      return Verdict.TOUCHED;
    }
    if (robotDistance > CLEAR && seenAfter(track) >= FEWEST) {
      watching = false;
      return Verdict.FREE;
    }
    return Verdict.WATCHING;
  }

  private int seenAfter(BallTrack track) {
    int seen = 0;
    while (seen < track.size() && track.time(seen) > since) {
      seen++;
    }
    return seen;
  }

  /** Lines through what a camera saw before and, most recently, after. */
  private boolean fit(BallTrack track, int seenAfter) {
    return track.fit(0, Math.min(seenAfter, AFTER) - 1, after) && fitBefore(track, seenAfter);
  }

  /** The line along which this camera saw the ball come; the ball may have been hidden just before it came near. */
  private boolean fitBefore(BallTrack track, int first) {
    if (first >= track.size() || since - track.time(first) > HIDDEN) {
      return false;
    }
    int oldest = first;
    while (oldest + 1 < track.size()
        && oldest + 1 < first + BEFORE
        && track.time(oldest + 1) > kicked
        && track.time(first) - track.time(oldest + 1) < SPAN) {
      oldest++;
    }
    return oldest - first + 1 >= 3
        && track.time(first) > kicked
        && track.fit(first, oldest, before);
  }

  private boolean deflected(BallTrack track) {
    double now = track.lastTime();
    double speed = before.speed();
    double waited = now - since + 0.05;
    double missX = track.x(0) - before.x(now);
    double missY = track.y(0) - before.y(now);
    double loss = Math.min(SLIDING * waited, MOST_LOSS * speed);
    double missed = beyondBraking(missX, missY, 0.5 * loss * waited);
    double changed = beyondBraking(after.vx() - before.vx(), after.vy() - before.vy(), loss);
    return changed > Math.max(LEAST_CHANGE, SHARE * speed) && missed > LEAST_MISS;
  }

  /** How much of a difference remains if the ball may have slowed down by up to {@code allowance} along its path. */
  private double beyondBraking(double dx, double dy, double allowance) {
    double speed = before.speed();
    if (!(speed > 0.05)) {
      return Math.hypot(dx, dy);
    }
    double along = (dx * before.vx() + dy * before.vy()) / speed;
    double across = (dy * before.vx() - dx * before.vy()) / speed;
    double rest = along > 0 ? along : Math.min(0, along + allowance);
    return Math.hypot(rest, across);
  }
}
