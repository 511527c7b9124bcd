package fieldcal.ball;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * One evaluation of a path, as the fit's inner loop makes it: 500 observations of one kick in order of time, some before the
 * kick and some after the rest. Goals: 10 ns flat, 30 ns chip, nothing allocated.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class BallTrajectoryBenchmark {
  private static final int OBSERVATIONS = 500;

  private final FlatTrajectory flat = FlatTrajectory.fromKick(FlatModel.typical(), 0, 1, 2, 4, 3);
  private final ChipTrajectory chip =
      ChipTrajectory.fromKick(ChipModel.typical(), 0, 1, 2, 3, 2, 4);
  private final double[] flatTimes = times(flat);
  private final double[] chipTimes = times(chip);
  private final double[] xyz = new double[3];
  private final double[][] rows = new double[3][ChipTrajectory.SENSITIVITIES];

  private static double[] times(BallTrajectory path) {
    double[] times = new double[OBSERVATIONS];
    for (int i = 0; i < OBSERVATIONS; i++) {
      times[i] = -0.2 + (path.restTime() + 0.4) * i / OBSERVATIONS;
    }
    return times;
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double flatPosition() {
    double sum = 0;
    for (double t : flatTimes) {
      flat.positionAt(t, xyz);
      sum += xyz[0] + xyz[1];
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double chipPosition() {
    double sum = 0;
    for (double t : chipTimes) {
      chip.positionAt(t, xyz);
      sum += xyz[0] + xyz[1] + xyz[2];
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double flatState() {
    double sum = 0;
    for (double t : flatTimes) {
      BallState state = flat.stateAt(t);
      sum += state.x() + state.vx() + state.y() + state.vy();
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double chipState() {
    double sum = 0;
    for (double t : chipTimes) {
      BallState state = chip.stateAt(t);
      sum += state.x() + state.vx() + state.y() + state.vy() + state.z() + state.vz();
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double flatSensitivities() {
    double sum = 0;
    for (double t : flatTimes) {
      flat.sensitivitiesAt(t, xyz, rows[0], rows[1]);
      sum += rows[0][FlatTrajectory.K_SWITCH] + rows[1][FlatTrajectory.VX0];
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double chipSensitivities() {
    double sum = 0;
    for (double t : chipTimes) {
      chip.sensitivitiesAt(t, xyz, rows[0], rows[1], rows[2]);
      sum += rows[0][ChipTrajectory.DAMPING_Z] + rows[1][ChipTrajectory.VX0];
    }
    return sum;
  }

  @Benchmark
  public FlatTrajectory flatFromKick() {
    return FlatTrajectory.fromKick(FlatModel.typical(), 0, flatTimes[3], 2, 4, 3);
  }

  @Benchmark
  public ChipTrajectory chipFromKick() {
    return ChipTrajectory.fromKick(ChipModel.typical(), 0, chipTimes[3], 2, 3, 2, 4);
  }
}
