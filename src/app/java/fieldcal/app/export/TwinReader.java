package fieldcal.app.export;

import fieldcal.app.twin.Twin;
import fieldcal.app.twin.TwinFile;
import fieldcal.simulation.imaging.InstalledCamera;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * Reads what {@code twin.json} tells of the cameras. Its ball and its robots are not taken: they hold usual values where the recordings show none, and {@code calibration.json} and {@code limits.json} have them with what is known of them.
 */
final class TwinReader {
  /** Mean of the absolute value of a normal number over its standard deviation: what the twin's spread adds to its latency. */
  private static final double HALF_NORMAL_MEAN = Math.sqrt(2 / Math.PI);

  private TwinReader() {}

  static ExportModel read(Path file) throws IOException {
    Twin twin = TwinFile.read(file);
    List<InstalledCamera> cameras = twin.settings().installed();
    Quantities quantities =
        Quantities.none()
            .with("ball_noise", rms(cameras, InstalledCamera::ballNoise))
            .with("robot_noise", rms(cameras, InstalledCamera::robotNoise))
            .with("robot_angle_noise", rms(cameras, InstalledCamera::robotAngleNoise))
            .with("missed_balls", mean(cameras, c -> c.nuisance().ballMiss()))
            .with("missed_robots", mean(cameras, c -> c.nuisance().robotMiss()))
            .with(
                "processing_time",
                mean(cameras, c -> c.latency() + HALF_NORMAL_MEAN * c.latencySpread()));
    return ExportModel.withoutBall(file, quantities, List.of(), twin.sources());
  }

  private static double mean(
      List<InstalledCamera> cameras, ToDoubleFunction<InstalledCamera> value) {
    return cameras.stream().mapToDouble(value).average().orElse(Double.NaN);
  }

  private static double rms(
      List<InstalledCamera> cameras, ToDoubleFunction<InstalledCamera> value) {
    return Math.sqrt(mean(cameras, c -> Math.pow(value.applyAsDouble(c), 2)));
  }
}
