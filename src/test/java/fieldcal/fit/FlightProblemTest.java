package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The analytic normal equations against finite differences of what is minimised. */
class FlightProblemTest {
  private static final IdealKicks.Conditions SOME_WRONG =
      new IdealKicks.Conditions(0.002, 0.05, 0.2);

  private final IdealKicks source = new IdealKicks(SOME_WRONG.noise());

  private record Set(FlightProblem problem, double[] theta, double[] scale) {}

  /** Near the truth, where residuals are some millimetres. */
  private Set set(KickKind kind, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    IdealKicks.Sample s = source.draw(kind, 1, SOME_WRONG, random.split());
    FlightData data = FlightData.of(s.kick().observations(), source.views());
    FlightCurve curve =
        kind == KickKind.FLAT ? new FlightCurve.Flat() : new FlightCurve.Chip(s.flights());
    int size = s.truth().length;
    FlightProblem problem = new FlightProblem(data, curve, size);
    List<Parameter> parameters =
        FlightLayout.parameters(
            kind,
            s.truth(),
            kind == KickKind.FLAT
                ? FlightLayout.flatModel(s.truth()).parameters()
                : FlightLayout.chipModel(s.truth()).parameters());
    double[] theta = new double[size];
    double[] scale = new double[size];
    for (int k = 0; k < size; k++) {
      scale[k] = parameters.get(k).scale();
      theta[k] = s.truth()[k] + 0.02 * scale[k] * random.nextDouble(-1, 1);
    }
    return new Set(problem, theta, scale);
  }

  @ParameterizedTest
  @CsvSource({"FLAT, Infinity", "FLAT, 2.4", "CHIP, Infinity", "CHIP, 2.4"})
  void theGradientIsThatOfTheCost(KickKind kind, double loss) {
    for (long seed = 1; seed <= 5; seed++) {
      Set set = set(kind, seed);
      FlightProblem problem = set.problem();
      problem.lossScale(loss);
      problem.prior(2, set.theta()[2] + 0.03, 0.01);
      NormalEquations equations = new NormalEquations(problem.size());
      problem.linearize(set.theta(), equations);
      assertThat(equations.cost)
          .isEqualTo(problem.cost(set.theta()), within(1e-9 * equations.cost));
      for (int k = 0; k < problem.size(); k++) {
        // Where a detection passes from one phase to the next, within the step, the difference
        // errs; so the step is small.
        double h = 1e-6 * set.scale()[k];
        double[] at = set.theta().clone();
        at[k] += h;
        double up = problem.cost(at);
        at[k] -= 2 * h;
        double slope = (up - problem.cost(at)) / (2 * h);
        double size = Math.sqrt(equations.cost * equations.a[k][k]);
        assertThat(-2 * equations.b[k])
            .as("unknown %d, seed %d", k, seed)
            .isEqualTo(slope, within(2e-5 * size + 1e-6 * Math.abs(slope)));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(KickKind.class)
  void theMatrixIsThatOfTheResiduals(KickKind kind) {
    Set set = set(kind, 7);
    FlightProblem problem = set.problem();
    FlightData data = problem.data();
    int n = problem.size();
    double[][] j1 = new double[n][data.size];
    double[][] j2 = new double[n][data.size];
    double[][] r = new double[4][data.size];
    for (int k = 0; k < n; k++) {
      double h = 1e-5 * set.scale()[k];
      double[] at = set.theta().clone();
      at[k] += h;
      problem.residuals(at, r[0], r[1]);
      at[k] -= 2 * h;
      problem.residuals(at, r[2], r[3]);
      for (int i = 0; i < data.size; i++) {
        double dx = (r[2][i] - r[0][i]) / (2 * h);
        double dy = (r[3][i] - r[1][i]) / (2 * h);
        j1[k][i] = data.w11[i] * dx;
        j2[k][i] = data.w21[i] * dx + data.w22[i] * dy;
      }
    }
    NormalEquations equations = new NormalEquations(n);
    problem.linearize(set.theta(), equations);
    for (int k = 0; k < n; k++) {
      for (int m = 0; m <= k; m++) {
        double sum = 0;
        for (int i = 0; i < data.size; i++) {
          sum += j1[k][i] * j1[m][i] + j2[k][i] * j2[m][i];
        }
        double size = Math.sqrt(equations.a[k][k] * equations.a[m][m]);
        assertThat(equations.a[k][m]).as("%d, %d", k, m).isEqualTo(sum, within(1e-4 * size));
      }
    }
  }

  @Test
  void whatIsNotUsedDoesNotCount() {
    Set set = set(KickKind.FLAT, 3);
    FlightProblem problem = set.problem();
    FlightData data = problem.data();
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    problem.residuals(set.theta(), rx, ry);
    double all = problem.cost(set.theta());
    problem.used()[5] = false;
    assertThat(all - problem.cost(set.theta()))
        .isEqualTo(data.squared(5, rx[5], ry[5]), within(1e-9 * all));
    NormalEquations equations = new NormalEquations(problem.size());
    problem.linearize(set.theta(), equations);
    assertThat(equations.cost).isEqualTo(problem.cost(set.theta()), within(1e-9 * all));
  }

  @Test
  void cauchysLossIsNearlyQuadraticForSmallResidualsAndBoundedGrowthForLarge() {
    Set set = set(KickKind.FLAT, 4);
    FlightProblem problem = set.problem();
    double plain = problem.cost(set.theta());
    problem.lossScale(1e4);
    assertThat(problem.cost(set.theta())).isEqualTo(plain, within(1e-2 * plain));
    problem.lossScale(2.4);
    assertThat(problem.cost(set.theta())).isLessThan(0.5 * plain);
  }
}
