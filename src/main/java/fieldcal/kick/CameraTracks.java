package fieldcal.kick;

import fieldcal.vision.BallDetection;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/**
 * The tracks of one camera: gives every detection to the ball it belongs to.
 *
 * <p>A detection that lies where its track was heading continues it. Any other one may be the same ball, kicked or seen again after it
 * was hidden, or a white spot: it begins a candidate, and only when that was seen several times in a row, on a line, does it continue
 * the track that a kick could have brought there, with all its detections, or become a track of its own. So nothing of a kicked ball is lost, and single false
 * balls never come into the path of a real one.
 */
final class CameraTracks {
  /** A ball that is hidden for longer, until it is recognised, is another one, s. */
  private static final double FORGET = 0.6;

  /** The same for a candidate: three frames at 20 Hz, s. */
  private static final double FORGET_CANDIDATE = 0.15;

  /** How far a ball that is not touched may be from the line through its last five detections, m: within four frames even one that slides or bounces bends less. */
  private static final double NEAR = 0.05;

  /** The same by the noise of that line, in standard errors: sixteen thousand detections for one that is missed. */
  private static final double SCATTER = 4;

  /** A line through two detections says nothing of their noise; cameras scatter by up to 25 mm where a line is still taken to be one, of which an extrapolation makes this, m. */
  private static final double NEAR_TWO = 0.12;

  /** After more frames without it a ball has to be recognised again. */
  private static final int HIDDEN = 4;

  /** A candidate must be seen in every third frame: a third of the detections may be missing. */
  private static final int SKIPPED = 3;

  /** So many detections in a row make a ball; ten false balls in each frame of a camera that sees a quarter of the field are four in a row and on a line about once in twenty minutes. */
  private static final int BELIEVED = 4;

  /** So many in a row do so even if they scatter. */
  private static final int CERTAIN = 8;

  /** So many, where a ball is expected. */
  private static final int RECOGNISED = 3;

  /** A ball that is kicked and seen by a camera of the league moves on a line to within this over some frames (rms per axis), m. */
  private static final double SMOOTH = 0.005;

  /** On a coarser grid no kick can be told from a step, m. */
  private static final double COARSEST = 0.1;

  /** No ball is faster: the rules allow 6.5 m/s, chips project faster, m/s. */
  private static final double MAX_SPEED = 10;

  /** And none is found again farther from where it was expected, m. */
  private static final double FARTHEST = 0.45;

  /**
   * Largest number of candidates, and of tracks. Ten false balls in each frame, far more than bad lighting causes, leave some thirty candidates; more mean a broken vision or an attack, and the time for a frame must stay bounded.
   */
  private static final int MOST = 200;

  /** A detection that may continue a track; the distance is relative to the track's gate. */
  private record Pair(BallTrack track, BallDetection ball, double relative) {}

  /** A track, and the age of the oldest detection of the candidate that it gets. */
  private record Believed(BallTrack track, int oldest) {}

  private final int camera;
  private final List<BallTrack> tracks = new ArrayList<>();
  private final List<BallTrack> candidates = new ArrayList<>();
  private final List<BallDetection> offered = new ArrayList<>();
  private final List<BallTrack> updated = new ArrayList<>();
  private final List<Pair> pairs = new ArrayList<>();
  private final LineFit line = new LineFit();
  private final LineFit after = new LineFit();
  private double last = Double.NEGATIVE_INFINITY;
  private int frame;

  /** Least difference of two places reported one after the other, m: where positions are rounded, a ball moves in steps of it; else it soon is next to nothing. */
  private double resolution = COARSEST;

  CameraTracks(int camera) {
    this.camera = camera;
  }

  boolean inOrder(double t) {
    return t > last;
  }

  double lastTime() {
    return last;
  }

  /** The balls that are believed. */
  List<BallTrack> tracks() {
    return tracks;
  }

  void clear() {
    tracks.clear();
    candidates.clear();
  }

  void offer(BallDetection ball) {
    offered.add(ball);
  }

  /**
   * Gives each offered detection to the track that it is nearest to, or to a candidate.
   *
   * @param t time of the frame, s
   * @param follow is called for each detection that a track got, with the track, as soon as the detection is its newest one: several times for a ball that was recognised
   */
  void associate(double t, Consumer<BallTrack> follow) {
    last = t;
    frame++;
    tracks.removeIf(track -> t - track.lastTime() > FORGET);
    candidates.removeIf(
        candidate ->
            frame - candidate.lastFrame() > SKIPPED || t - candidate.lastTime() > FORGET_CANDIDATE);
    updated.clear();
    assignNearest(t, tracks);
    List<BallTrack> continued = List.copyOf(updated);
    updated.clear();
    assignNearest(t, candidates);
    List<BallTrack> grown = List.copyOf(updated);
    for (BallDetection ball : offered) {
      BallTrack candidate = new BallTrack(camera);
      add(candidate, t, ball);
      candidates.add(candidate);
    }
    offered.clear();
    forgetTooMany(candidates);
    continued.forEach(follow);
    grown.forEach(candidate -> believe(candidate, follow));
    forgetTooMany(tracks);
  }

  /** One pair at a time, the nearest first; what is left stays offered. */
  private void assignNearest(double t, List<BallTrack> to) {
    pairs.clear();
    for (BallTrack track : to) {
      findPairs(t, track);
    }
    if (pairs.isEmpty()) {
      return;
    }
    // Stable: among equals the older track and the earlier detection come first.
    pairs.sort(Comparator.comparingDouble(Pair::relative));
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

  /** A track with every detection that lies where it was heading. */
  private void findPairs(double t, BallTrack track) {
    if (frame - track.lastFrame() > HIDDEN) {
      return;
    }
    double ahead = t - track.lastTime();
    boolean predicted = heading(track);
    double gate = kickable(ahead);
    double px = predicted ? line.x(t) : track.x(0);
    double py = predicted ? line.y(t) : track.y(0);
    if (predicted) {
      double calm =
          line.count() == 2
              ? NEAR_TWO + resolution
              : NEAR + resolution + SCATTER * (line.rms() + ahead * line.velocityError());
      gate = Math.min(gate, calm);
    }
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

  /** The line on which a ball was seen last; false when it was seen only once. */
  private boolean heading(BallTrack track) {
    return track.size() > 1 && (track.fitNewest(5, 0.1, line) || track.fit(0, 1, line));
  }

  /** How far a ball may be from where it was heading, after a time in which it may have been kicked, m. */
  private double kickable(double ahead) {
    return 0.03 + resolution + Math.min(FARTHEST, MAX_SPEED * ahead);
  }

  private void believe(BallTrack candidate, Consumer<BallTrack> follow) {
    Believed seen = recognise(candidate);
    if (seen == null) {
      int oldest =
          candidate.size() < CERTAIN
              ? onLine(candidate, SMOOTH + resolution)
              : candidate.size() - 1;
      if (oldest < BELIEVED - 1) {
        return;
      }
      seen = new Believed(new BallTrack(camera), oldest);
      tracks.add(seen.track);
    }
    candidates.remove(candidate);
    for (int age = seen.oldest; age >= 0; age--) {
      seen.track.add(candidate, age, frame);
      follow.accept(seen.track);
    }
  }

  /** Age of the oldest detection from which on a candidate moves on a line; what was seen before was something else. */
  private int onLine(BallTrack candidate, double smooth) {
    int oldest = candidate.size() - 1;
    while (oldest > 0 && !(candidate.fit(0, oldest, after) && after.rms() < smooth)) {
      oldest--;
    }
    return oldest;
  }

  /** The track that a candidate continues, the nearest one; null when there is none. */
  private Believed recognise(BallTrack candidate) {
    if (candidate.size() < RECOGNISED) {
      return null;
    }
    Believed nearest = null;
    double best = 1;
    for (BallTrack track : tracks) {
      boolean hidden = candidate.time(RECOGNISED - 1) > track.lastTime();
      if (hidden && heading(track)) {
        int oldest = onLine(candidate, Math.max(SMOOTH + resolution, SCATTER * line.rms()));
        double relative =
            oldest < RECOGNISED - 1 ? Double.POSITIVE_INFINITY : relative(track, candidate, oldest);
        if (relative < best) {
          best = relative;
          nearest = new Believed(track, oldest);
        }
      }
    }
    return nearest;
  }

  /**
   * How far a detection of the candidate is from where the track's ball may be, relative to how exactly that is known. A ball that goes at one velocity until it is kicked, stopped or deflected, and at another from then on, is between the places
   * where either velocity alone would have brought it.
   */
  private double relative(BallTrack track, BallTrack candidate, int oldest) {
    double t = candidate.time(oldest);
    double hidden = t - track.lastTime();
    if (!(hidden > 0)) {
      return Double.POSITIVE_INFINITY;
    }
    double x = candidate.x(oldest) - line.x(t);
    double y = candidate.y(oldest) - line.y(t);
    double changedX = (after.vx() - line.vx()) * hidden;
    double changedY = (after.vy() - line.vy()) * hidden;
    double square = changedX * changedX + changedY * changedY;
    double share = square > 0 ? (x * changedX + y * changedY) / square : 0;
    double s = Math.max(0, Math.min(1, share));
    double off = Math.hypot(x - s * changedX, y - s * changedY);
    double velocityError = Math.hypot(line.velocityError(), after.velocityError());
    double scatter = Math.hypot(line.rms(), hidden * velocityError);
    return Math.max(
        off / (NEAR + resolution + SCATTER * scatter), Math.hypot(x, y) / kickable(hidden));
  }

  /** When there are too many, those with the fewest detections are forgotten, among equals the oldest: white spots come and go, a ball stays. */
  private static void forgetTooMany(List<BallTrack> of) {
    if (of.size() <= MOST) {
      return;
    }
    List<BallTrack> ranked = new ArrayList<>(of);
    ranked.sort(
        Comparator.comparingInt(BallTrack::total)
            .reversed()
            .thenComparing(Comparator.comparingDouble(BallTrack::lastTime).reversed()));
    Set<BallTrack> kept = Collections.newSetFromMap(new IdentityHashMap<>());
    kept.addAll(ranked.subList(0, MOST));
    of.removeIf(track -> !kept.contains(track));
  }

  private void add(BallTrack track, double t, BallDetection ball) {
    if (track.size() > 0) {
      finer(Math.abs(ball.x() - track.x(0)));
      finer(Math.abs(ball.y() - track.y(0)));
    }
    track.add(t, ball, frame);
    updated.add(track);
  }

  /** Two places that a camera tells apart are farther apart than its resolution. */
  private void finer(double difference) {
    if (difference > 0) {
      resolution = Math.min(resolution, difference);
    }
  }
}
