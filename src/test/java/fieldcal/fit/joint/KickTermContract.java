package fieldcal.fit.joint;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.Parameter;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/**
 * What every {@link KickTerm} must keep: its columns are the derivatives of its residuals. A failure says which block is wrong, own or shared, and which parameter.
 *
 * @param <S> what the global parameters amount to
 */
public abstract class KickTermContract<S> {
  /** Step of the central differences, in scales: a hundredth of what the kernel steps, so that a ball hardly passes from one phase to the next within it. */
  private static final double STEP = 1e-4;

  /** A derivative whose column is that much shorter than the longest cannot be told from rounding. */
  private static final double NEGLIGIBLE = 1e-7;

  /**
   * A kick at a point.
   *
   * @param name for the report
   * @param term the kick
   * @param own its own parameters
   * @param scales typical changes of these
   * @param model the shared model
   * @param globals the global parameters, with values and scales
   * @param tolerance length of a column's error over the length of the column
   * @param <S> what the global parameters amount to
   */
  public record Case<S>(
      String name,
      KickTerm<S> term,
      double[] own,
      double[] scales,
      SharedModel<S> model,
      List<Parameter> globals,
      double tolerance) {}

  /** The kicks to be checked. */
  protected abstract List<Case<S>> cases();

  private void each(Consumer<Case<S>> check) {
    List<Case<S>> cases = cases();
    assertThat(cases).isNotEmpty();
    cases.forEach(check);
  }

  @Test
  void ownColumnsAreTheDerivativesOfTheResiduals() {
    each(
        c -> {
          S state = c.model.at(values(c));
          double[][] columns = new double[c.term.ownSize()][c.term.rows()];
          c.term.ownColumns(c.own.clone(), state, residuals(c, c.own, state), columns);
          double[][] expected = new double[columns.length][];
          for (int k = 0; k < columns.length; k++) {
            double h = STEP * c.scales[k];
            double[] up = c.own.clone();
            double[] down = c.own.clone();
            up[k] += h;
            down[k] -= h;
            expected[k] = slope(residuals(c, up, state), residuals(c, down, state), 2 * h);
          }
          compare(c, "own", columns, expected, c.scales);
        });
  }

  @Test
  void sharedColumnsAreTheDerivativesOfTheResiduals() {
    each(
        c -> {
          S state = c.model.at(values(c));
          int n = c.globals.size();
          List<Probe<S>> probes = new ArrayList<>();
          double[] scales = new double[n];
          double[][] expected = new double[n][];
          for (int k = 0; k < n; k++) {
            scales[k] = c.globals.get(k).scale();
            double step = Linearizer.DERIVATIVE_STEP * scales[k];
            // One-sided and two-sided in turn.
            S back = c.model.at(moved(c, k, -step));
            S ahead = c.model.at(moved(c, k, step));
            boolean twoSided = k % 2 == 1;
            probes.add(new Probe<>(twoSided ? back : null, ahead, (twoSided ? 2 : 1) * step));
            double h = STEP * scales[k];
            expected[k] =
                slope(
                    residuals(c, c.own, c.model.at(moved(c, k, h))),
                    residuals(c, c.own, c.model.at(moved(c, k, -h))),
                    2 * h);
          }
          double[][] columns = new double[n][c.term.rows()];
          c.term.sharedColumns(c.own.clone(), state, residuals(c, c.own, state), probes, columns);
          compare(c, "shared", columns, expected, scales);
        });
  }

  @Test
  void whatIsAskedForTwiceIsTheSame() {
    each(
        c -> {
          S state = c.model.at(values(c));
          double[] own = c.own.clone();
          assertThat(residuals(c, own, state)).isEqualTo(residuals(c, own, state));
          assertThat(own).isEqualTo(c.own);
          double[] clamped = c.own.clone();
          c.term.clamp(clamped);
          double[] twice = clamped.clone();
          c.term.clamp(twice);
          assertThat(twice).isEqualTo(clamped);
        });
  }

  private static <S> double[] values(Case<S> c) {
    return c.globals.stream().mapToDouble(Parameter::value).toArray();
  }

  private static <S> double[] moved(Case<S> c, int k, double h) {
    double[] values = values(c);
    values[k] += h;
    return values;
  }

  private static <S> double[] residuals(Case<S> c, double[] own, S state) {
    double[] out = new double[c.term.rows()];
    c.term.residuals(own, state, out);
    return out;
  }

  /** Derivative of the prediction, from residuals up and down. */
  private static double[] slope(double[] up, double[] down, double h) {
    double[] slope = new double[up.length];
    for (int i = 0; i < slope.length; i++) {
      slope[i] = (down[i] - up[i]) / h;
    }
    return slope;
  }

  private static void compare(
      Case<?> c, String block, double[][] columns, double[][] expected, double[] scales) {
    double longest = 0;
    for (int k = 0; k < columns.length; k++) {
      longest = Math.max(longest, scales[k] * length(expected[k]));
    }
    List<String> wrong = new ArrayList<>();
    for (int k = 0; k < columns.length; k++) {
      double[] error = new double[columns[k].length];
      for (int i = 0; i < error.length; i++) {
        error[i] = columns[k][i] - expected[k][i];
      }
      double allowed = c.tolerance * length(expected[k]) + NEGLIGIBLE * longest / scales[k];
      if (!(length(error) <= allowed)) {
        String name = block.equals("own") ? "" : " (" + c.globals.get(k).name() + ")";
        wrong.add(
            "%s parameter %d%s: off by %.2g of %.2g"
                .formatted(block, k, name, length(error), length(expected[k])));
      }
    }
    assertThat(wrong).as("columns of %s", c.name).isEmpty();
  }

  private static double length(double[] x) {
    return Math.sqrt(KickBlock.dot(x, x));
  }
}
