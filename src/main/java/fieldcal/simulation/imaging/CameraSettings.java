package fieldcal.simulation.imaging;

import java.util.Objects;

/**
 * How the cameras hang and how good they are. Details (position, tilt, lens) vary from camera to camera by a few per cent, drawn from the seed.
 *
 * @param count number of cameras, 1 … 8
 * @param height above the carpet, m
 * @param distortion radial distortion, either sign (–)
 * @param ballNoise standard deviation of a ball's reported position straight below the camera, m
 * @param robotNoise the same of a robot, m
 * @param robotAngleNoise standard deviation of a robot's reported orientation, rad
 * @param rateMin lowest frame rate, 1/s
 * @param rateMax highest frame rate, 1/s
 * @param ballPlane height of the ball's centre that vision assumes, m
 * @param disagreement by how much neighbouring cameras report the same ball apart, m
 * @param overlap how far each camera sees beyond its share of the field, m
 * @param exposure whether cameras take their frames together
 */
public record CameraSettings(
    int count,
    double height,
    double distortion,
    double ballNoise,
    double robotNoise,
    double robotAngleNoise,
    double rateMin,
    double rateMax,
    double ballPlane,
    double disagreement,
    double overlap,
    Exposure exposure) {

  /** Four good cameras without contradictions. */
  public static final CameraSettings DEFAULT =
      new CameraSettings(4, 5.3, 0.12, 0.002, 0.0035, 0.01, 70, 75, 0.0215, 0, 0.6, Exposure.FREE);

  /** When cameras take their frames. */
  public enum Exposure {
    /** Each in its own beat, as most real cameras do. */
    FREE,
    /** All at the same moment, with the same time stamp, as simulators and triggered cameras do. */
    TOGETHER
  }

  /**
   * Usual cameras, each in its own beat.
   *
   * @param count number of cameras, 1 … 8
   * @param height above the carpet, m
   * @param distortion radial distortion, either sign (–)
   * @param ballNoise standard deviation of a ball's reported position straight below the camera, m
   * @param robotNoise the same of a robot, m
   * @param robotAngleNoise standard deviation of a robot's reported orientation, rad
   * @param rateMin lowest frame rate, 1/s
   * @param rateMax highest frame rate, 1/s
   * @param ballPlane height of the ball's centre that vision assumes, m
   * @param disagreement by how much neighbouring cameras report the same ball apart, m
   * @param overlap how far each camera sees beyond its share of the field, m
   * @throws IllegalArgumentException when a value is out of range or NaN
   */
  public CameraSettings(
      int count,
      double height,
      double distortion,
      double ballNoise,
      double robotNoise,
      double robotAngleNoise,
      double rateMin,
      double rateMax,
      double ballPlane,
      double disagreement,
      double overlap) {
    this(
        count,
        height,
        distortion,
        ballNoise,
        robotNoise,
        robotAngleNoise,
        rateMin,
        rateMax,
        ballPlane,
        disagreement,
        overlap,
        Exposure.FREE);
  }

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a value is out of range or NaN
   * @throws NullPointerException when {@code exposure} is null
   */
  public CameraSettings {
    Objects.requireNonNull(exposure, "exposure");
    range("count", count, 1, 8);
    range("height", height, 1, 20);
    range("distortion", distortion, -0.25, 1);
    range("ballNoise", ballNoise, 0, 0.1);
    range("robotNoise", robotNoise, 0, 0.1);
    range("robotAngleNoise", robotAngleNoise, 0, 1);
    range("rateMin", rateMin, 5, 1000);
    range("rateMax", rateMax, rateMin, 1000);
    range("ballPlane", ballPlane, -0.1, 0.2);
    range("disagreement", disagreement, 0, 0.5);
    range("overlap", overlap, 0, 5);
  }

  private static void range(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(
          name + " must lie in [" + min + ", " + max + "], but is " + value);
    }
  }

  /**
   * Another number of cameras.
   *
   * @param cameras 1 … 8
   * @return the changed settings
   */
  public CameraSettings withCount(int cameras) {
    return new CameraSettings(
        cameras,
        height,
        distortion,
        ballNoise,
        robotNoise,
        robotAngleNoise,
        rateMin,
        rateMax,
        ballPlane,
        disagreement,
        overlap,
        exposure);
  }

  /**
   * Another height.
   *
   * @param metres above the carpet, m
   * @return the changed settings
   */
  public CameraSettings withHeight(double metres) {
    return new CameraSettings(
        count,
        metres,
        distortion,
        ballNoise,
        robotNoise,
        robotAngleNoise,
        rateMin,
        rateMax,
        ballPlane,
        disagreement,
        overlap,
        exposure);
  }

  /**
   * Another lens.
   *
   * @param coefficient radial distortion, either sign
   * @return the changed settings
   */
  public CameraSettings withDistortion(double coefficient) {
    return new CameraSettings(
        count,
        height,
        coefficient,
        ballNoise,
        robotNoise,
        robotAngleNoise,
        rateMin,
        rateMax,
        ballPlane,
        disagreement,
        overlap,
        exposure);
  }

  /**
   * Another noise of ball and robots.
   *
   * @param ball m
   * @param robot m
   * @return the changed settings
   */
  public CameraSettings withNoise(double ball, double robot) {
    return new CameraSettings(
        count,
        height,
        distortion,
        ball,
        robot,
        robotAngleNoise,
        rateMin,
        rateMax,
        ballPlane,
        disagreement,
        overlap,
        exposure);
  }

  /**
   * Another assumed height of the ball's centre and another contradiction between cameras.
   *
   * @param plane assumed height of the ball's centre, m
   * @param apart by how much neighbouring cameras disagree, m
   * @return the changed settings
   */
  public CameraSettings withRegistration(double plane, double apart) {
    return new CameraSettings(
        count,
        height,
        distortion,
        ballNoise,
        robotNoise,
        robotAngleNoise,
        rateMin,
        rateMax,
        plane,
        apart,
        overlap,
        exposure);
  }

  /**
   * Another beat.
   *
   * @param beat whether cameras take their frames together
   * @return the changed settings
   */
  public CameraSettings withExposure(Exposure beat) {
    return new CameraSettings(
        count,
        height,
        distortion,
        ballNoise,
        robotNoise,
        robotAngleNoise,
        rateMin,
        rateMax,
        ballPlane,
        disagreement,
        overlap,
        beat);
  }
}
