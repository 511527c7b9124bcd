package fieldcal.fit;

import fieldcal.camera.Camera;
import java.util.Map;
import java.util.TreeMap;

/**
 * Counts, detection by detection, the places where cameras report balls but which their published lenses do not see. Memory is constant. Mutable, for one thread.
 */
public final class LensCounts {
  /** Largest share of a sound camera's detections that may be false ones outside of its image. */
  private static final double MOST_UNSEEN = 0.01;

  private final Map<Integer, Count> counts = new TreeMap<>();
  private final Whitening whitening = new Whitening();

  /** Detections of a camera, and those of them that its lens does not see. */
  private static final class Count {
    private long all;
    private long unseen;
  }

  /** Starts with nothing counted. */
  public LensCounts() {}

  /**
   * Counts a detection. That of a camera without a lens counts nothing.
   *
   * @param view the camera
   * @param x where it reports a ball, m
   * @param y where it reports a ball, m
   */
  public void add(CameraView view, double x, double y) {
    if (view.camera().filter(Camera::hasPixels).isPresent()) {
      Count count = counts.computeIfAbsent(view.id(), id -> new Count());
      whitening.at(view, x - view.offsetX(), y - view.offsetY());
      count.all++;
      count.unseen += whitening.isSeen() ? 0 : 1;
    }
  }

  /**
   * Adds what was counted elsewhere.
   *
   * @param other its counts; stays as it is
   */
  public void add(LensCounts other) {
    other.counts.forEach(
        (id, more) -> {
          Count sum = counts.computeIfAbsent(id, key -> new Count());
          sum.all += more.all;
          sum.unseen += more.unseen;
        });
  }

  /**
   * Forgets a camera, for one that was calibrated again.
   *
   * @param camera its id
   */
  public void forget(int camera) {
    counts.remove(camera);
  }

  /**
   * The cameras whose lens is not usable.
   *
   * @return by id, the share of its detections that the lens does not see; above 0.01, at most 1
   */
  public Map<Integer, Double> unusable() {
    Map<Integer, Double> shares = new TreeMap<>();
    counts.forEach(
        (id, count) -> {
          double share = count.unseen / (double) count.all;
          if (share > MOST_UNSEEN) {
            shares.put(id, share);
          }
        });
    return shares;
  }
}
