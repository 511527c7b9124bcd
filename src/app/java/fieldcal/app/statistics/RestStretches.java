package fieldcal.app.statistics;

import fieldcal.kick.Kick;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** What cameras report of the ball while it waits to be kicked. */
public final class RestStretches {
  /** How far from the kick's place a detection of the waiting ball may lie, m: cameras disagree by up to 40 mm, and that is above. */
  private static final double NEAR = 0.06;

  /** How long before the kick a stretch ends, s: the finder's time of a kick may be late by that. */
  private static final double BEFORE = 0.03;

  /** Longest stretch, s: before, the ball may still have been carried or pushed to its place. */
  private static final double LONGEST = 0.7;

  /** Fewest detections of a stretch. */
  private static final int FEWEST = 8;

  /** A camera that sees the ball in fewer frames does not see it from its place, or only at the edge. */
  private static final double SEEN = 0.5;

  private RestStretches() {}

  /**
   * One camera's reports of the ball before one kick.
   *
   * @param kick number of the kick
   * @param camera the camera
   * @param x mean of what it reports, m
   * @param y mean, m
   * @param sigma standard deviation per axis, m
   * @param detections how many
   * @param frames how many frames it sent meanwhile
   */
  public record Stretch(
      int kick, int camera, double x, double y, double sigma, int detections, int frames) {}

  /**
   * The stretches of a recording.
   *
   * @param frames of the recording
   * @param kicks of the recording
   * @return one for each kick and each camera that sees it
   */
  public static List<Stretch> of(RecordedFrames frames, List<Kick> kicks) {
    List<Stretch> all = new ArrayList<>();
    for (Kick kick : kicks) {
      OptionalDouble since = frames.restingSince(kick.time(), kick.x(), kick.y());
      if (!kick.fromRest() || since.isEmpty()) {
        continue;
      }
      for (Map.Entry<Integer, List<VisionFrame>> camera : frames.frames().entrySet()) {
        double from = Math.max(since.getAsDouble(), kick.time() - BEFORE - LONGEST);
        one(kick, camera.getKey(), camera.getValue(), from).ifPresent(all::add);
      }
    }
    return all;
  }

  /** The detection of a frame that lies near a place. */
  static Optional<BallDetection> near(VisionFrame frame, double x, double y) {
    for (BallDetection ball : frame.balls()) {
      if (Math.hypot(ball.x() - x, ball.y() - y) < NEAR) {
        return Optional.of(ball);
      }
    }
    return Optional.empty();
  }

  private static Optional<Stretch> one(
      Kick kick, int camera, List<VisionFrame> frames, double since) {
    int sent = 0;
    int n = 0;
    double sumX = 0;
    double sumY = 0;
    double squares = 0;
    for (VisionFrame frame : frames) {
      if (frame.captureTime() < since || frame.captureTime() > kick.time() - BEFORE) {
        continue;
      }
      sent++;
      Optional<BallDetection> ball = near(frame, kick.x(), kick.y());
      if (ball.isPresent()) {
        double x = ball.get().x() - kick.x();
        double y = ball.get().y() - kick.y();
        n++;
        sumX += x;
        sumY += y;
        squares += x * x + y * y;
      }
    }
    if (n < FEWEST || n < SEEN * sent) {
      return Optional.empty();
    }
    double about = squares - (sumX * sumX + sumY * sumY) / n;
    return Optional.of(
        new Stretch(
            kick.id(),
            camera,
            kick.x() + sumX / n,
            kick.y() + sumY / n,
            Math.sqrt(Math.max(0, about) / (2.0 * (n - 1))),
            n,
            sent));
  }
}
