package fieldcal.effect.learned;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.effect.learned.LearnedCurve.Point;
import fieldcal.effect.learned.LearnedCurve.Support;
import fieldcal.effect.learned.SimpleFormula.Kind;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.api.Test;

class SimpleFormulaTest {
  private static final LearnedFamily SPEED =
      LearnedFamily.of(Quantity.ACCELERATION_ALONG, Variable.SPEED, new Spline(0, 6, 6, true));
  private static final LearnedFamily HEADING =
      LearnedFamily.of(Quantity.ACCELERATION_ALONG, Variable.HEADING, Harmonics.ofAngle(2));
  private static final LearnedFamily PLACE =
      LearnedFamily.of(
          Quantity.ACCELERATION_ALONG,
          Variable.PLACE,
          new Surface(new Spline(-6, 6, 4, false), new Spline(-4, 4, 3, false), true));

  private static final LearnedFamily QUARTERS =
      LearnedFamily.of(Quantity.SLIDING, Variable.HEADING, new Harmonics(3, Math.PI / 2));

  private static final double ERROR = 0.004;

  /** Exact points with an error. */
  private static SimpleFormula formula(LearnedFamily family, DoubleBinaryOperator law) {
    List<Point> points = new ArrayList<>();
    boolean table = family.basis().dimension() == 2;
    double end = family == HEADING || family == QUARTERS ? Math.PI : 6;
    double begin = family == SPEED ? 0.5 : -end;
    for (double y = table ? -4 : 0; y <= (table ? 4 : 0); y++) {
      for (int i = 0; i <= 32; i++) {
        double x = begin + (end - begin) * i / 32;
        points.add(new Point(x, y, law.applyAsDouble(x, y), ERROR));
      }
    }
    return SimpleFormula.of(new LearnedCurve(family, 0, points));
  }

  private static SimpleFormula ofSpeed(DoubleUnaryOperator law) {
    return formula(SPEED, (x, y) -> law.applyAsDouble(x));
  }

  @Test
  void findsTheFormThatMadeTheCurve() {
    assertThat(ofSpeed(v -> 0.1).kind()).isEqualTo(Kind.NONE);
    SimpleFormula slope = ofSpeed(v -> 0.02 - 0.03 * v);
    assertThat(slope.kind()).isEqualTo(Kind.SLOPE);
    assertThat(slope.amount()).isEqualTo(-0.03, within(1e-9));
    assertThat(slope.explained()).isEqualTo(1, within(1e-9));
    assertThat(slope.text()).isEqualTo("deceleration grows by 0.030 m/s² per m/s");
    SimpleFormula square = ofSpeed(v -> 0.1 - 0.02 * v * v);
    assertThat(square.kind()).isEqualTo(Kind.QUADRATIC);
    assertThat(square.amount()).isEqualTo(-0.02, within(1e-9));
    SimpleFormula inverse = ofSpeed(v -> 0.2 / v);
    assertThat(inverse.kind()).isEqualTo(Kind.INVERSE);
    assertThat(inverse.amount()).isEqualTo(0.2, within(1e-9));
    SimpleFormula onset = ofSpeed(v -> v > 3 ? -0.05 * (v - 3) : 0);
    assertThat(onset.kind()).isEqualTo(Kind.ONSET);
    assertThat(onset.place()).isEqualTo(3, within(0.2));
    assertThat(onset.text()).matches("deceleration grows by 0\\.05. m/s² per m/s above 3\\.. m/s");
    SimpleFormula step = ofSpeed(v -> v > 2 ? 0.1 : 0);
    assertThat(step.kind()).isEqualTo(Kind.STEP);
    assertThat(step.place()).isEqualTo(2, within(0.2));
    assertThat(step.amount()).isEqualTo(0.1, within(1e-9));
    assertThat(ofSpeed(v -> 0.1 * Math.sin(3 * v)).kind()).isEqualTo(Kind.CURVE);
  }

  @Test
  void findsTheDirection() {
    SimpleFormula nap = formula(HEADING, (x, y) -> 0.01 + 0.05 * Math.cos(x - 1));
    assertThat(nap.kind()).isEqualTo(Kind.SINE);
    assertThat(nap.amount()).isEqualTo(0.05, within(1e-9));
    assertThat(nap.place()).isEqualTo(1, within(1e-9));
    SimpleFormula axis = formula(HEADING, (x, y) -> 0.05 * Math.cos(2 * x));
    assertThat(axis.kind()).isEqualTo(Kind.CURVE);
  }

  @Test
  void findsWhatDependsOnThePlace() {
    SimpleFormula plane = formula(PLACE, (x, y) -> 0.01 * x - 0.01 * y);
    assertThat(plane.kind()).isEqualTo(Kind.GRADIENT);
    assertThat(plane.amount()).isEqualTo(Math.sqrt(2) * 0.01, within(1e-9));
    assertThat(plane.place()).isEqualTo(-Math.PI / 4, within(1e-9));
    SimpleFormula half = formula(PLACE, (x, y) -> x > 0.1 ? -0.1 : 0);
    assertThat(half.kind()).isEqualTo(Kind.STEP_X);
    assertThat(half.place()).isEqualTo(0.1, within(0.3));
    assertThat(half.text()).startsWith("deceleration is higher by 0.10 m/s² from x = 0.1");
    assertThat(formula(PLACE, (x, y) -> y > 1 ? 0.1 : 0).kind()).isEqualTo(Kind.STEP_Y);
  }

  /** From noise-free data through the basis: what a spline makes of a kink is still called an onset. */
  @Test
  void aFittedTermGivesTheFormulaBack() {
    int n = 60;
    Spline basis = (Spline) SPEED.basis();
    RealMatrix a = new Array2DRowRealMatrix(n, basis.size() + 1);
    double[] y = new double[n];
    double[] values = new double[basis.size()];
    for (int i = 0; i < n; i++) {
      double v = 6.0 * i / (n - 1);
      basis.values(v, 0, values);
      for (int j = 0; j < values.length; j++) {
        a.setEntry(i, j, values[j]);
      }
      a.setEntry(i, values.length, 1);
      y[i] = -0.05 * Math.max(0, v - 2);
    }
    double[] fitted =
        new SingularValueDecomposition(a).getSolver().solve(new ArrayRealVector(y)).toArray();
    LearnedTerm term = SPEED.term(java.util.Arrays.copyOf(fitted, basis.size()));
    double[][] covariance = new double[basis.size()][basis.size()];
    for (int i = 0; i < covariance.length; i++) {
      covariance[i][i] = 1e-5;
    }
    SimpleFormula formula =
        SimpleFormula.of(LearnedCurve.of(term, 0, covariance, Support.of(0.3, 5.5)));
    assertThat(formula.kind()).isEqualTo(Kind.ONSET);
    assertThat(formula.place()).isEqualTo(2, within(0.5));
    assertThat(formula.amount()).isEqualTo(-0.05, within(0.01));
    assertThat(formula.explained()).isGreaterThan(0.97);
  }

  /** Coefficients that together only raise the curve where it was measured: a recording cannot tell that from the model's own parameter. */
  @Test
  void anUncertainLevelDoesNotHideTheShape() {
    int size = SPEED.basis().size();
    double[] values = new double[size];
    double[][] rows = new double[21][size];
    double[] ones = new double[21];
    for (int i = 0; i < 21; i++) {
      SPEED.basis().values(2.5 + i / 20.0, 0, values);
      rows[i] = values.clone();
      ones[i] = 1;
    }
    double[] raise =
        new SingularValueDecomposition(new Array2DRowRealMatrix(rows))
            .getSolver()
            .solve(new ArrayRealVector(ones))
            .toArray();
    double[][] covariance = new double[size][size];
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < size; j++) {
        covariance[i][j] = raise[i] * raise[j] + (i == j ? 1e-8 : 0);
      }
    }
    double[] rise = new double[21];
    for (int i = 0; i < 21; i++) {
      rise[i] = 0.1 * i / 20.0;
    }
    double[] tilted =
        new SingularValueDecomposition(new Array2DRowRealMatrix(rows))
            .getSolver()
            .solve(new ArrayRealVector(rise))
            .toArray();
    LearnedCurve curve = LearnedCurve.of(SPEED.term(tilted), 0, covariance, Support.of(2.5, 3.5));
    assertThat(curve.highest().value()).isEqualTo(0.05, within(0.005));
    assertThat(curve.highest().error()).isLessThan(0.01);
    assertThat(SimpleFormula.of(curve).kind()).isNotEqualTo(Kind.NONE);
  }

  @Test
  void aCurveHasTheErrorsOfItsCoefficients() {
    LearnedTerm term = HEADING.term(0.05, 0, 0, 0);
    double[][] covariance = new double[4][4];
    covariance[0][0] = 4e-4;
    covariance[1][1] = 1e-4;
    covariance[0][1] = 1e-4;
    covariance[1][0] = 1e-4;
    LearnedCurve curve =
        LearnedCurve.of(term, 0, covariance, Support.of(-Math.PI / 2, Math.PI / 2));
    assertThat(curve.points()).hasSize(33);
    Point straight = curve.points().get(16);
    // The mean of cos x and sin x over the points.
    double cosine = 0;
    for (Point p : curve.points()) {
      cosine += Math.cos(p.x()) / 33;
    }
    assertThat(straight.value()).isEqualTo(0.05 * (1 - cosine), within(1e-12));
    assertThat(straight.error()).isEqualTo(0.02 * (1 - cosine), within(1e-12));
    Point diagonal = curve.points().get(24);
    double c = Math.sqrt(0.5) - cosine;
    double variance = 4e-4 * c * c + 1e-4 * 0.5 + 2 * 1e-4 * c * Math.sqrt(0.5);
    assertThat(diagonal.error()).isEqualTo(Math.sqrt(variance), within(1e-12));
    assertThat(curve.highest()).isEqualTo(straight);
    assertThatThrownBy(() -> LearnedCurve.of(term, 0, new double[3][3], Support.of(0, 1)))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> LearnedCurve.of(term, 1, covariance, Support.of(0, 1)))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Support.of(Double.NaN, 1))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void oneSupportedPlaceIsOnePoint() {
    LearnedTerm term = SPEED.term(0.1, 0, 0, 0, 0);
    LearnedCurve curve = LearnedCurve.of(term, 0, new double[5][5], Support.of(2, 2));
    assertThat(curve.points()).hasSize(1);
    assertThat(SimpleFormula.of(curve).kind()).isEqualTo(Kind.NONE);
  }

  /** A box of friction brakes most along its diagonals. */
  @Test
  void whatComesAgainEveryQuarterTurnHasADirection() {
    SimpleFormula box = formula(QUARTERS, (x, y) -> 0.1 * Math.cos(4 * (x - 0.3)));
    assertThat(box.kind()).isEqualTo(Kind.SINE);
    assertThat(box.place()).isEqualTo(0.3, within(1e-6));
    assertThat(box.text()).endsWith("most towards 17° and every 90° from there");
  }
}
