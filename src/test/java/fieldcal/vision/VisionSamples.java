package fieldcal.vision;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.CameraCalibration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;

/** Random values of the vision package, such as the wire can carry them: multiples of a float of millimetres. */
public final class VisionSamples {
  private final SplittableRandom random;

  public VisionSamples(long seed) {
    random = new SplittableRandom(seed);
  }

  public VisionFrame frame() {
    return frame(random.nextInt(8), random.nextInt(), random.nextDouble(0, 7200));
  }

  public VisionFrame frame(int camera, int number, double time) {
    // The wire carries Unix seconds as doubles: only multiples of 2^-22 s survive.
    double capture = Math.rint(time * 0x1p22) / 0x1p22;
    List<BallDetection> balls = new ArrayList<>();
    for (int i = random.nextInt(4); i > 0; i--) {
      balls.add(ball());
    }
    List<RobotDetection> robots = new ArrayList<>();
    for (Team team : Team.values()) {
      for (int i = random.nextInt(8); i > 0; i--) {
        robots.add(robot(team));
      }
    }
    return new VisionFrame(
        camera,
        Integer.toUnsignedLong(number),
        capture,
        capture + random.nextInt(20) * 0x1p-10,
        random.nextBoolean() ? Double.NaN : random.nextDouble(0, 1e5),
        balls,
        robots);
  }

  public BallDetection ball() {
    return new BallDetection(
        metres(6.7),
        metres(5),
        random.nextBoolean() ? Double.NaN : metres(2),
        (float) random.nextDouble(),
        random.nextInt(200),
        (float) random.nextDouble(0, 2400),
        (float) random.nextDouble(0, 2000));
  }

  public RobotDetection robot(Team team) {
    return new RobotDetection(
        new RobotId(team, random.nextInt(16)),
        metres(6.7),
        metres(5),
        random.nextInt(4) == 0 ? Double.NaN : (float) random.nextDouble(-Math.PI, Math.PI),
        (float) random.nextDouble(),
        random.nextBoolean() ? Double.NaN : 0.14);
  }

  public FieldGeometry geometry() {
    List<CameraCalibration> cameras = new ArrayList<>();
    for (int id = 0; id < 1 + random.nextInt(6); id++) {
      cameras.add(camera(id));
    }
    Optional<FlatModel> flat =
        random.nextBoolean()
            ? Optional.of(
                new FlatModel(
                    -random.nextDouble(2, 5),
                    -random.nextDouble(0.1, 0.5),
                    random.nextDouble(0.5, 0.8)))
            : Optional.empty();
    double accRoll = flat.map(FlatModel::accRoll).orElse(ChipModel.typical().accRoll());
    Optional<ChipModel> chip =
        random.nextBoolean()
            ? Optional.of(
                new ChipModel(
                    random.nextDouble(0.5, 0.9),
                    random.nextDouble(0.5, 1.0),
                    random.nextDouble(0.3, 0.6),
                    accRoll))
            : Optional.empty();
    return FieldGeometry.of(12, 9, 1.8, 0.18, 0.3, cameras)
        .withLines(
            List.of(new FieldLine("HalfwayLine", 0, -4.5, 0, 4.5, 0.01)),
            List.of(new FieldArc("CenterCircle", 0, 0, 0.5, 0, (float) (2 * Math.PI), 0.01)))
        .withModels(flat, chip);
  }

  public CameraCalibration camera(int id) {
    boolean derived = random.nextBoolean();
    return new CameraCalibration(
        id,
        (float) random.nextDouble(300, 2500),
        (float) random.nextDouble(300, 1300),
        (float) random.nextDouble(300, 1100),
        (float) random.nextDouble(-0.4, 0.4),
        (float) random.nextDouble(-1, 1),
        (float) random.nextDouble(-1, 1),
        (float) random.nextDouble(-1, 1),
        (float) random.nextDouble(-1, 1),
        metres(6),
        metres(6),
        metres(6),
        derived ? metres(6) : Double.NaN,
        derived ? metres(6) : Double.NaN,
        derived ? metres(6) : Double.NaN,
        derived ? 2448 : 0,
        derived ? 2048 : 0);
  }

  /** A length within ±range as the wire carries it. */
  public double metres(double range) {
    return (float) random.nextDouble(-1000 * range, 1000 * range) / 1000.0;
  }
}
