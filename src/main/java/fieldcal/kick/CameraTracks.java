package fieldcal.kick;

import fieldcal.vision.BallDetection;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Set;

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

  /**
   * Largest number of tracks that are followed at once. Ten false balls in each frame, far more than bad lighting causes, leave some hundred tracks; more mean a broken vision or an attack, and the time for a frame must stay bounded.
   */
  private static final int MOST_TRACKS = 200;

  /** A detection that may continue a track; the distance is relative to the track's gate. */
  private record Pair(BallTrack track, BallDetection ball, double relative) {}

  private final int camera;
  private final List<BallTrack> tracks = new ArrayList<>();
  private final List<BallDetection> offered = new ArrayList<>();
  private final List<BallTrack> updated = new ArrayList<>();
  private final List<Pair> pairs = new ArrayList<>();
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
      if (t - track.lastTime() > (isTentative(track) ? FORGET_TENTATIVE : FORGET)) {
        it.remove();
      }
    }
    findPairs(t);
    assignNearest(t);
    for (BallDetection ball : offered) {
      BallTrack track = new BallTrack(camera);
      add(track, t, ball);
      tracks.add(track);
    }
    offered.clear();
    forgetTooMany();
    return updated;
  }

  private static boolean isTentative(BallTrack track) {
    return track.total() < 4;
  }

  /** Every track with every detection within its gate. */
  private void findPairs(double t) {
    pairs.clear();
    for (BallTrack track : tracks) {
      double dt = t - track.lastTime();
      double gate = 0.03 + Math.min(0.45, MAX_SPEED * dt);
      boolean predicted = track.size() > 2 && track.fitNewest(5, 0.1, line);
      double px = predicted ? line.x(t) : track.x(0);
      double py = predicted ? line.y(t) : track.y(0);
      for (BallDetection ball : offered) {
        double dx = Math.abs(ball.x() - px);
        double dy = Math.abs(ball.y() - py);
        if (dx < gate && dy < gate) {
          double relative = Math.hypot(dx, dy) / gate;
          if (relative < 1) {
            pairs.add(new Pair(track, ball, relative));
          }
        }
      }
    }
    // Stable: among equals the older track and the earlier detection come first.
    pairs.sort(Comparator.comparingDouble(Pair::relative));
  }

  /** One pair at a time, the nearest first; what is left is offered to new tracks. */
  private void assignNearest(double t) {
    if (pairs.isEmpty()) {
      return;
    }
    Set<BallTrack> given = Collections.newSetFromMap(new IdentityHashMap<>());
    Set<BallDetection> taken = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Pair pair : pairs) {
      if (!given.contains(pair.track) && !taken.contains(pair.ball)) {
        given.add(pair.track);
        taken.add(pair.ball);
        add(pair.track, t, pair.ball);
      }
    }
    offered.removeIf(taken::contains);
  }

  /** When there are too many, those with the fewest detections are forgotten, among equals the oldest: white spots come and go, a ball stays. */
  private void forgetTooMany() {
    if (tracks.size() <= MOST_TRACKS) {
      return;
    }
    List<BallTrack> ranked = new ArrayList<>(tracks);
    ranked.sort(
        Comparator.comparingInt(BallTrack::total)
            .reversed()
            .thenComparing(Comparator.comparingDouble(BallTrack::lastTime).reversed()));
    Set<BallTrack> kept = Collections.newSetFromMap(new IdentityHashMap<>());
    kept.addAll(ranked.subList(0, MOST_TRACKS));
    tracks.removeIf(track -> !kept.contains(track));
    updated.removeIf(track -> !kept.contains(track));
  }

  private void add(BallTrack track, double t, BallDetection ball) {
    track.add(t, ball.x(), ball.y(), ball.pixelX(), ball.pixelY());
    updated.add(track);
  }
}
