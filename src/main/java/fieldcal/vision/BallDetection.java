package fieldcal.vision;

/**
 * A ball, or what was taken for one, in one image.
 *
 * <p>The position is where the camera's ray through the ball meets the plane of a resting ball's centre; for a ball in the
 * air it lies farther from the camera than the ball does.
 *
 * @param x position in the field frame, m
 * @param y position in the field frame, m
 * @param z height as reported, m; NaN when absent
 * @param confidence 0 … 1 as reported; 1 when absent
 * @param area size of the blob, pixels; 0 when absent
 * @param pixelX column in the image, pixels; NaN when absent
 * @param pixelY row in the image, pixels; NaN when absent
 */
public record BallDetection(
    double x, double y, double z, double confidence, int area, double pixelX, double pixelY) {

  /**
   * Tells whether vision reported a height.
   *
   * @return true if {@link #z} is a number
   */
  public boolean hasHeight() {
    return !Double.isNaN(z);
  }
}
