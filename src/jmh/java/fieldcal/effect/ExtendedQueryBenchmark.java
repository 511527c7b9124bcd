package fieldcal.effect;

import fieldcal.ball.BallState;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.FieldSlope;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** What an AI asks of a path with three effects, at moments and distances in no order: goal 1 µs per query. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 3, time = 1)
public class ExtendedQueryBenchmark {
  private static final int MASK = 1023;

  /** Which kick. */
  @Param({"flat", "chip"})
  public String kick;

  private final double[] times = new double[MASK + 1];
  private final double[] distances = new double[MASK + 1];
  private final double[] xyz = new double[3];
  private ExtendedTrajectory path;
  private int next;

  /** Makes the path and the questions. */
  @Setup
  public void prepare() {
    ExtendedModel model =
        new ExtendedModel(
            Optional.of(new FlatModel(-3.1, -0.28, 0.65)),
            Optional.of(ChipModel.typical()),
            List.of(new AirDrag(0.45), new CarpetNap(0.05, 1), new FieldSlope(0.2, 1)),
            0);
    path =
        kick.equals("flat") ? model.flatPath(0, 1, 2, 3.6, 2.4) : model.chipPath(0, 1, 2, 3, 2, 4);
    double way = path.distanceAt(path.restTime());
    Random random = new Random(1);
    for (int i = 0; i <= MASK; i++) {
      times[i] = random.nextDouble() * path.restTime();
      distances[i] = random.nextDouble() * way;
    }
  }

  /**
   * Where is the ball, into an array of the caller's.
   *
   * @return x, m
   */
  @Benchmark
  public double position() {
    path.positionAt(times[next++ & MASK], xyz);
    return xyz[0];
  }

  /**
   * Where is it, and how fast.
   *
   * @return the state
   */
  @Benchmark
  public BallState state() {
    return path.stateAt(times[next++ & MASK]);
  }

  /**
   * When does it rest.
   *
   * @return s
   */
  @Benchmark
  public double restTime() {
    return path.restTime();
  }

  /**
   * When is it there.
   *
   * @return s
   */
  @Benchmark
  public OptionalDouble timeAtDistance() {
    return path.timeAtDistance(distances[next++ & MASK]);
  }
}
