package fieldcal.fit;

import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.List;
import java.util.Map;
import java.util.Set;

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

  private static final String UNSEEN =
      "its published lens does not see the places where it reports balls";

  private LensCheck() {}

  /** Counts of a kick. Offsets and noise of the cameras hardly matter: they are millimetres. */
  static LensCounts count(Kick kick, CameraViews views) {
    LensCounts counts = new LensCounts();
    Observations seen = kick.observations();
    for (int i = 0; i < seen.size(); i++) {
      counts.add(views.get(seen.camera(i)), seen.x(i), seen.y(i));
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
  static Map<Integer, Double> unusable(List<LensCounts> kicks) {
    LensCounts sum = new LensCounts();
    kicks.forEach(sum::add);
    return sum.unusable();
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
                        v.camera().map(c -> c.withoutPixels(UNSEEN)),
                        v.offsetX(),
                        v.offsetY(),
                        v.noise())
                    : v);
  }
}
