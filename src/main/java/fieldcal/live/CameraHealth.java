package fieldcal.live;

import java.util.OptionalInt;

/**
 * How well one camera works.
 *
 * @param id camera id
 * @param frames number of frames received, without repeated ones
 * @param repeated frames that came twice or after a later one of this camera
 * @param rateHz mean rate of the last second or so outside of gaps; NaN before the second frame
 * @param silentFor how long ago the last frame was captured, measured by the newest frame of all cameras, s
 * @param gaps how often it was silent for more than a quarter of a second
 * @param longestGap longest gap, s; 0 without one
 * @param balls detections of balls, true and false
 * @param robots detections of robots
 * @param noiseMm noise of the ball per axis, mm; NaN until some fifty triples of detections of one ball were seen
 * @param offsetXMm offset that it adds to every x, relative to the mean of the cameras that see the same balls, mm; NaN before it was compared
 * @param offsetYMm the same for y, mm
 * @param apartMm distance between its offset and that of the camera that it disagrees with most, mm; NaN before two were compared
 * @param apartFrom that camera; empty before two were compared
 * @param calibrated whether usable geometry of it is published
 */
public record CameraHealth(
    int id,
    long frames,
    long repeated,
    double rateHz,
    double silentFor,
    long gaps,
    double longestGap,
    long balls,
    long robots,
    double noiseMm,
    double offsetXMm,
    double offsetYMm,
    double apartMm,
    OptionalInt apartFrom,
    boolean calibrated) {
  /**
   * Two cameras that are farther apart than this disagree, mm. An AI that uses them as they are sees the ball jump by that distance; within the 0.4 s that a ball of 3 m/s slides, a step of 10 mm looks like 0.13 m/s², 4 % of the sliding deceleration.
   */
  public static final double MOST_APART_MM = 10;

  /**
   * Whether it disagrees with another camera.
   *
   * @return true when it is known to be more than {@link #MOST_APART_MM} apart from one
   */
  public boolean disagrees() {
    return apartMm > MOST_APART_MM;
  }
}
