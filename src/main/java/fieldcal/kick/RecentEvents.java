package fieldcal.kick;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/** What happened to the ball a moment ago, so that it is not reported again when another camera shows it later. */
final class RecentEvents {
  /** Two cameras see the same kick within this time and the distance below, s and m. */
  private static final double SAME_TIME = 0.12;

  private static final double SAME_PLACE = 0.35;

  /** Number of kicks and deflections remembered; no more happen within {@link #SAME_TIME}. */
  private static final int REMEMBERED = 4;

  /** Longest time for which a ball that bounces off a robot is hidden by it, s; after a longer time the robot held it and then kicked it. */
  private static final double HIDDEN = 0.2;

  /** Longest time after a deflection until its ball comes into view again, s. */
  private static final double LONG_HIDDEN = 0.6;

  /** A ball that a robot stops reappears within this distance of where it was seen last, m. */
  static final double SAME_BALL = 0.5;

  private final Deque<ActiveKick> ended = new ArrayDeque<>();
  private final Deque<JumpDetector.Jump> deflected = new ArrayDeque<>();
  private double lastEnd = Double.NEGATIVE_INFINITY;
  private double lastEndX;
  private double lastEndY;

  void clear() {
    ended.clear();
    deflected.clear();
    lastEnd = Double.NEGATIVE_INFINITY;
  }

  void ended(ActiveKick kick) {
    remember(ended, kick);
    lastEnd = kick.lastTime();
    lastEndX = kick.newest().x(0);
    lastEndY = kick.newest().y(0);
  }

  void deflected(JumpDetector.Jump jump) {
    remember(deflected, jump);
  }

  private static <T> void remember(Deque<T> those, T newest) {
    those.addFirst(newest);
    if (those.size() > REMEMBERED) {
      those.removeLast();
    }
  }

  /** The kick that another camera showed already; null when there is none. */
  ActiveKick sameKick(Iterable<ActiveKick> kicks, JumpDetector.Jump jump, BallTrack track) {
    for (ActiveKick kick : kicks) {
      // A track that has already shown a kick can only show a new one.
      if (kick.source() != track && same(kick.jump(), jump)) {
        return kick;
      }
    }
    return null;
  }

  /** Whether the jump is no new event: another camera has shown this kick and its ball was already stopped, or it is an earlier deflection as another camera, or a window that straddles it, shows it. */
  boolean isOver(JumpDetector.Jump jump, BallTrack track) {
    if (sameKick(ended, jump, track) != null) {
      return true;
    }
    for (JumpDetector.Jump known : deflected) {
      if ((same(known, jump) || jump.born() && leadsTo(known, jump))
          && jump.speed() < known.speed() + KickerSearch.LEAST_GAIN) {
        return true;
      }
    }
    return false;
  }

  /** Whether a ball that comes into view was already heading there after a known jump. */
  private static boolean leadsTo(JumpDetector.Jump known, JumpDetector.Jump jump) {
    double dt = jump.time() - known.time();
    double off =
        Math.hypot(known.x() + known.vx() * dt - jump.x(), known.y() + known.vy() * dt - jump.y());
    return dt > 0 && dt < LONG_HIDDEN && off < 0.1 + 0.3 * known.speed() * dt;
  }

  private static boolean same(JumpDetector.Jump known, JumpDetector.Jump jump) {
    return Math.abs(known.time() - jump.time()) < SAME_TIME
        && Math.hypot(known.x() - jump.x(), known.y() - jump.y()) < SAME_PLACE;
  }

  /**
   * Speed before a jump, m/s. A track that begins with a moving ball does not show it. Then it is the speed of a kick whose ball was about to pass here, 0 without one; infinite when the ball of a kick just ended here, since this is that ball, seen again after the robot that stopped it had hidden it.
   */
  double speedBefore(JumpDetector.Jump jump, List<ActiveKick> active) {
    if (!jump.born()) {
      return jump.speedBefore();
    }
    double fastest = 0;
    for (ActiveKick kick : active) {
      fastest = Math.max(fastest, kick.speedNear(jump.time(), jump.x(), jump.y()));
    }
    boolean justEnded =
        jump.time() - lastEnd < HIDDEN
            && Math.hypot(jump.x() - lastEndX, jump.y() - lastEndY) < SAME_BALL;
    return justEnded ? Double.POSITIVE_INFINITY : fastest;
  }
}
