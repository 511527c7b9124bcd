package fieldcal.fit;

import fieldcal.kick.KickKind;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The fit's inner loop, per observation, robust and plain. With {@code -prof gc}: the path is made again for each evaluation (about a
 * kilobyte), the observations allocate nothing.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class FlightProblemBenchmark {
  private static final int OBSERVATIONS = 400;

  /** What is fitted. */
  @Param({"FLAT", "CHIP"})
  public KickKind kind;

  /** Scale of Cauchy's loss; infinite for plain least squares. */
  @Param({"2.4", "Infinity"})
  public double lossScale;

  private FlightProblem problem;
  private FlightProblem twice;
  private NormalEquations equations;
  private double[] truth;

  @Setup
  public void draw() {
    SplittableRandom random = new SplittableRandom(1);
    double noise = 0.0014;
    IdealKicks source = new IdealKicks(noise);
    IdealKicks.Sample sample;
    do {
      sample = source.draw(kind, 1, new IdealKicks.Conditions(noise, 0, 0), random.split());
    } while (sample.kick().observations().size() < OBSERVATIONS);
    truth = sample.truth();
    FlightData data = FlightData.of(sample.kick().observations(), source.views());
    problem = problem(data, sample, 1);
    twice = problem(data, sample, 2);
    equations = new NormalEquations(truth.length);
  }

  private FlightProblem problem(FlightData data, IdealKicks.Sample sample, int times) {
    int[] index = new int[OBSERVATIONS * times];
    Arrays.setAll(index, i -> i / times);
    FlightCurve curve =
        kind == KickKind.FLAT ? new FlightCurve.Flat() : new FlightCurve.Chip(sample.flights());
    FlightProblem made = new FlightProblem(data.pick(index), curve, sample.truth().length);
    made.lossScale(lossScale);
    return made;
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double cost() {
    return problem.cost(truth);
  }

  /** Twice as many observations: allocates as much per evaluation as {@link #cost}, so half as much per observation. */
  @Benchmark
  @OperationsPerInvocation(2 * OBSERVATIONS)
  public double costOfTwiceAsMany() {
    return twice.cost(truth);
  }

  @Benchmark
  @OperationsPerInvocation(OBSERVATIONS)
  public double linearize() {
    problem.linearize(truth, equations);
    return equations.cost;
  }
}
