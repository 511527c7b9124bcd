package fieldcal.effect.learned;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class BasisTest {
  private static final double EXACT = 1e-12;

  static List<Basis> all() {
    List<Basis> all = new ArrayList<>();
    for (boolean centred : new boolean[] {true, false}) {
      for (int knots : new int[] {3, 4, 7}) {
        all.add(new Spline(-1, 6, knots, centred));
      }
      all.add(new Surface(new Spline(-6, 6, 4, false), new Spline(-4, 4, 3, false), centred));
    }
    all.add(new Stripes(new Spline(-6, 6, 13, true), new Spline(-4, 4, 9, true)));
    all.add(Harmonics.ofAngle(1));
    all.add(Harmonics.ofAngle(4));
    all.add(new Polynomial(3, -3, 2, -1, 5, true));
    all.add(new Polynomial(3, -3, 2, -1, 5, false));
    all.add(new Polynomial(1, -3, 2, -1, 5, true));
    all.add(new Polynomial(2, -3, 2, -1, 5, false));
    all.add(new Levels(2, 3));
    return all;
  }

  @ParameterizedTest
  @MethodSource("all")
  void aCurveIsTheLinearCombinationOfTheFunctions(Basis basis) {
    double[] coefficients = new double[basis.size() + 2];
    for (int i = 0; i < coefficients.length; i++) {
      coefficients[i] = Math.sin(1 + 3 * i);
    }
    Basis.Curve curve = basis.curve(coefficients, 1);
    double[] values = new double[basis.size()];
    for (double u = -8; u < 9; u += 0.37) {
      for (double v = -6; v < 7; v += 1.1) {
        basis.values(u, v, values);
        double sum = 0;
        for (int i = 0; i < values.length; i++) {
          sum += coefficients[i + 1] * values[i];
        }
        assertThat(curve.at(u, v)).isEqualTo(sum, within(EXACT));
      }
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void aFinerBasisHasTheSameCurve(Basis basis) {
    boolean isFixed = basis instanceof Harmonics || basis instanceof Levels;
    assertThat(basis.finer().isEmpty()).isEqualTo(isFixed);
    if (isFixed) {
      assertThatThrownBy(() -> basis.inFiner(new double[basis.size()], 0))
          .isInstanceOf(UnsupportedOperationException.class)
          .hasMessageContaining(basis.type());
      return;
    }
    Basis finer = basis.finer().orElseThrow();
    assertThat(finer.size()).isGreaterThan(basis.size() + basis.dimension());
    double[] coefficients = new double[basis.size() + 2];
    for (int i = 0; i < coefficients.length; i++) {
      coefficients[i] = Math.sin(1 + 3 * i);
    }
    Basis.Curve coarse = basis.curve(coefficients, 1);
    Basis.Curve same = finer.curve(basis.inFiner(coefficients, 1), 0);
    for (double u = -8; u < 9; u += 0.37) {
      for (double v = -6; v < 7; v += 1.1) {
        assertThat(same.at(u, v)).isEqualTo(coarse.at(u, v), within(EXACT));
      }
    }
  }

  @Test
  void whatHasManyFunctionsIsNotMadeFiner() {
    assertThat(new Polynomial(5, 0, 1, 0, 1, true).finer()).isEmpty();
    assertThat(new Spline(0, 1, 17, true).finer()).isEmpty();
    Spline side = new Spline(0, 1, 7, false);
    assertThat(new Surface(side, side, true).finer()).isEmpty();
  }

  @Test
  void splinesAddUpToOneEverywhere() {
    for (Basis basis : all()) {
      boolean partition =
          basis instanceof Spline s && !s.centred() || basis instanceof Surface f && !f.centred();
      if (partition) {
        double[] values = new double[basis.size()];
        for (double u = -9; u < 9; u += 0.13) {
          basis.values(u, 0.3 * u, values);
          double sum = 0;
          for (double value : values) {
            assertThat(value).isBetween(0.0, 1.0);
            sum += value;
          }
          assertThat(sum).isEqualTo(1, within(EXACT));
        }
      }
    }
  }

  /** The mean of each function over the range, here by the midpoint rule. */
  @Test
  void centredFunctionsHaveNoConstant() {
    for (Basis basis : all()) {
      boolean centred =
          basis instanceof Spline s && s.centred()
              || basis instanceof Surface f && f.centred()
              || basis instanceof Stripes;
      if (centred) {
        double[] sum = new double[basis.size()];
        double[] values = new double[basis.size()];
        int n = 0;
        double from = basis instanceof Spline ? -1 : -6;
        for (double u = from + 0.005; u < 6; u += 0.01) {
          for (double v = -3.95; v < 4; v += basis.dimension() == 1 ? 100 : 0.1) {
            basis.values(u, v, values);
            n++;
            for (int i = 0; i < sum.length; i++) {
              sum[i] += values[i];
            }
          }
        }
        for (double s : sum) {
          assertThat(s / n).isEqualTo(0, within(1e-4));
        }
      }
    }
  }

  @Test
  void splinesAreLevelAtTheEndsAndSmoothWithin() {
    Spline spline = new Spline(0, 5, 6, true);
    Basis.Curve curve = spline.curve(new double[] {0.3, -1, 0.5, 0.8, -0.2}, 0);
    assertThat(curve.at(-3, 0)).isEqualTo(curve.at(0, 0));
    assertThat(curve.at(9, 0)).isEqualTo(curve.at(5, 0));
    double h = 1e-4;
    assertThat((curve.at(h, 0) - curve.at(0, 0)) / h).isEqualTo(0, within(1e-3));
    for (double knot = 1; knot < 5; knot++) {
      double before = curve.at(knot, 0) - 2 * curve.at(knot - h, 0) + curve.at(knot - 2 * h, 0);
      double after = curve.at(knot + 2 * h, 0) - 2 * curve.at(knot + h, 0) + curve.at(knot, 0);
      assertThat(after / h / h).isEqualTo(before / h / h, within(1e-2));
    }
  }

  /** Legendre polynomials are 1 at the end of the range, and orthogonal over it; here by the midpoint rule. */
  @Test
  void polynomialsAreThoseOfLegendre() {
    Polynomial basis = new Polynomial(5, -1, 1, -1, 1, false);
    double[] values = new double[basis.size()];
    basis.values(1, 1, values);
    assertThat(values).containsOnly(1);
    double[][] products = new double[values.length][values.length];
    double h = 0.01;
    for (double u = -1 + h / 2; u < 1; u += h) {
      for (double v = -1 + h / 2; v < 1; v += h) {
        basis.values(u, v, values);
        for (int i = 0; i < values.length; i++) {
          for (int j = 0; j < i; j++) {
            products[i][j] += values[i] * values[j] * h * h;
          }
        }
      }
    }
    for (double[] row : products) {
      for (double product : row) {
        assertThat(product).isEqualTo(0, within(1e-3));
      }
    }
  }

  @Test
  void refusesWhatIsNoRange() {
    Spline whole = new Spline(0, 1, 3, false);
    assertThatThrownBy(() -> new Stripes(whole, whole)).hasMessageContaining("centred");
    assertThatThrownBy(() -> new Spline(1, 1, 5, true)).hasMessageStartingWith("range:");
    assertThatThrownBy(() -> new Spline(Double.NaN, 1, 5, true)).hasMessageStartingWith("range:");
    assertThatThrownBy(() -> new Spline(0, 1, 2, true)).hasMessageStartingWith("knots:");
    assertThatThrownBy(() -> new Harmonics(5, 1)).hasMessageStartingWith("order:");
    assertThatThrownBy(() -> new Harmonics(1, 0)).hasMessageStartingWith("period:");
    assertThatThrownBy(() -> new Polynomial(6, 0, 1, 0, 1, true)).hasMessageStartingWith("degree:");
    assertThatThrownBy(() -> new Levels(1, 0)).hasMessageStartingWith("count:");
  }
}
