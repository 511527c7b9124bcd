package fieldcal.camera;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** What one projection costs; the ground projection runs once per detection in a fit's inner loop. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 3, time = 1)
public class CameraBenchmark {

  private final Camera camera =
      Camera.of(
          new CameraCalibration(
              0,
              1800,
              1224,
              1024,
              0.1,
              1,
              0.01,
              0,
              0,
              3,
              -2,
              5,
              Double.NaN,
              Double.NaN,
              Double.NaN,
              0,
              0));
  private final double[] out = new double[6];
  private double x = 1;
  private double z = 0.3;

  @Benchmark
  public double[] projectToGround() {
    camera.projectToGround(x, -0.5, z, out);
    return out;
  }

  @Benchmark
  public double[] groundJacobian() {
    camera.groundJacobian(x, -0.5, z, out);
    return out;
  }

  @Benchmark
  public double[] worldToPixel() {
    camera.worldToPixel(x, -0.5, z, out);
    return out;
  }

  @Benchmark
  public double[] pixelToPlane() {
    camera.pixelToPlane(900, 700, z, out);
    return out;
  }

  @Benchmark
  public double[] groundPerPixel() {
    camera.groundPerPixel(x, -0.5, out);
    return out;
  }
}
