package fieldcal.app.play;

import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** Notices when no camera sees the ball although frames come and no robot hides it: then it flies above their images, or beside them. Not thread-safe. */
final class FlightWatch {
  /** A ball that no camera sees for longer is out of their images, s: seven frames; vision loses a ball in an image for one or two. */
  private static final double OUT_OF_SIGHT = 0.1;

  /** Frames of all cameras together come more often, s; after a silence it is not known where the ball was. */
  private static final double SILENT = 0.05;

  /** A robot hides a ball from a camera that is nearer than this to its centre, m: the way that a robot 0.15 m high hides from a camera 4 m above and 5 m beside it, and its radius. */
  private static final double HIDES = 0.3;

  /** Older kicks are judged, s. */
  private static final double REMEMBERED = 60;

  /** No camera saw the ball between these times, s. */
  record Gap(double from, double to) {}

  private final Map<RobotId, double[]> robots = new HashMap<>();
  private final Deque<Gap> gaps = new ArrayDeque<>();
  private double newest = Double.NaN;
  private double seen = Double.NaN;
  private boolean hidden;

  void accept(VisionFrame frame) {
    double t = frame.captureTime();
    if (!(Math.abs(t - newest) < SILENT)) {
      seen = Double.NaN;
    }
    newest = t;
    for (RobotDetection robot : frame.robots()) {
      robots.put(robot.id(), new double[] {robot.x(), robot.y()});
    }
    frame.balls().stream()
        .max(Comparator.comparingDouble(BallDetection::confidence))
        .ifPresent(ball -> see(ball, t));
    while (!gaps.isEmpty() && gaps.getFirst().from() < t - REMEMBERED) {
      gaps.removeFirst();
    }
  }

  private void see(BallDetection ball, double t) {
    open().ifPresent(gaps::add);
    seen = Double.isNaN(seen) ? t : Math.max(seen, t);
    hidden =
        robots.values().stream()
            .anyMatch(r -> Math.hypot(r[0] - ball.x(), r[1] - ball.y()) < HIDES);
  }

  /** The gap that lasts. */
  private Optional<Gap> open() {
    boolean out = newest - seen > OUT_OF_SIGHT && !hidden;
    return out ? Optional.of(new Gap(seen, newest)) : Optional.empty();
  }

  /** The first time that no camera saw the ball, begun between two times, s. */
  Optional<Gap> between(double from, double to) {
    return gaps.stream()
        .filter(gap -> gap.from() > from && gap.from() < to)
        .findFirst()
        .or(() -> open().filter(gap -> gap.from() > from && gap.from() < to));
  }
}
