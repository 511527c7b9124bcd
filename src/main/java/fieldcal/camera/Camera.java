package fieldcal.camera;

import java.util.Locale;
import java.util.Optional;

/**
 * A camera above the field: from the world into its image and back, and onto the ground, as vision does it.
 *
 * <p>Heights z are those of fieldcal's balls: 0 when the ball rests on the carpet, so that the centre of a ball at z is at world height z +
 * {@link #BALL_RADIUS}. Vision does not know how high a ball is; it reports where the ray from the camera through the ball's centre meets
 * the <em>ball plane</em>, the plane in which it believes all balls' centres to lie. That plane is at {@link #BALL_RADIUS} unless a
 * camera is made with another one (some set-ups assume 30 mm).
 *
 * <p>With the camera at C and the ball's centre at P, the ball is reported at C + s·(P − C) with s = (C_z − plane)/(C_z − P_z); the lens and the
 * rotation do not matter for it. The pinhole model is SSL-Vision's, see {@link CameraCalibration}.
 *
 * <p>Not every source means what it publishes: simulators fill in rotation and lens with placeholders. A camera therefore has a
 * {@link PoseSource}; one with the position only answers everything about the ground and refuses everything about pixels.
 *
 * <p>Instances are immutable. The methods allocate nothing; results go into arrays of the caller. What cannot be seen or projected
 * is NaN, never an exception, so that a search may ask for anything.
 */
public final class Camera {

  /** Radius of the ball and so the height of a resting ball's centre, m. Source: SSL rules, a golf ball, 43 mm in diameter. */
  public static final double BALL_RADIUS = 0.0215;

  /**
   * How far the position that follows from rotation and translation may be from the published one, m. SSL-Vision computes the latter from the former, so that
   * they differ by the rounding of 32-bit numbers (0.01 mm) or by a rotation rounded to three digits (some 10 mm at 5 m); placeholders are
   * metres off.
   */
  public static final double POSITION_TOLERANCE = 0.05;

  /** Lowest height at which a camera is believed to hang, m; chosen, because no league's robots (0.15 m) would fit under a lower one. */
  private static final double MIN_HEIGHT = 0.5;

  /** No camera hangs farther from the field's centre, m: eight times the largest field of the rules. */
  private static final double MAX_DISTANCE = 100;

  /** Coordinates from here on are shown with a power of ten, m; chosen, a thousand times {@link #MAX_DISTANCE}. */
  private static final double LONG_NUMBER = 1e5;

  private final int id;
  private final Pinhole pinhole; // null: position only
  private final double x;
  private final double y;
  private final double z;
  private final double ballPlane;
  private final String consistency;
  private final boolean sound;

  private Camera(
      int id,
      Pinhole pinhole,
      double x,
      double y,
      double z,
      double ballPlane,
      String consistency,
      boolean sound) {
    if (!isPlace(x, y, z)) {
      throw new IllegalArgumentException(
          "camera " + id + ": no usable position: " + point(x, y, z) + "; " + consistency);
    }
    if (!(Math.abs(ballPlane) < MIN_HEIGHT / 2)) {
      throw new IllegalArgumentException("camera " + id + ": ball plane at " + ballPlane + " m");
    }
    this.id = id;
    this.pinhole = pinhole;
    this.x = x;
    this.y = y;
    this.z = z;
    this.ballPlane = ballPlane;
    this.consistency = consistency;
    this.sound = sound;
  }

  /**
   * The camera of a calibration, whose vision projects onto the plane of resting balls.
   *
   * @param calibration as published
   * @return the camera
   * @throws IllegalArgumentException if neither the pose nor the published position is usable
   */
  public static Camera of(CameraCalibration calibration) {
    return of(calibration, BALL_RADIUS);
  }

  /**
   * The camera of a calibration. The pose is used unless it contradicts the published position by more than {@link #POSITION_TOLERANCE} or is no pose
   * at all (zero rotation, focal length not positive, camera not above the field or more than 100 m from its centre); then the position alone is used. A published
   * position where no camera can hang is ignored.
   *
   * @param calibration as published
   * @param ballPlane world height of the plane onto which vision projects balls, m
   * @return the camera
   * @throws IllegalArgumentException if neither the pose nor the published position is usable
   */
  public static Camera of(CameraCalibration calibration, double ballPlane) {
    CameraCalibration c = calibration;
    boolean positionUsable = isPlace(c.derivedWorldX(), c.derivedWorldY(), c.derivedWorldZ());
    Pinhole pinhole = Pinhole.of(c);
    String why;
    if (pinhole == null) {
      why = "its published rotation or focal length is not a calibration";
    } else if (!isPlace(pinhole.cameraX, pinhole.cameraY, pinhole.cameraZ)) {
      why =
          "by its published rotation the camera is at "
              + pinhole.position()
              + ", "
              + noPlace(pinhole.cameraZ);
    } else if (!positionUsable) {
      String note =
          c.hasDerivedPosition()
              ? published(c) + "; the position that follows from the rotation is used"
              : "no position is published; it follows from the rotation";
      return withPose(c.id(), pinhole, ballPlane, note, !c.hasDerivedPosition() || isUnset(c));
    } else {
      double apart =
          Math.hypot(
              Math.hypot(pinhole.cameraX - c.derivedWorldX(), pinhole.cameraY - c.derivedWorldY()),
              pinhole.cameraZ - c.derivedWorldZ());
      if (apart <= POSITION_TOLERANCE) {
        String note =
            String.format(
                Locale.ROOT, "rotation and published position agree to %.2f mm", apart * 1000);
        return withPose(c.id(), pinhole, ballPlane, note, true);
      }
      why =
          String.format(
              Locale.ROOT,
              "by its published rotation the camera is at %s, %.2f m from its published position"
                  + " %s",
              pinhole.position(),
              apart,
              point(c.derivedWorldX(), c.derivedWorldY(), c.derivedWorldZ()));
    }
    if (!positionUsable) {
      String neither = c.hasDerivedPosition() ? published(c) : "no position is published";
      throw new IllegalArgumentException(
          named(c.id()) + "no usable position: " + why + ", and " + neither);
    }
    return new Camera(
        c.id(),
        null,
        c.derivedWorldX(),
        c.derivedWorldY(),
        c.derivedWorldZ(),
        ballPlane,
        why + "; only the published position is used",
        false);
  }

  /**
   * Why a calibration, or a part of it, cannot be used; for those who tell the operator of it.
   *
   * @param calibration as published
   * @return one clause without the camera's number and without a full stop; empty when all of it is used
   */
  public static Optional<String> faultOf(CameraCalibration calibration) {
    try {
      return of(calibration).fault();
    } catch (IllegalArgumentException unusable) {
      return Optional.of(unusable.getMessage().substring(named(calibration.id()).length()));
    }
  }

  private static String named(int id) {
    return "camera " + id + ": ";
  }

  /** Whether a source that cannot leave the position out filled it with zeros. */
  private static boolean isUnset(CameraCalibration c) {
    return c.derivedWorldX() == 0 && c.derivedWorldY() == 0 && c.derivedWorldZ() == 0;
  }

  /** What is wrong with a published position that is no place for a camera. */
  private static String published(CameraCalibration c) {
    return "the published position "
        + point(c.derivedWorldX(), c.derivedWorldY(), c.derivedWorldZ())
        + " is "
        + noPlace(c.derivedWorldZ());
  }

  /** Why no camera can hang there, at a height in m; NaN counts as too low. */
  private static String noPlace(double height) {
    return height >= MIN_HEIGHT ? "too far from the field" : "not above the field";
  }

  /**
   * A camera of which only the position is known, whose vision projects onto the plane of resting balls.
   *
   * @param id camera number
   * @param x position in the world, m
   * @param y position in the world, m
   * @param z height above the carpet, m, at least 0.5
   * @return the camera
   * @throws IllegalArgumentException if a coordinate is not finite or the height too small
   */
  public static Camera ofPosition(int id, double x, double y, double z) {
    return new Camera(id, null, x, y, z, BALL_RADIUS, "only the position is known", true);
  }

  /** Whether a camera can hang there: above the field and not too far away; false for NaN. */
  private static boolean isPlace(double x, double y, double z) {
    return z >= MIN_HEIGHT && z <= MAX_DISTANCE && Math.hypot(x, y) <= MAX_DISTANCE;
  }

  private static Camera withPose(
      int id, Pinhole pinhole, double ballPlane, String note, boolean sound) {
    return new Camera(
        id, pinhole, pinhole.cameraX, pinhole.cameraY, pinhole.cameraZ, ballPlane, note, sound);
  }

  /**
   * This camera with another ball plane.
   *
   * @param height world height of the plane onto which vision projects balls, m
   * @return a new camera
   * @throws IllegalArgumentException if the height is not finite or not near the ground
   */
  public Camera withBallPlane(double height) {
    return new Camera(id, pinhole, x, y, z, height, consistency, sound);
  }

  /**
   * This camera with its position alone, for one whose lens or rotation turned out to be wrong.
   *
   * @param why one clause for the operator
   * @return a new camera
   */
  public Camera withoutPixels(String why) {
    return new Camera(id, null, x, y, z, ballPlane, why + "; only the position is used", false);
  }

  /**
   * The camera's number.
   *
   * @return the id, 0 or more
   */
  public int id() {
    return id;
  }

  /**
   * Where the camera hangs.
   *
   * @return world x, m
   */
  public double positionX() {
    return x;
  }

  /**
   * Where the camera hangs.
   *
   * @return world y, m
   */
  public double positionY() {
    return y;
  }

  /**
   * Where the camera hangs.
   *
   * @return height above the carpet, m
   */
  public double positionZ() {
    return z;
  }

  /**
   * World height of the plane onto which vision projects balls.
   *
   * @return height, m
   */
  public double ballPlane() {
    return ballPlane;
  }

  /**
   * How high the camera hangs above the plane onto which vision projects balls.
   *
   * @return height, m
   */
  public double heightAboveBallPlane() {
    return z - ballPlane;
  }

  /**
   * What of the calibration is used.
   *
   * @return the source of the pose
   */
  public PoseSource poseSource() {
    return pinhole == null ? PoseSource.DERIVED_POSITION : PoseSource.CALIBRATION;
  }

  /**
   * Whether rotation and lens are known, so that the methods about pixels work.
   *
   * @return true when they are
   */
  public boolean hasPixels() {
    return pinhole != null;
  }

  /**
   * One clause for the operator: whether the published values fit together and what was made of it.
   *
   * @return the note, without the camera's number and without a full stop
   */
  public String consistency() {
    return consistency;
  }

  /**
   * What of the published values is not used, and why.
   *
   * @return the note of {@link #consistency}; empty when nothing published was left out
   */
  public Optional<String> fault() {
    return sound ? Optional.empty() : Optional.of(consistency);
  }

  /**
   * Where vision reports a ball: the ray from the camera through the ball's centre, down (or up) to the ball plane.
   *
   * @param ballX position, m
   * @param ballY position, m
   * @param ballZ height, 0 at rest, m
   * @param ground gets x and y, m, so at least two elements; NaN if the ball is not below the camera
   */
  public void projectToGround(double ballX, double ballY, double ballZ, double[] ground) {
    double below = z - BALL_RADIUS - ballZ;
    double s = below > 0 ? (z - ballPlane) / below : Double.NaN;
    ground[0] = x + s * (ballX - x);
    ground[1] = y + s * (ballY - y);
  }

  /**
   * Derivative of {@link #projectToGround} with respect to the ball's position. The mixed derivatives dx/dy and dy/dx are zero.
   *
   * @param ballX position, m
   * @param ballY position, m
   * @param ballZ height, 0 at rest, m
   * @param jacobian gets by rows d(ground x)/d(x, y, z), d(ground y)/d(x, y, z) (–), so six elements; NaN if the ball is not below the camera
   */
  public void groundJacobian(double ballX, double ballY, double ballZ, double[] jacobian) {
    double below = z - BALL_RADIUS - ballZ;
    double s = below > 0 ? (z - ballPlane) / below : Double.NaN;
    jacobian[0] = s;
    jacobian[1] = 0;
    jacobian[2] = s / below * (ballX - x);
    jacobian[3] = 0;
    jacobian[4] = s;
    jacobian[5] = s / below * (ballY - y);
  }

  /**
   * Where the centre of a ball appears in the image.
   *
   * @param ballX position, m
   * @param ballY position, m
   * @param ballZ height, 0 at rest, m; for any other world point its height minus {@link #BALL_RADIUS}
   * @param pixel gets the image coordinates, column and row, pixels, so two elements; may lie outside the image; NaN if the point is behind the camera or beyond the fold of the lens
   * @throws IllegalStateException if only the camera's position is known
   */
  public void worldToPixel(double ballX, double ballY, double ballZ, double[] pixel) {
    requirePixels().worldToPixel(ballX, ballY, ballZ + BALL_RADIUS, pixel);
  }

  /**
   * The position of a ball of known height whose centre appears at a pixel. Vision's reported position is the answer at z = {@link #ballPlane()} −
   * {@link #BALL_RADIUS}, which is 0 unless the camera was made with another plane.
   *
   * @param u image coordinate, pixels
   * @param v image coordinate, pixels
   * @param ballZ height of the ball, 0 at rest, m; for any other world point its height minus {@link #BALL_RADIUS}
   * @param plane gets x and y, m, so two elements; NaN if the ray does not meet the plane or the pixel is beyond the fold of the lens
   * @throws IllegalStateException if only the camera's position is known
   */
  public void pixelToPlane(double u, double v, double ballZ, double[] plane) {
    requirePixels().pixelToPlane(u, v, ballZ + BALL_RADIUS, plane);
  }

  /**
   * How far a reported position moves when its pixel does: what a pixel of noise means on the ground.
   *
   * @param groundX a reported position, m
   * @param groundY a reported position, m
   * @param jacobian gets by rows d(ground x)/d(u, v), d(ground y)/d(u, v), m/pixel, so four elements; NaN if the camera cannot see the point
   * @throws IllegalStateException if only the camera's position is known
   */
  public void groundPerPixel(double groundX, double groundY, double[] jacobian) {
    requirePixels().planePerPixel(groundX, groundY, ballPlane, jacobian);
  }

  private Pinhole requirePixels() {
    if (pinhole == null) {
      throw new IllegalStateException("camera " + id + " has no pixels: " + consistency);
    }
    return pinhole;
  }

  @Override
  public String toString() {
    return "camera " + id + " at " + point(x, y, z) + ": " + consistency;
  }

  static String point(double x, double y, double z) {
    return String.format(Locale.ROOT, "(%s, %s, %s) m", metres(x), metres(y), metres(z))
        .replace('-', '−');
  }

  /** A broken coordinate may have 39 digits, which nobody wants to read. */
  private static String metres(double coordinate) {
    return String.format(
        Locale.ROOT, Math.abs(coordinate) < LONG_NUMBER ? "%.3f" : "%.3g", millimetres(coordinate));
  }

  /** Rounded to millimetres, zero without a sign. */
  private static double millimetres(double metres) {
    return Math.rint(metres * 1000) / 1000 + 0.0;
  }
}
