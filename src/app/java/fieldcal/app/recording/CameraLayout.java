package fieldcal.app.recording;

import fieldcal.camera.Camera;
import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Finds cameras that are mixed up: those whose numbers were swapped, and those that are calibrated the wrong way round. A field looks the same from both ends, so both calibrations succeed.
 *
 * <p>Numbers are swapped when each of two cameras reports what lies below the other. A camera is the wrong way round when what it and another one see at the same time has not one place, but one centre: the sum
 * of both places stays, wherever the thing moves.
 */
final class CameraLayout {
  /** What two cameras see within that time is at one place: 3 m/s make 60 mm, s. */
  private static final double SIMULTANEOUS = 0.02;

  /** A pair of sightings tells something new where the thing has moved by that since the last one, m. */
  private static final double MOVED = 0.1;

  /** So many of them are enough, and bound the memory. */
  private static final int MOST_PAIRS = 500;

  /** With {@link #MOVED} between two pairs: a ball that rolls for one and a half metres. */
  private static final int LEAST_PAIRS = 15;

  /** Far above what sound cameras disagree by, which is up to 30 mm, and far below a field, m. */
  private static final double SAME_PLACE = 0.3;

  /** The thing must have been at different places, or a shift would look like a turn, m. */
  private static final double LEAST_SPREAD = 1;

  /** A clear majority of the pairs. */
  private static final double MAJORITY = 2 / 3.0;

  /** Where a camera reported anything is kept on a grid, m; with so many cells to each side of the centre. */
  private static final double CELL = 0.5;

  private static final int CELLS = 32;

  /** The path of one kick touches that many cells. */
  private static final int LEAST_CELLS = 12;

  /**
   * Least mean difference of the distances to the own camera and to the other one, as a share of the distance between both cameras. For a camera that looks at its half of a field it is about a half, with either
   * sign; where balls and robots move along the border of both views, it is much smaller.
   */
  private static final double NEARER = 0.2;

  private final Map<Integer, BitSet> places = new TreeMap<>();
  private final Map<Integer, Map<Object, double[]>> latest = new HashMap<>();
  private final Map<CameraPair, Pairs> pairs = new TreeMap<>();

  CameraLayout() {}

  /**
   * Cameras that are mixed up.
   *
   * @param cameras one, or more when it is not known which of them it is
   * @param swapped whether their numbers are; otherwise one of them is the wrong way round
   */
  record Finding(Set<Integer> cameras, boolean swapped) {}

  /** Two cameras, the one with the lower number first. */
  private record CameraPair(int low, int high) implements Comparable<CameraPair> {
    static CameraPair of(int a, int b) {
      return new CameraPair(Math.min(a, b), Math.max(a, b));
    }

    Set<Integer> cameras() {
      return Set.of(low, high);
    }

    @Override
    public int compareTo(CameraPair other) {
      return low != other.low ? Integer.compare(low, other.low) : Integer.compare(high, other.high);
    }
  }

  /** What two cameras saw at the same time, x and y of the one and of the other. */
  private static final class Pairs {
    private final List<double[]> places = new ArrayList<>();
    private final Map<Object, double[]> last = new HashMap<>();

    void add(Object what, double[] one, double[] two) {
      double[] before = last.get(what);
      if (places.size() < MOST_PAIRS
          && (before == null || Math.hypot(one[1] - before[0], one[2] - before[1]) > MOVED)) {
        double[] both = {one[1], one[2], two[1], two[2]};
        places.add(both);
        last.put(what, both);
      }
    }

    boolean areSame() {
      return 2 * places.stream().filter(p -> distance(p, 1, 0, 0) < SAME_PLACE).count()
          > places.size();
    }

    boolean areOpposite() {
      if (places.size() < LEAST_PAIRS) {
        return false;
      }
      double centreX = median(0, -1);
      double centreY = median(1, -1);
      long fitting =
          places.stream().filter(p -> distance(p, -1, centreX, centreY) < SAME_PLACE).count();
      double shiftX = median(0, 1);
      double shiftY = median(1, 1);
      double spread =
          places.stream().mapToDouble(p -> distance(p, 1, shiftX, shiftY)).average().orElse(0);
      return fitting > MAJORITY * places.size() && spread > LEAST_SPREAD;
    }

    private double median(int axis, int sign) {
      double[] values = places.stream().mapToDouble(p -> p[axis] - sign * p[axis + 2]).toArray();
      Arrays.sort(values);
      return values[values.length / 2];
    }

    private static double distance(double[] p, int sign, double x, double y) {
      return Math.hypot(p[0] - sign * p[2] - x, p[1] - sign * p[3] - y);
    }
  }

  void accept(VisionFrame frame) {
    Map<Object, double[]> seen = new HashMap<>();
    for (RobotDetection robot : frame.robots()) {
      see(frame, seen, robot.id(), robot.x(), robot.y());
    }
    for (BallDetection ball : frame.balls()) {
      see(frame, seen, "ball", ball.x(), ball.y());
    }
    if (frame.balls().size() != 1) {
      seen.remove("ball");
    }
    latest.put(frame.cameraId(), seen);
    latest.forEach((other, things) -> compare(frame, seen, other, things));
  }

  private void see(VisionFrame frame, Map<Object, double[]> seen, Object what, double x, double y) {
    seen.put(what, new double[] {frame.captureTime(), x, y});
    int column = (int) Math.floor(x / CELL) + CELLS;
    int row = (int) Math.floor(y / CELL) + CELLS;
    if (column >= 0 && column < 2 * CELLS && row >= 0 && row < 2 * CELLS) {
      places.computeIfAbsent(frame.cameraId(), id -> new BitSet()).set(2 * CELLS * row + column);
    }
  }

  private void compare(
      VisionFrame frame, Map<Object, double[]> seen, int other, Map<Object, double[]> things) {
    int camera = frame.cameraId();
    if (other == camera) {
      return;
    }
    boolean first = camera < other;
    Pairs both = pairs.computeIfAbsent(CameraPair.of(camera, other), key -> new Pairs());
    seen.forEach(
        (what, a) -> {
          double[] b = things.get(what);
          if (b != null && Math.abs(a[0] - b[0]) < SIMULTANEOUS) {
            both.add(what, first ? a : b, first ? b : a);
          }
        });
  }

  /** What is mixed up, by the published positions of the cameras. */
  List<Finding> findings(Map<Integer, Camera> cameras) {
    List<Finding> findings = new ArrayList<>(turned());
    for (int one : cameras.keySet()) {
      for (int other : cameras.keySet()) {
        if (one < other && isBelow(one, other, cameras) && isBelow(other, one, cameras)) {
          findings.add(new Finding(new TreeSet<>(Set.of(one, other)), true));
        }
      }
    }
    return findings;
  }

  /** Whether what a camera reports lies below another one. */
  private boolean isBelow(int camera, int other, Map<Integer, Camera> cameras) {
    BitSet cells = places.getOrDefault(camera, new BitSet());
    Camera own = cameras.get(camera);
    Camera there = cameras.get(other);
    double apart =
        Math.hypot(own.positionX() - there.positionX(), own.positionY() - there.positionY());
    double nearer =
        cells.stream().mapToDouble(c -> distance(c, own) - distance(c, there)).average().orElse(0);
    return cells.cardinality() >= LEAST_CELLS && nearer > NEARER * apart;
  }

  private static double distance(int cell, Camera camera) {
    double x = (cell % (2 * CELLS) - CELLS + 0.5) * CELL;
    double y = (cell / (2 * CELLS) - CELLS + 0.5) * CELL;
    return Math.hypot(camera.positionX() - x, camera.positionY() - y);
  }

  private List<Finding> turned() {
    Set<Integer> sound = new HashSet<>();
    List<CameraPair> opposite = new ArrayList<>();
    pairs.forEach(
        (both, seen) -> {
          if (seen.places.size() >= LEAST_PAIRS && seen.areSame()) {
            sound.addAll(both.cameras());
          } else if (seen.areOpposite()) {
            opposite.add(both);
          }
        });
    // Of two cameras, the one that agrees with a third camera is not the turned one.
    Set<Set<Integer>> named = new HashSet<>();
    List<Finding> findings = new ArrayList<>();
    for (CameraPair both : opposite) {
      Set<Integer> suspects = new TreeSet<>(both.cameras());
      suspects.removeAll(sound);
      if (!suspects.isEmpty() && named.add(suspects)) {
        findings.add(new Finding(suspects, false));
      }
    }
    return findings;
  }
}
