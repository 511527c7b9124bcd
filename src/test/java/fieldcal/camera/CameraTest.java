package fieldcal.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class CameraTest {

  private static final double NAN = Double.NaN;

  /** Half a turn about x: the camera looks straight down, image x along world x, image y against world y. */
  private static final double[] DOWN = {1, 0, 0, 0};

  /** Calibration of a camera at a place; the translation is made to fit, the published position is absent. */
  private static CameraCalibration at(double[] q, double distortion, double x, double y, double z) {
    CameraCalibration origin =
        new CameraCalibration(
            7, 1800, 1224, 1024, distortion, q[0], q[1], q[2], q[3], 0, 0, 1, NAN, NAN, NAN, 0, 0);
    double[] t = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      // t = −R·C, and the position that follows from a unit translation along an axis is minus that
      // row of R.
      double[] unit = new double[3];
      unit[axis] = 1;
      Pinhole row = Pinhole.of(moved(origin, unit));
      t[axis] = row.cameraX * x + row.cameraY * y + row.cameraZ * z;
    }
    return moved(origin, t);
  }

  private static CameraCalibration moved(CameraCalibration c, double[] t) {
    return c.withPosition(t, new double[] {NAN, NAN, NAN});
  }

  /** A camera 3 to 7 m high that looks down with up to 0.3 of tilt and any yaw. */
  private static Camera random(Random random) {
    double yaw = random.nextDouble() * 2 * Math.PI;
    double[] q = {
      Math.cos(yaw) * 1.7,
      Math.sin(yaw) * 1.7,
      0.3 * (random.nextDouble() - 0.5),
      0.3 * (random.nextDouble() - 0.5)
    };
    double distortion = 0.5 * (random.nextDouble() - 0.3);
    return Camera.of(
        at(
            q,
            distortion,
            6 * random.nextDouble() - 3,
            random.nextDouble(),
            3 + 4 * random.nextDouble()));
  }

  static Stream<Long> seeds() {
    return LongStream.rangeClosed(1, 200).boxed();
  }

  @Test
  void looksStraightDown() {
    Camera camera = Camera.of(at(DOWN, 0, 1, 2, 4 + Camera.BALL_RADIUS));
    double[] pixel = new double[2];
    camera.worldToPixel(1, 2, 0, pixel);
    assertThat(pixel).containsExactly(new double[] {1224, 1024}, within(1e-9));
    camera.worldToPixel(3, 2, 0, pixel);
    assertThat(pixel).containsExactly(new double[] {1224 + 900, 1024}, within(1e-9));
    camera.worldToPixel(1, 3, 0, pixel);
    assertThat(pixel).containsExactly(new double[] {1224, 1024 - 450}, within(1e-9));
    camera.worldToPixel(1, 3, 2, pixel);
    assertThat(pixel).containsExactly(new double[] {1224, 1024 - 900}, within(1e-9));
    assertThat(camera.heightAboveBallPlane()).isCloseTo(4, within(1e-12));
  }

  /** The formula on the image's side is a polynomial, so a distorted point can be computed by hand. */
  @ParameterizedTest
  @ValueSource(doubles = {0.2, 1e-12, 0, -1e-12, -0.1})
  void distortsRadially(double k) {
    Camera camera = Camera.of(at(DOWN, k, 0, 0, 4 + Camera.BALL_RADIUS));
    double rd = 0.9;
    double ru = rd * (1 + k * rd * rd);
    double[] pixel = new double[2];
    camera.worldToPixel(4 * ru * 0.6, 4 * ru * 0.8, 0, pixel);
    assertThat(pixel)
        .containsExactly(
            new double[] {1224 + 1800 * rd * 0.6, 1024 - 1800 * rd * 0.8}, within(1e-8));
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void returnsFromTheImage(long seed) {
    Random random = new Random(seed);
    Camera camera = random(random);
    for (int i = 0; i < 50; i++) {
      double x = camera.positionX() + 5 * (random.nextDouble() - 0.5);
      double y = camera.positionY() + 5 * (random.nextDouble() - 0.5);
      double z = random.nextDouble();
      double[] pixel = new double[2];
      double[] plane = new double[2];
      camera.worldToPixel(x, y, z, pixel);
      if (Double.isNaN(pixel[0])) {
        continue; // beyond the fold of a strong negative lens; its own test is below
      }
      camera.pixelToPlane(pixel[0], pixel[1], z, plane);
      assertThat(plane).as("seed %d", seed).containsExactly(new double[] {x, y}, within(1e-9));
      double[] ground = new double[2];
      camera.projectToGround(x, y, z, ground);
      camera.pixelToPlane(pixel[0], pixel[1], camera.ballPlane() - Camera.BALL_RADIUS, plane);
      assertThat(ground).as("seed %d", seed).containsExactly(plane, within(1e-9));
    }
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void derivativesAreThoseOfTheFunctions(long seed) {
    Random random = new Random(seed);
    Camera camera = random(random).withBallPlane(0.03);
    double[] at = {
      camera.positionX() + 2 * random.nextDouble() - 1,
      camera.positionY() + 2 * random.nextDouble() - 1,
      random.nextDouble()
    };
    double[] jacobian = new double[6];
    camera.groundJacobian(at[0], at[1], at[2], jacobian);
    double step = 1e-5;
    for (int axis = 0; axis < 3; axis++) {
      double[] plus = at.clone();
      double[] minus = at.clone();
      plus[axis] += step;
      minus[axis] -= step;
      double[] ahead = new double[2];
      double[] behind = new double[2];
      camera.projectToGround(plus[0], plus[1], plus[2], ahead);
      camera.projectToGround(minus[0], minus[1], minus[2], behind);
      for (int row = 0; row < 2; row++) {
        assertThat(jacobian[3 * row + axis])
            .as("seed %d", seed)
            .isCloseTo((ahead[row] - behind[row]) / (2 * step), within(1e-6));
      }
    }

    double onPlane = camera.ballPlane() - Camera.BALL_RADIUS;
    double[] pixel = new double[2];
    camera.worldToPixel(at[0], at[1], onPlane, pixel);
    double[] perPixel = new double[4];
    camera.groundPerPixel(at[0], at[1], perPixel);
    for (int axis = 0; axis < 2; axis++) {
      double[] ahead = new double[2];
      double[] behind = new double[2];
      double h = 0.01;
      camera.pixelToPlane(
          pixel[0] + (axis == 0 ? h : 0), pixel[1] + (axis == 1 ? h : 0), onPlane, ahead);
      camera.pixelToPlane(
          pixel[0] - (axis == 0 ? h : 0), pixel[1] - (axis == 1 ? h : 0), onPlane, behind);
      for (int row = 0; row < 2; row++) {
        assertThat(perPixel[2 * row + axis])
            .as("seed %d", seed)
            .isCloseTo((ahead[row] - behind[row]) / (2 * h), within(1e-8));
      }
    }
  }

  @Test
  void aFlyingBallIsReportedFurtherOut() {
    Camera camera = Camera.ofPosition(0, 1, -1, 4 + Camera.BALL_RADIUS);
    double[] ground = new double[2];
    camera.projectToGround(3, -2, 0, ground);
    assertThat(ground).containsExactly(3, -2);
    camera.projectToGround(3, -2, 1, ground);
    assertThat(ground).containsExactly(new double[] {1 + 2 * 4 / 3.0, -1 - 4 / 3.0}, within(1e-12));
  }

  /** A vision that assumes 30 mm reports a resting ball 8.5 mm · tan(angle) too near to the camera's foot. */
  @Test
  void anotherBallPlaneShiftsARestingBall() {
    Camera camera = Camera.ofPosition(0, 0, 0, 4 + Camera.BALL_RADIUS).withBallPlane(0.030);
    double[] ground = new double[2];
    camera.projectToGround(4, 0, 0, ground);
    assertThat(ground).containsExactly(new double[] {4 - 0.0085, 0}, within(1e-12));
    assertThat(camera.heightAboveBallPlane()).isCloseTo(4 - 0.0085, within(1e-12));
  }

  @Test
  void whatCannotBeSeenIsNaN() {
    Camera camera = Camera.of(at(DOWN, -0.1, 0, 0, 4 + Camera.BALL_RADIUS));
    double[] out = new double[6];
    camera.projectToGround(1, 1, 4, out);
    assertThat(out[0]).isNaN();
    camera.groundJacobian(1, 1, 5, out);
    assertThat(out[0]).isNaN();
    camera.worldToPixel(1, 1, 5, out);
    assertThat(out[0]).isNaN();
    double fold = 1 / Math.sqrt(0.3);
    camera.worldToPixel(4 * fold * 2 / 3 * 1.001, 0, 0, out);
    assertThat(out[0]).isNaN();
    camera.worldToPixel(4 * fold * 2 / 3 * 0.999, 0, 0, out);
    assertThat(out[0]).isBetween(1224 + 1800 * fold * 0.9, 1224 + 1800 * fold);
    camera.pixelToPlane(1224 + 1800 * fold * 1.001, 1024, 0, out);
    assertThat(out[0]).isNaN();
    camera.pixelToPlane(1224, 1024, 4.1, out);
    assertThat(out[0]).isNaN();
  }

  /** What the ER-Force simulator publishes of its camera 0 (recording of 2026-11): only the derived position is meant. */
  @Test
  void placeholdersLeaveThePosition() {
    Camera camera =
        Camera.of(
            new CameraCalibration(
                0, 390, 300, 300, 0.2, 0.7, 0.7, 0.7, 0.7, 0, 0, 3.5, -2.918, -0.039, 6.007, 0, 0));
    assertThat(camera.poseSource()).isEqualTo(PoseSource.DERIVED_POSITION);
    assertThat(camera.hasPixels()).isFalse();
    assertThat(camera.positionX()).isEqualTo(-2.918);
    assertThat(camera.positionZ()).isEqualTo(6.007);
    assertThat(camera.consistency()).endsWith("only the published position is used");
    assertThatIllegalStateException()
        .isThrownBy(() -> camera.worldToPixel(0, 0, 0, new double[2]))
        .withMessageContaining("camera 0 has no pixels");
  }

  @Test
  void aPoseThatFitsIsUsed() {
    CameraCalibration pose = at(DOWN, 0.1, -3, 2, 5);
    double[] t = {pose.tx(), pose.ty(), pose.tz()};
    Camera near = Camera.of(pose.withPosition(t, new double[] {-3, 2.02, 5}));
    assertThat(near.poseSource()).isEqualTo(PoseSource.CALIBRATION);
    assertThat(near.positionY()).isCloseTo(2, within(1e-12));
    assertThat(near.consistency()).isEqualTo("rotation and published position agree to 20.00 mm");

    Camera far = Camera.of(pose.withPosition(t, new double[] {-3, 2, 5.2}));
    assertThat(far.poseSource()).isEqualTo(PoseSource.DERIVED_POSITION);
    assertThat(far.consistency())
        .isEqualTo(
            "by its published rotation the camera is at (−3.000, 2.000, 5.000) m, 0.20 m from its"
                + " published position (−3.000, 2.000, 5.200) m; only the published position is"
                + " used");

    Camera zero = Camera.of(pose.withPosition(t, new double[] {0, 0, 0}));
    assertThat(zero.poseSource()).isEqualTo(PoseSource.CALIBRATION);
    Camera absent = Camera.of(pose);
    assertThat(absent.poseSource()).isEqualTo(PoseSource.CALIBRATION);
    assertThat(absent.consistency()).startsWith("no position is published");
    assertThat(List.of(near, zero, absent)).allMatch(c -> c.fault().isEmpty());
    assertThat(far.fault()).hasValue(far.consistency());
  }

  @Test
  void whatIsNotUsedIsNamed() {
    CameraCalibration pose = at(DOWN, 0.1, -3, 2, 5);
    double[] t = {pose.tx(), pose.ty(), pose.tz()};
    assertThat(Camera.faultOf(pose)).isEmpty();
    assertThat(Camera.faultOf(pose.withPosition(t, new double[] {1e35, 2, 5})))
        .hasValue(
            "the published position (1.00e+35, 2.000, 5.000) m is too far from the field; the"
                + " position that follows from the rotation is used");
    CameraCalibration high = at(DOWN, 0.1, -3, 2, 200);
    assertThat(
            Camera.faultOf(
                high.withPosition(
                    new double[] {high.tx(), high.ty(), high.tz()}, new double[] {-3, 2, 200})))
        .hasValue(
            "no usable position: by its published rotation the camera is at (−3.000, 2.000,"
                + " 200.000) m, too far from the field, and the published position (−3.000, 2.000,"
                + " 200.000) m is too far from the field");
    assertThat(Camera.of(pose).withoutPixels("a lens").fault())
        .hasValue("a lens; only the position is used");
  }

  @Test
  void noPoseAndNoPositionIsRefused() {
    CameraCalibration noRotation = at(DOWN, 0, 0, 0, 4);
    CameraCalibration zero =
        new CameraCalibration(7, 500, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, NAN, NAN, NAN, 0, 0);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Camera.of(zero))
        .withMessageContaining("camera 7: no usable position");
    CameraCalibration underground =
        moved(noRotation, new double[] {noRotation.tx(), noRotation.ty(), -4});
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Camera.of(underground))
        .withMessageContaining("not above the field");
    assertThatIllegalArgumentException().isThrownBy(() -> Camera.ofPosition(0, NAN, 0, 4));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Camera.ofPosition(0, 0, 0, 4).withBallPlane(NAN));
  }
}
