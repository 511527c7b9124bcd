package fieldcal.app.wording;

/**
 * Names of cameras. A camera that was calibrated again between two recordings of a session is another camera there. Its number is that of vision and a multiple
 * of 100, which no vision gives to a camera; its name says both numbers.
 */
public final class CameraName {
  private static final int STEP = 100;

  private CameraName() {}

  /**
   * The number of the same camera with its next calibration.
   *
   * @param number of the camera before
   * @return the next number
   */
  public static int next(int number) {
    return number + STEP;
  }

  /**
   * Names a camera.
   *
   * @param number as the recordings of a session number it
   * @return for example "camera 1", or "camera 101 (camera 1, calibrated again)"
   */
  static String of(int number) {
    return number < STEP
        ? "camera " + number
        : "camera " + number + " (camera " + number % STEP + ", calibrated again)";
  }
}
