package fieldcal.fit;

import fieldcal.camera.Camera;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Finds cameras whose published lens must be wrong, because it does not see the places where they report balls. Of such a camera only the position is used.
 *
 * <p>A lens with negative distortion folds: beyond a radius no ground is seen, and just before it a pixel covers next to no ground, as if the camera had no noise there.
 */
public final class LensCheck {
  /**
   * A pixel covers at least this share of what it covers straight below the camera. Off the axis it covers more, (1 + tan²)^1.5 times as much, and a barrel lens takes back a
   * third at most; a quarter is near a fold.
   */
  static final double LEAST_GROUND = 0.25;

  /** Largest share of a sound camera's detections that may be false ones outside of its image. */
  private static final double MOST_UNSEEN = 0.01;

  private LensCheck() {}

  /** Detections of a camera, and those of them that its lens does not see. */
  static final class Count {
    private int all;
    private int unseen;
  }

  /** Counts of each camera with a lens, by its id. Offsets and noise of the cameras hardly matter: they are millimetres. */
  static Map<Integer, Count> count(Kick kick, CameraViews views) {
    Map<Integer, Count> counts = new TreeMap<>();
    Whitening whitening = new Whitening();
    Observations seen = kick.observations();
    for (int i = 0; i < seen.size(); i++) {
      CameraView view = views.get(seen.camera(i));
      if (view.camera().filter(Camera::hasPixels).isPresent()) {
        Count count = counts.computeIfAbsent(view.id(), id -> new Count());
        whitening.at(view, seen.x(i) - view.offsetX(), seen.y(i) - view.offsetY());
        count.all++;
        count.unseen += whitening.isSeen() ? 0 : 1;
      }
    }
    return counts;
  }

  /**
   * The share of its detections that the lens of a camera does not see.
   *
   * @param kicks any kind
   * @param views the cameras
   * @return by id, of those cameras whose lens is not usable; 0 … 1
   */
  public static Map<Integer, Double> unusable(List<Kick> kicks, CameraViews views) {
    return unusable(kicks.stream().map(kick -> count(kick, views)).toList());
  }

  /** The same from the counts of each kick. */
  static Map<Integer, Double> unusable(List<Map<Integer, Count>> kicks) {
    Map<Integer, Count> counts = new TreeMap<>();
    for (Map<Integer, Count> kick : kicks) {
      kick.forEach(
          (id, more) -> {
            Count sum = counts.computeIfAbsent(id, key -> new Count());
            sum.all += more.all;
            sum.unseen += more.unseen;
          });
    }
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

  /**
   * The cameras without lenses that are not usable.
   *
   * @param kicks any kind
   * @param views the cameras
   * @return the views; of those cameras only the position is known
   */
  public static CameraViews usable(List<Kick> kicks, CameraViews views) {
    return without(unusable(kicks, views).keySet(), views);
  }

  /** Of these cameras only the position is known. */
  static CameraViews without(Set<Integer> unusable, CameraViews views) {
    return unusable.isEmpty()
        ? views
        : views.map(
            v ->
                unusable.contains(v.id())
                    ? new CameraView(
                        v.id(),
                        v.camera()
                            .map(c -> c.withoutPixels("its lens does not see what it reports")),
                        v.offsetX(),
                        v.offsetY(),
                        v.noise())
                    : v);
  }
}
