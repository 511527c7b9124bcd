package fieldcal.live;

/**
 * How well one camera does.
 *
 * @param id camera id
 * @param frames received, repeated ones not counted
 * @param repeated frames that came twice or after a later one of this camera
 * @param rateHz mean rate of the last second or so outside of gaps; NaN before the second frame
 * @param silentFor how long ago the last frame was captured, measured by the newest frame of all cameras, s
 * @param gaps how often it was silent for more than a quarter of a second
 * @param longestGap s; 0 without one
 * @param balls detections of balls, true and false
 * @param robots detections of robots
 * @param noiseMm noise of a resting ball per axis, mm; NaN when too little was seen at rest
 * @param offsetXMm what it adds to every x, against the mean of the cameras that see the same balls, mm; NaN before it was compared
 * @param offsetYMm the same for y, mm
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
    boolean calibrated) {}
