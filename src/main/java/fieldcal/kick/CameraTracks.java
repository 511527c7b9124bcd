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
  /** A ball that was hidden for longer until it is recognised is another one, s. */
  private static final double FORGET = 0.6;

  /** A candidate that was not seen for longer is none: three frames at 20 Hz, s. */
  private static final double FORGET_CANDIDATE = 0.15;

  /** How far a ball that is not touched may be from the line through its last five detections, m: within four frames even one that slides or bounces bends less. */
  private static final double MOST_OFF_LINE = 0.05;

  /** The same by the noise of that line, in standard errors: sixteen thousand detections for one that is missed. */
  private static final double MOST_STANDARD_ERRORS = 4;

  /** A line through two detections says nothing of their noise; cameras scatter by up to 25 mm where a line is still taken to be one, of which an extrapolation makes this, m. */
  private static final double MOST_OFF_TWO_POINTS = 0.12;

  /** After more frames without it a ball has to be recognised again. */
  private static final int MOST_FRAMES_HIDDEN = 4;

  /** A candidate is seen at least in every third frame. */
  private static final int MOST_FRAMES_APART = 3;

  /** So many detections in a row make a ball; ten false balls in each frame of a camera that sees a quarter of the field are four in a row and on a line about once in twenty minutes. */
  private static final int FEWEST_OF_NEW_BALL = 4;

  /** So many in a row do so even if they scatter. */
  private static final int FEWEST_THAT_SCATTER = 8;

  /** So many, where a ball is expected. */
  private static final int FEWEST_OF_KNOWN_BALL = 3;

  /** A ball that is kicked and seen by a camera of the league moves on a line to within this over some frames (rms per axis), m. */
  private static final double MOST_SCATTER = 0.005;

  /** On a coarser grid no kick can be told from a step, m. */
  private static final double COARSEST_GRID = 0.1;

  /** No ball is faster: the rules allow 6.5 m/s, chips project faster, m/s. */
  private static final double MAX_SPEED = 10;

  /** And none is found again farther from where it was expected, m. */
  private static final double FARTHEST_FOUND_AGAIN = 0.45;

  /**
   * Largest number of candidates, and of tracks. Ten false balls in each frame, far more than bad lighting causes, leave some thirty candidates; more mean a broken vision or an attack, and the time for a frame must stay bounded.
   */
  private static final int MOST_TRACKS = 200;

  /** A detection that may continue a track; the distance is relative to the track's gate. */
  private record Pair(BallTrack track, BallDetection ball, double relative) {}

  /** A track, and the age of the oldest detection of the candidate that it gets. */
  private record Believed(BallTrack track, int oldest) {}

  private final int camera;
  private final List<BallTrack> tracks = new ArrayList<>();
  private final List<BallTrack> candidates = new ArrayList<>();
  private final List<BallDetection> offered = new ArrayList<>();
  private final List<Pair> pairs = new ArrayList<>();
  private final LineFit line = new LineFit();
  private final LineFit after = new LineFit();
  private double last = Double.NEGATIVE_INFINITY;
  private int frame;

  /** Least difference of two places reported one after the other, m: where positions are rounded, a ball moves in steps of it; else it soon is next to nothing. */
  private double resolution = COARSEST_GRID;

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
            frame - candidate.lastFrame() > MOST_FRAMES_APART
                || t - candidate.lastTime() > FORGET_CANDIDATE);
    List<BallTrack> continued = assignNearest(t, tracks);
    List<BallTrack> grown = assignNearest(t, candidates);
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

  /** One pair at a time, the nearest first; what is left stays offered. Returns the tracks that got a detection. */
  private List<BallTrack> assignNearest(double t, List<BallTrack> to) {
    pairs.clear();
    for (BallTrack track : to) {
      findPairs(t, track);
    }
    if (pairs.isEmpty()) {
      return List.of();
    }
    List<BallTrack> continued = new ArrayList<>();
    // Stable: among equals the older track and the earlier detection come first.
    pairs.sort(Comparator.comparingDouble(Pair::relative));
    Set<BallTrack> given = Collections.newSetFromMap(new IdentityHashMap<>());
    Set<BallDetection> taken = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Pair pair : pairs) {
      if (!given.contains(pair.track) && !taken.contains(pair.ball)) {
        given.add(pair.track);
        taken.add(pair.ball);
        add(pair.track, t, pair.ball);
        continued.add(pair.track);
      }
    }
    offered.removeIf(taken::contains);
    return continued;
  }

  /** A track with every detection that lies where it was heading. */
  private void findPairs(double t, BallTrack track) {
    if (frame - track.lastFrame() > MOST_FRAMES_HIDDEN) {
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
              ? MOST_OFF_TWO_POINTS + resolution
              : MOST_OFF_LINE
                  + resolution
                  + MOST_STANDARD_ERRORS * (line.rms() + ahead * line.velocityError());
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
    return 0.03 + resolution + Math.min(FARTHEST_FOUND_AGAIN, MAX_SPEED * ahead);
  }

  private void believe(BallTrack candidate, Consumer<BallTrack> follow) {
    Believed seen = recognise(candidate);
    if (seen == null) {
      int oldest =
          candidate.size() < FEWEST_THAT_SCATTER
              ? onLine(candidate, MOST_SCATTER + resolution)
              : candidate.size() - 1;
      if (oldest < FEWEST_OF_NEW_BALL - 1) {
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
    if (candidate.size() < FEWEST_OF_KNOWN_BALL) {
      return null;
    }
    Believed nearest = null;
    double best = 1;
    for (BallTrack track : tracks) {
      boolean hidden = candidate.time(FEWEST_OF_KNOWN_BALL - 1) > track.lastTime();
      if (hidden && heading(track)) {
        int oldest =
            onLine(
                candidate, Math.max(MOST_SCATTER + resolution, MOST_STANDARD_ERRORS * line.rms()));
        double relative =
            oldest < FEWEST_OF_KNOWN_BALL - 1
                ? Double.POSITIVE_INFINITY
                : relative(track, candidate, oldest);
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
        off / (MOST_OFF_LINE + resolution + MOST_STANDARD_ERRORS * scatter),
        Math.hypot(x, y) / kickable(hidden));
  }

  /** When there are too many, those with the fewest detections are forgotten, among equals the oldest: white spots come and go, a ball stays. */
  private static void forgetTooMany(List<BallTrack> of) {
    if (of.size() <= MOST_TRACKS) {
      return;
    }
    List<BallTrack> ranked = new ArrayList<>(of);
    ranked.sort(
        Comparator.comparingInt(BallTrack::total)
            .reversed()
            .thenComparing(Comparator.comparingDouble(BallTrack::lastTime).reversed()));
    Set<BallTrack> kept = Collections.newSetFromMap(new IdentityHashMap<>());
    kept.addAll(ranked.subList(0, MOST_TRACKS));
    of.removeIf(track -> !kept.contains(track));
  }

  private void add(BallTrack track, double t, BallDetection ball) {
    if (track.size() > 0) {
      finer(Math.abs(ball.x() - track.x(0)));
      finer(Math.abs(ball.y() - track.y(0)));
    }
    track.add(t, ball, frame);
  }

  /** Two places that a camera tells apart are farther apart than its resolution. */
  private void finer(double difference) {
    if (difference > 0) {
      resolution = Math.min(resolution, difference);
    }
  }
}
