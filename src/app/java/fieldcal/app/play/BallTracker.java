package fieldcal.app.play;

import fieldcal.play.PlayWorld.Ball;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Follows the ball over all cameras, well enough to drive robots by; what the fits need is taken from the detections themselves. The velocity comes from differences within each camera, so that
 * cameras that disagree do not make a resting ball move.
 */
final class BallTracker {
  private static final double WINDOW = 0.1;

  /** A slow ball is looked at for longer, s: a resting ball should be seen resting. */
  private static final double SLOW_WINDOW = 0.25;

  private static final double SLOW = 0.3;

  /** How far a detection may be from where the ball should be, m, and how much more per second. */
  private static final double GATE = 0.15;

  private static final double GATE_GROWTH = 9;
  private static final double GATE_MOST = 1.2;

  /** So many detections in a row near each other, where the ball was not looked for, are the ball when nothing else is. */
  private static final int ENOUGH_ELSEWHERE = 4;

  private final Map<Integer, Deque<Seen>> cameras = new HashMap<>();
  private double x;
  private double y;
  private double vx;
  private double vy;
  private double time = Double.NaN;
  private Seen elsewhere;
  private int elsewhereCount;

  private final CameraOffsets offsets;

  private record Seen(double t, double x, double y) {}

  BallTracker(CameraOffsets offsets) {
    this.offsets = offsets;
  }

  void accept(VisionFrame frame) {
    double t = frame.captureTime();
    BallDetection best = null;
    double bestDistance = gate(t);
    BallDetection other = null;
    for (BallDetection ball : frame.balls()) {
      double dt = Double.isNaN(time) ? 0 : Math.max(0, Math.min(0.3, t - time));
      double distance = Math.hypot(ball.x() - (x + dt * vx), ball.y() - (y + dt * vy));
      if (!Double.isNaN(time) && distance < bestDistance) {
        best = ball;
        bestDistance = distance;
      } else if (other == null || ball.confidence() > other.confidence()) {
        other = ball;
      }
    }
    if (best != null) {
      take(frame.cameraId(), new Seen(t, best.x(), best.y()));
    } else if (other != null) {
      consider(frame.cameraId(), new Seen(t, other.x(), other.y()));
    }
  }

  private double gate(double t) {
    double dt = Double.isNaN(time) ? 0 : Math.max(0, t - time);
    return Math.min(GATE_MOST, GATE + GATE_GROWTH * dt);
  }

  private void consider(int camera, Seen seen) {
    boolean near =
        elsewhere != null
            && Math.hypot(seen.x() - elsewhere.x(), seen.y() - elsewhere.y()) < 0.4
            && seen.t() - elsewhere.t() < 0.2;
    elsewhereCount = near ? elsewhereCount + 1 : 1;
    elsewhere = seen;
    boolean lost = Double.isNaN(time) || seen.t() - time > 0.08;
    if (elsewhereCount >= ENOUGH_ELSEWHERE && lost) {
      cameras.clear();
      elsewhereCount = 0;
      take(camera, seen);
    }
  }

  private void take(int camera, Seen seen) {
    if (seen.t() < time - SLOW_WINDOW) {
      // A computer of vision that stalled, or whose clock is behind: the other cameras know better.
      return;
    }
    Deque<Seen> ring = cameras.computeIfAbsent(camera, id -> new ArrayDeque<>());
    if (!ring.isEmpty() && seen.t() <= ring.getLast().t()) {
      return;
    }
    ring.addLast(seen);
    time = Double.isNaN(time) ? seen.t() : Math.max(time, seen.t());
    while (ring.getFirst().t() < time - SLOW_WINDOW) {
      ring.removeFirst();
    }
    estimate(WINDOW);
    if (Math.hypot(vx, vy) < SLOW) {
      estimate(SLOW_WINDOW);
    }
  }

  /** Slope within each camera, pooled; position is the mean of what the cameras that see it now say, less their offsets. */
  private void estimate(double window) {
    double stt = 0;
    double stx = 0;
    double sty = 0;
    for (Deque<Seen> ring : cameras.values()) {
      double[] mean = mean(ring, time - window);
      for (Seen s : ring) {
        if (s.t() >= time - window) {
          double dt = s.t() - mean[0];
          stt += dt * dt;
          stx += dt * (s.x() - mean[1]);
          sty += dt * (s.y() - mean[2]);
        }
      }
    }
    vx = stt > 1e-5 ? stx / stt : 0;
    vy = stt > 1e-5 ? sty / stt : 0;
    double sumX = 0;
    double sumY = 0;
    int n = 0;
    for (Map.Entry<Integer, Deque<Seen>> camera : cameras.entrySet()) {
      Deque<Seen> ring = camera.getValue();
      double[] mean = mean(ring, time - window);
      if (mean[3] > 0 && time - ring.getLast().t() < 0.06) {
        sumX += mean[1] + vx * (time - mean[0]) - offsets.x(camera.getKey());
        sumY += mean[2] + vy * (time - mean[0]) - offsets.y(camera.getKey());
        n++;
      }
    }
    if (n > 0) {
      x = sumX / n;
      y = sumY / n;
    }
  }

  private static double[] mean(Deque<Seen> ring, double from) {
    double[] mean = new double[4];
    for (Seen s : ring) {
      if (s.t() >= from) {
        mean[0] += s.t();
        mean[1] += s.x();
        mean[2] += s.y();
        mean[3]++;
      }
    }
    for (int i = 0; i < 3 && mean[3] > 0; i++) {
      mean[i] /= mean[3];
    }
    return mean;
  }

  Optional<Ball> ball(double now) {
    if (Double.isNaN(time)) {
      return Optional.empty();
    }
    double ahead = Math.max(0, Math.min(0.05, now - time));
    return Optional.of(new Ball(x + ahead * vx, y + ahead * vy, vx, vy, time));
  }
}
