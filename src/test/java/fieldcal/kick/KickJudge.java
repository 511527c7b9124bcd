package fieldcal.kick;

import fieldcal.camera.Camera;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.truth.BallHold;
import fieldcal.simulation.truth.EndReason;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.KickTruth.Vector3;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Compares the kicks that were found in simulated matches with those that there were.
 *
 * <p>A kick counts when a robot kicked (the truth's kinds flat and chip; what bounces off a robot is a deflection and no kick), its ball went {@value #LEAST_WAY} m, and the cameras together reported that ball
 * {@value #LEAST_SEEN} times on its way, first within {@value #LATEST_SEEN} m of the kick: of less nothing can be learnt, and a ball that comes into view is none that was kicked there. Finding one that does not count is neither right nor wrong. Everything else that is found is invented, deflections included.
 *
 * <p>Ends are judged by what the finder calls them: a ball has left when it is over a line, not 0.25 m behind it as in the truth; a ball that somebody takes away by hand has no right end and is not
 * counted; a ball that no camera saw when its flight ended may also be called lost.
 */
final class KickJudge {
  static final double LEAST_WAY = 0.3;
  static final int LEAST_SEEN = 10;
  static final double LATEST_SEEN = 0.5;

  /** A ball may be hidden by its kicker at first. */
  private static final double SAME_TIME = 0.1;

  private static final double SAME_PLACE = 0.7;

  /** Nobody can say how a flight ended whose ball was not seen for so long before. */
  private static final double UNSEEN = 0.3;

  private final Map<String, Integer> ends = new TreeMap<>();
  private final List<String> cases = new ArrayList<>();
  private final List<Pair> pairs = new ArrayList<>();
  private int counted;
  private int found;
  private int extra;
  private int invented;
  private int deflections;
  private int judgedEnds;
  private int rightEnds;
  private int contaminated;
  private int cutShort;
  private int rightRobot;
  private int fromRest;
  private final int[] dribbled = new int[4];

  /** A kick of the truth and what was found of it. */
  record Pair(KickTruth truth, Kick kick) {}

  private record Seen(int count, double first, double last) {
    boolean enough(KickTruth t) {
      return count >= LEAST_SEEN && wayUntil(t, first) < LATEST_SEEN && way(t) >= LEAST_WAY;
    }
  }

  int counted() {
    return counted;
  }

  int found() {
    return found;
  }

  int invented() {
    return invented;
  }

  int judgedEnds() {
    return judgedEnds;
  }

  int rightEnds() {
    return rightEnds;
  }

  /** What went wrong, one line each. */
  List<String> cases() {
    return cases;
  }

  /** The kicks that were found, of all matches. */
  List<Pair> pairs() {
    return pairs;
  }

  /** Kicks that are flagged as after dribbling exactly when they are. */
  int rightlyFlagged() {
    return dribbled[0] + dribbled[3];
  }

  /**
   * Plays a match, finds its kicks and adds them.
   *
   * @return how long the finding took, s
   */
  double judge(DrawnMatch match) {
    SimulatedRecording recording = match.record();
    List<VisionFrame> frames = match.frames(recording);
    Map<Integer, Camera> cameras =
        recording.geometry().cameras().stream()
            .map(Camera::of)
            .collect(Collectors.toMap(Camera::id, c -> c));
    List<Kick> kicks = new ArrayList<>();
    long before = System.nanoTime();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    finder.geometry(recording.geometry(), cameras);
    frames.forEach(finder::accept);
    finder.finish();
    double seconds = 1e-9 * (System.nanoTime() - before);
    judge(
        "seed " + match.settings().seed(),
        match.settings().field(),
        frames,
        cameras,
        recording.truth().kicks(),
        recording.truth().holds(),
        kicks);
    return seconds;
  }

  /** Adds one match. */
  void judge(
      String name,
      FieldSize field,
      List<VisionFrame> frames,
      Map<Integer, Camera> cameras,
      List<KickTruth> truth,
      List<BallHold> holds,
      List<Kick> kicks) {
    List<Kick> left = new ArrayList<>(kicks);
    for (KickTruth t : truth) {
      if (t.kind() == fieldcal.simulation.truth.KickKind.DEFLECTION) {
        continue;
      }
      Kick kick = match(t, left);
      left.remove(kick);
      Seen seen = seen(t, frames, cameras);
      if (!seen.enough(t)) {
        extra += kick == null ? 0 : 1;
        continue;
      }
      counted++;
      if (kick == null) {
        cases.add(name + " missed: " + describe(t) + ", seen " + seen.count());
        continue;
      }
      found++;
      pairs.add(new Pair(t, kick));
      judgeFound(name, field, t, kick, seen, holds);
    }
    left.forEach(kick -> judgeInvented(name, kick, truth, holds));
  }

  private static Kick match(KickTruth t, List<Kick> kicks) {
    return kicks.stream()
        .filter(k -> Math.abs(k.time() - t.time()) < SAME_TIME)
        .filter(k -> Math.hypot(k.x() - t.position().x(), k.y() - t.position().y()) < SAME_PLACE)
        .min(Comparator.comparingDouble(k -> Math.abs(k.time() - t.time())))
        .orElse(null);
  }

  private void judgeFound(
      String name, FieldSize field, KickTruth t, Kick kick, Seen seen, List<BallHold> holds) {
    boolean held =
        holds.stream()
            .anyMatch(
                h ->
                    h.robot().equals(t.robot())
                        && Math.abs(h.to() - t.time()) < 0.02
                        && h.to() - h.from() > 0.1);
    dribbled[(held ? 2 : 0) + (kick.afterDribbling() ? 1 : 0)]++;
    if (held != kick.afterDribbling()) {
      cases.add(
          name + " dribbling " + held + " called " + kick.afterDribbling() + ": " + describe(t));
    }
    rightRobot += kick.robot().filter(t.robot()::equals).isPresent() ? 1 : 0;
    fromRest += kick.fromRest() ? 1 : 0;
    double endTime = t.time() + t.duration();
    Set<KickEnd> right = right(t, field, seen);
    boolean early = kick.endTime() < Math.min(endTime, seen.last()) - 0.4;
    boolean late = kick.endTime() > endTime + 0.03 && !right.contains(KickEnd.STOPPED);
    if (right.size() < KickEnd.values().length) {
      judgedEnds++;
      rightEnds += right.contains(kick.end()) && !early ? 1 : 0;
      String what = t.end().label() + " is called " + kick.end().id() + (early ? " early" : "");
      ends.merge(what, 1, Integer::sum);
      if (!right.contains(kick.end()) || early) {
        cases.add(
            name
                + " end: "
                + what
                + ": "
                + describe(t)
                + at(", called so at %.3f", kick.endTime()));
      }
    }
    cutShort += early ? 1 : 0;
    contaminated += late ? 1 : 0;
    if (late) {
      cases.add(
          name
              + " late end: "
              + kick.end().id()
              + " "
              + describe(t)
              + at(" ends %.3f", kick.endTime()));
    }
  }

  private void judgeInvented(String name, Kick kick, List<KickTruth> truth, List<BallHold> holds) {
    invented++;
    String why = "nothing there";
    for (KickTruth t : truth) {
      if (Math.abs(t.time() - kick.time()) < SAME_TIME) {
        why = describe(t);
        deflections += t.kind() == fieldcal.simulation.truth.KickKind.DEFLECTION ? 1 : 0;
        break;
      }
      if (t.time() < kick.time() && t.time() + t.duration() > kick.time()) {
        why = "during " + describe(t);
      }
    }
    for (BallHold h : holds) {
      if (kick.time() > h.from() - 0.05 && kick.time() < h.to() + 0.05) {
        why += at(", held from %.3f", h.from()) + at(" to %.3f by ", h.to()) + h.robot();
      }
    }
    cases.add(
        name
            + String.format(
                Locale.ROOT,
                " invented: %.3f at %.2f %.2f, %.2f m/s by %s, from rest %b, ends %s %.3f: %s",
                kick.time(),
                kick.x(),
                kick.y(),
                Math.hypot(kick.vx(), kick.vy()),
                kick.robot().map(Object::toString).orElse("nobody"),
                kick.fromRest(),
                kick.end().id(),
                kick.endTime(),
                why));
  }

  private static String at(String format, double time) {
    return String.format(Locale.ROOT, format, time);
  }

  private static String describe(KickTruth t) {
    return String.format(
        Locale.ROOT,
        "%s %s at %.3f from %.2f %.2f by %s with %.2f m/s, %.2f s, %.2f m, %s%s",
        t.kind().label(),
        t.purpose(),
        t.time(),
        t.position().x(),
        t.position().y(),
        t.robot(),
        t.velocity().norm(),
        t.duration(),
        way(t),
        t.end().label(),
        t.endRobot().map(r -> " by " + r).orElse(""));
  }

  private static double way(KickTruth t) {
    return wayUntil(t, Double.POSITIVE_INFINITY);
  }

  private static double wayUntil(KickTruth t, double time) {
    double most = 0;
    for (int i = 0; i < t.path().size() && t.time() + i * KickTruth.PATH_STEP <= time; i++) {
      Vector3 p = t.path().get(i);
      most = Math.max(most, Math.hypot(p.x() - t.position().x(), p.y() - t.position().y()));
    }
    return most;
  }

  private static Seen seen(KickTruth t, List<VisionFrame> frames, Map<Integer, Camera> cameras) {
    int count = 0;
    double first = Double.POSITIVE_INFINITY;
    double last = Double.NEGATIVE_INFINITY;
    double[] ground = new double[2];
    for (VisionFrame frame : frames) {
      int i = (int) Math.floor((frame.captureTime() - t.time()) / KickTruth.PATH_STEP + 0.5);
      if (i < 0 || i >= t.path().size()) {
        continue;
      }
      Vector3 p = t.path().get(i);
      cameras.get(frame.cameraId()).projectToGround(p.x(), p.y(), p.z(), ground);
      for (BallDetection ball : frame.balls()) {
        if (Math.hypot(ball.x() - ground[0], ball.y() - ground[1]) < 0.1) {
          count++;
          first = Math.min(first, frame.captureTime());
          last = Math.max(last, frame.captureTime());
          break;
        }
      }
    }
    return new Seen(count, first, last);
  }

  private static Set<KickEnd> right(KickTruth t, FieldSize field, Seen seen) {
    if (t.end() == EndReason.PLACED) {
      return EnumSet.allOf(KickEnd.class);
    }
    Set<KickEnd> right =
        switch (t.end()) {
          case STOPPED, PLACED -> EnumSet.of(KickEnd.STOPPED);
          case LEFT_FIELD, GOAL -> EnumSet.of(KickEnd.LEFT_FIELD);
          case TOUCHED_ROBOT, REDIRECTED -> EnumSet.of(KickEnd.TOUCHED_ROBOT);
          case RECORDING_ENDED -> EnumSet.of(KickEnd.RECORDING_ENDED);
        };
    double out = Double.NEGATIVE_INFINITY;
    for (Vector3 p : t.path()) {
      double beyond =
          Math.max(Math.abs(p.x()) - field.length() / 2, Math.abs(p.y()) - field.width() / 2);
      out = Math.max(out, beyond);
    }
    if (out > 0.1) {
      right = EnumSet.of(KickEnd.LEFT_FIELD);
    } else if (out > 0) {
      right.add(KickEnd.LEFT_FIELD);
    }
    if (t.time() + t.duration() - seen.last() > UNSEEN) {
      right.add(KickEnd.LOST);
      right.add(KickEnd.RECORDING_ENDED);
    }
    return right;
  }

  /** Everything in some lines. */
  String summary() {
    return String.format(
        Locale.ROOT,
        "%d kicks: %d found (%.1f %%), %d invented (%.1f %%; %d of them deflections), %d ends of %d"
            + " right (%.1f %%), %d cut short, %d with what came after; robot right %d, from rest"
            + " %d; %d found that do not count%nafter dribbling: %d of %d flagged, without: %d of"
            + " %d%nends: %s",
        counted,
        found,
        100.0 * found / counted,
        invented,
        100.0 * invented / Math.max(1, found + extra + invented),
        deflections,
        rightEnds,
        judgedEnds,
        100.0 * rightEnds / judgedEnds,
        cutShort,
        contaminated,
        rightRobot,
        fromRest,
        extra,
        dribbled[3],
        dribbled[2] + dribbled[3],
        dribbled[1],
        dribbled[0] + dribbled[1],
        ends);
  }
}
