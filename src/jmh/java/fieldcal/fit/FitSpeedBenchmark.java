package fieldcal.fit;

import fieldcal.kick.KickKind;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Fit of one kick with about 500 observations on one core, the CMA-ES search included, from published parameters that are 15 % off.
 * Goals for the median (p0.50): 10 ms flat, 25 ms chip.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 3)
public class FitSpeedBenchmark {
  /** Different kicks take different times. */
  private static final int KICKS = 32;

  private static final int FEWEST = 470;
  private static final int MOST = 530;
  private static final double NOISE = 0.0014;

  /** What is fitted. */
  @Param({"FLAT", "CHIP"})
  public KickKind kind;

  private final KickFitter fitter = new KickFitter(FitSettings.defaults());
  private final FitProblem[] problems = new FitProblem[KICKS];
  private int next;

  @Setup
  public void draw() {
    SplittableRandom random = new SplittableRandom(1);
    IdealKicks source = new IdealKicks(NOISE);
    int found = 0;
    for (int id = 1; found < KICKS; id++) {
      IdealKicks.Sample sample =
          source.draw(kind, id, new IdealKicks.Conditions(NOISE, 0, 0), random.split());
      int size = sample.kick().observations().size();
      if (size >= FEWEST && size <= MOST) {
        problems[found++] = KickTrial.problem(sample, source.views(), random.split());
      }
    }
  }

  @Benchmark
  public KickFit fit() {
    next = (next + 1) % KICKS;
    return fitter.fit(problems[next], kind);
  }
}
