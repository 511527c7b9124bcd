package fieldcal.effect;

import java.util.Arrays;

/**
 * By which cameras and when a ball was seen: what the reports of its place depend on apart from its path. Predictions are fastest when the stamps are in order. The arrays are not copied and must not be changed;
 * then it may be used by many threads.
 */
public final class Sightings {
  final int[] camera;
  final double[] stamp;
  final double[] pixelRow;

  /** The latest stamp, s; −∞ without sightings. */
  final double latest;

  /**
   * Sightings, one per index.
   *
   * @param camera camera ids
   * @param stamp the detections' time stamps, s on the clock of the path's kick
   * @param pixelRow the detections' rows in the image, pixels; not above 0 or NaN = unknown
   * @throws IllegalArgumentException when the arrays differ in length
   */
  public Sightings(int[] camera, double[] stamp, double[] pixelRow) {
    if (camera.length != stamp.length || camera.length != pixelRow.length) {
      throw new IllegalArgumentException(
          "arrays differ in length: %d cameras, %d stamps, %d rows"
              .formatted(camera.length, stamp.length, pixelRow.length));
    }
    this.camera = camera;
    this.stamp = stamp;
    this.pixelRow = pixelRow;
    latest = Arrays.stream(stamp).max().orElse(Double.NEGATIVE_INFINITY);
  }

  /**
   * How many there are.
   *
   * @return the length of the arrays
   */
  public int size() {
    return stamp.length;
  }
}
