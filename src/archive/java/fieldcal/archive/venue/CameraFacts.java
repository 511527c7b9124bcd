package fieldcal.archive.venue;

import java.io.Serializable;

/**
 * A camera of a match, as venues are recognised by it.
 *
 * @param id of the camera
 * @param x where it hangs, m; NaN when unknown
 * @param y where it hangs, m
 * @param height above the carpet, m
 * @param calibration fingerprint of its calibration; null when none is published
 * @param offsetX what it adds to positions, m
 * @param offsetY what it adds to positions, m
 * @param rate frames per second; NaN when unknown
 * @param noise of a resting ball, m; NaN when unknown
 * @param jitter of capture times, s; NaN when unknown
 * @param loss share of its frames that are missing
 * @param gaps how often it was silent
 * @param distortion radial, as published; NaN when unknown
 */
public record CameraFacts(
    int id,
    double x,
    double y,
    double height,
    String calibration,
    Measured offsetX,
    Measured offsetY,
    double rate,
    double noise,
    double jitter,
    double loss,
    long gaps,
    double distortion)
    implements Serializable {}
