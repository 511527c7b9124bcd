package fieldcal.kick;

import fieldcal.vision.BallDetection;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/**
 * The tracks of one camera: gives every detection to the track it continues.
 *
 * <p>A track's gate is as wide as a ball can be kicked within the time since its last detection, so that a kick does not break it;
 * what is nearest to a prediction goes first.
 */
final class CameraTracks {
  private static final double FORGET_TENTATIVE = 0.15;
  private static final double FORGET = 0.6;

  /** No ball is faster: the rules allow 6.5 m/s, chips project faster, m/s. */
  private static final double MAX_SPEED = 10;

  private final int camera;
  private final List<BallTrack> tracks = new ArrayList<>();
  private final List<BallDetection> offered = new ArrayList<>();
  private final List<BallTrack> updated = new ArrayList<>();
  private final LineFit line = new LineFit();
  private double last = Double.NEGATIVE_INFINITY;

  CameraTracks(int camera) {
    this.camera = camera;
  }

  boolean inOrder(double t) {
    return t > last;
  }

  double lastTime() {
    return last;
  }

  List<BallTrack> tracks() {
    return tracks;
  }

  void clear() {
    tracks.clear();
  }

  void offer(BallDetection ball) {
    offered.add(ball);
  }

  /** Gives each offered detection to the track that it is nearest to, or to a new one; returns the tracks that got one. */
  List<BallTrack> associate(double t) {
    last = t;
    updated.clear();
    for (Iterator<BallTrack> it = tracks.iterator(); it.hasNext(); ) {
      BallTrack track = it.next();
      if (t - track.lastTime() > (track.total() < 4 ? FORGET_TENTATIVE : FORGET)) {
        it.remove();
      }
    }
    while (assignNearest(t)) {
      // One pair at a time, the nearest first: there are rarely more than two balls and a few
      // tracks.
    }
    for (BallDetection ball : offered) {
      BallTrack track = new BallTrack(camera);
      add(track, t, ball);
      tracks.add(track);
    }
    offered.clear();
    return updated;
  }

  private boolean assignNearest(double t) {
    BallTrack bestTrack = null;
    BallDetection bestBall = null;
    double nearest = 1;
    for (BallTrack track : tracks) {
      if (updated.contains(track)) {
        continue;
      }
      double dt = t - track.lastTime();
      double gate = 0.03 + Math.min(0.45, MAX_SPEED * dt);
      boolean predicted = track.size() > 2 && track.fitNewest(5, 0.1, line);
      double px = predicted ? line.x(t) : track.x(0);
      double py = predicted ? line.y(t) : track.y(0);
      for (BallDetection ball : offered) {
        double relative = Math.hypot(ball.x() - px, ball.y() - py) / gate;
        if (relative < nearest) {
          nearest = relative;
          bestTrack = track;
          bestBall = ball;
        }
      }
    }
    if (bestTrack == null) {
      return false;
    }
    add(bestTrack, t, bestBall);
    offered.remove(bestBall);
    return true;
  }

  private void add(BallTrack track, double t, BallDetection ball) {
    track.add(t, ball.x(), ball.y(), ball.pixelX(), ball.pixelY());
    updated.add(track);
  }
}
