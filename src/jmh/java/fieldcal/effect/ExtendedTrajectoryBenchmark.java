package fieldcal.effect;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.FieldSlope;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Making a path with effects: goal 20 µs for a flat kick of 8 s. Asking it is {@link ExtendedQueryBenchmark}. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 3, time = 1)
public class ExtendedTrajectoryBenchmark {
  private final FlatModel flat = new FlatModel(-3.1, -0.28, 0.65);
  private final ChipModel chip = ChipModel.typical();
  private final MotionEffects one = MotionEffects.of(List.of(new AirDrag(0.1)));
  private final MotionEffects three =
      MotionEffects.of(List.of(new AirDrag(0.1), new CarpetNap(0.05, 1), new FieldSlope(0.2, 1)));

  private ExtendedTrajectory flat(MotionEffects effects) {
    return ExtendedTrajectory.flat(flat, effects, 0, 0, 1, 2, 3.6, 2.4);
  }

  /**
   * Nothing acts.
   *
   * @return the path
   */
  @Benchmark
  public ExtendedTrajectory flatWithoutEffects() {
    return flat(MotionEffects.NONE);
  }

  /**
   * One effect.
   *
   * @return the path
   */
  @Benchmark
  public ExtendedTrajectory flatWithOneEffect() {
    return flat(one);
  }

  /**
   * Three effects.
   *
   * @return the path
   */
  @Benchmark
  public ExtendedTrajectory flatWithThreeEffects() {
    return flat(three);
  }

  /**
   * A chip.
   *
   * @return the path
   */
  @Benchmark
  public ExtendedTrajectory chipWithThreeEffects() {
    return ExtendedTrajectory.chip(chip, flat, three, 0, 0, 1, 2, 3, 2, 4);
  }
}
