package fieldcal.simulation.imaging;

import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.physics.Region;
import java.util.ArrayList;
import java.util.List;

/** Hangs cameras over a field so that together they see all of it and overlap. */
public final class CameraRig {
  /** Image of the cameras that most fields use, pixels. */
  static final int IMAGE_WIDTH = 2448;

  static final int IMAGE_HEIGHT = 2048;

  private CameraRig() {}

  /**
   * Cameras in a grid: one or two rows along the field.
   *
   * @param field the field
   * @param settings how they hang
   * @param nuisance what goes wrong
   * @param errors what is wrong with each camera, by number; missing = nothing
   * @param rollingShutter time from the first to the last image row, s
   * @param seed of the simulation
   * @return the cameras, by number
   */
  public static List<SimulatedCamera> over(
      FieldSize field,
      CameraSettings settings,
      Nuisance nuisance,
      List<CameraErrors> errors,
      double rollingShutter,
      long seed) {
    int count = settings.count();
    int rows = count >= 4 && count % 2 == 0 ? 2 : 1;
    int columns = count / rows;
    RandomStream registration = RandomStream.of(seed, "cameras disagree");
    double direction = registration.uniform(0, 2 * Math.PI);
    List<SimulatedCamera> cameras = new ArrayList<>();
    for (int id = 0; id < count; id++) {
      RandomStream random = RandomStream.of(seed, "camera " + id);
      int column = id / rows;
      int row = id % rows;
      double cellX = field.length() / columns;
      double cellY = field.width() / rows;
      double x = (column + 0.5) * cellX - field.length() / 2 + random.gaussian(0.05);
      double y = (row + 0.5) * cellY - field.width() / 2 + random.gaussian(0.05);
      double z = settings.height() * (1 + random.gaussian(0.01));
      double distortion = settings.distortion() * (1 + random.gaussian(0.08));
      double halfX = cellX / 2 + (columns > 1 ? settings.overlap() : field.boundary());
      double halfY = cellY / 2 + (rows > 1 ? settings.overlap() : field.boundary());
      boolean turned = fit(halfY, halfX, z, distortion) > fit(halfX, halfY, z, distortion);
      double focal =
          (turned ? fit(halfY, halfX, z, distortion) : fit(halfX, halfY, z, distortion))
              * (1 + random.gaussian(0.005));
      double yaw = (turned ? Math.PI / 2 : 0) + (random.happens(0.5) ? Math.PI : 0);
      Pose pose =
          Pose.lookingDown(x, y, z, yaw + random.gaussian(0.01))
              .tilted(random.gaussian(0.008), random.uniform(0, Math.PI));
      Pose.Lens lens =
          new Pose.Lens(
              focal,
              IMAGE_WIDTH / 2.0 + random.gaussian(8),
              IMAGE_HEIGHT / 2.0 + random.gaussian(8),
              distortion);
      // Neighbours in the grid are shifted to opposite sides.
      double apart = ((row + column) % 2 == 0 ? 0.5 : -0.5) * settings.disagreement();
      CameraErrors own = id < errors.size() ? errors.get(id) : CameraErrors.NONE;
      CameraErrors all =
          own.plus(
              CameraErrors.NONE.withOffset(
                  apart * Math.cos(direction), apart * Math.sin(direction)));
      cameras.add(
          SimulatedCamera.create(id, pose, lens, all, rollingShutter, settings, nuisance, seed));
    }
    return List.copyOf(cameras);
  }

  /**
   * Cameras that hang already.
   *
   * @param installed the cameras, by id
   * @param settings the plane that vision projects onto, and whether cameras take their frames together; the rest does not count
   * @param errors what else is wrong with each, in the order of the cameras
   * @param rollingShutter time from the first to the last image row, s
   * @param from session time at which the recording begins, s
   * @param seed of the simulation
   * @return the cameras, in the same order
   */
  public static List<SimulatedCamera> of(
      List<InstalledCamera> installed,
      CameraSettings settings,
      List<CameraErrors> errors,
      double rollingShutter,
      double from,
      long seed) {
    List<SimulatedCamera> cameras = new ArrayList<>();
    for (int i = 0; i < installed.size(); i++) {
      cameras.add(
          SimulatedCamera.create(
              installed.get(i), errors.get(i), rollingShutter, settings, from, seed));
    }
    return List.copyOf(cameras);
  }

  /**
   * The calibration of a perfect camera that looks straight down and sees an area.
   *
   * @param id of the camera
   * @param x position, m
   * @param y position, m
   * @param z height above the carpet, m
   * @param area on the ground; {@link Region#NONE} = as far to each side as the camera is high
   * @return complete, with an image size
   */
  public static CameraCalibration lookingDown(int id, double x, double y, double z, Region area) {
    boolean open = area.equals(Region.NONE);
    double halfX = open ? z : Math.max(area.x1() - x, x - area.x0());
    double halfY = open ? z : Math.max(area.y1() - y, y - area.y0());
    double focal = fit(Math.max(halfX, 0.1), Math.max(halfY, 0.1), z, 0);
    Pose.Lens lens = new Pose.Lens(focal, IMAGE_WIDTH / 2.0, IMAGE_HEIGHT / 2.0, 0);
    return Pose.lookingDown(x, y, z, 0).calibration(id, lens, IMAGE_WIDTH, IMAGE_HEIGHT);
  }

  /** Focal length in pixels at which an area fits into the image. */
  private static double fit(double halfWidth, double halfHeight, double z, double distortion) {
    double across = Math.hypot(halfWidth, halfHeight) / z;
    double squeeze = distorted(across, distortion) / across;
    return Math.min(
        IMAGE_WIDTH / 2.0 / (halfWidth / z * squeeze),
        IMAGE_HEIGHT / 2.0 / (halfHeight / z * squeeze));
  }

  /** Distorted radius of an undistorted one: r_d·(1 + k·r_d²) = r_u, by Newton's method from below the fold of the lens. */
  private static double distorted(double undistorted, double k) {
    double fold = k < 0 ? 0.98 * Math.sqrt(-1 / (3 * k)) : Double.POSITIVE_INFINITY;
    double r = Math.min(undistorted, fold);
    for (int i = 0; i < 50; i++) {
      r = Math.min(fold, r - (r + k * r * r * r - undistorted) / (1 + 3 * k * r * r));
    }
    return r;
  }
}
