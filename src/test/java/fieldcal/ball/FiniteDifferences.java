package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.Function;

/** Compares a path's own sensitivities with central differences of its positions. */
final class FiniteDifferences {
  /** Best step of a central difference of fourth order: (machine epsilon)^(1/5), relative to the size of the number. */
  private static final double STEP = 7e-4;

  private FiniteDifferences() {}

  /**
   * Checks one column of the Jacobian.
   *
   * @param path makes the path from the numbers
   * @param numbers the numbers behind the path
   * @param index which number to vary
   * @param t time at which the ball is observed
   * @param actual the derivatives of x, y and z by that number
   * @param tolerance largest error
   * @param label said on failure
   */
  static void check(
      Function<double[], BallTrajectory> path,
      double[] numbers,
      int index,
      double t,
      double[] actual,
      double tolerance,
      String label) {
    double step = STEP * Math.max(0.1, Math.abs(numbers[index]));
    double[][] at = new double[5][];
    for (int i = -2; i <= 2; i++) {
      double[] varied = numbers.clone();
      varied[index] += i * step;
      at[i + 2] = new double[3];
      path.apply(varied).positionAt(t, at[i + 2]);
    }
    for (int axis = 0; axis < 3; axis++) {
      double expected =
          (at[0][axis] - 8 * at[1][axis] + 8 * at[3][axis] - at[4][axis]) / (12 * step);
      assertThat(actual[axis])
          .as("%s: d%s by number %d at t = %s", label, "xyz".charAt(axis), index, t)
          .isCloseTo(expected, within(tolerance * Math.max(1, Math.abs(expected))));
    }
  }
}
