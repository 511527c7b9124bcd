package fieldcal.effect.learned;

import fieldcal.effect.learned.LearnedCurve.Point;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * The best simple formula for a learned curve. Each candidate has a free constant, since the mean of a term is a parameter of the simple model, and is fitted to the curve's
 * points by least squares weighted with their errors; the smallest {@code BIC = χ² + p·ln(n)} is chosen (Schwarz 1978), with p parameters and n independent numbers, one more than
 * the curve has coefficients, to which χ² is scaled. What none of them describes better than the curve itself, χ² = 0 with p = n, is called {@link Kind#CURVE}.
 *
 * @param kind the form
 * @param amount its coefficient a, in the quantity's unit per what {@link Kind} says
 * @param error standard error of the amount as far as the points determine it
 * @param place x0 of a step or an onset, else direction (rad) of a sine or gradient; NaN when the form has none
 * @param constant what is added, in the quantity's unit
 * @param explained part of the curve's weighted variance that it explains, 0 to 1
 * @param text the formula in words, with units
 */
public record SimpleFormula(
    Kind kind,
    double amount,
    double error,
    double place,
    double constant,
    double explained,
    String text) {

  /** Places tried for a step or an onset, by share of the points; chosen: not at the ends, where any curve has one. */
  private static final double FIRST_PLACE = 0.1;

  private static final double LAST_PLACE = 0.9;

  /** Where a/x is cut off, by share of the largest x. */
  private static final double SMALLEST_INVERSE = 0.05;

  /** Smallest weight's error by share of the curve's height, so that points of no error do not count alone; chosen. */
  private static final double LEAST_ERROR = 0.01;

  /** The forms. */
  public enum Kind {
    /** Nothing but a constant. */
    NONE,
    /** a·x. */
    SLOPE,
    /** a·x². */
    QUADRATIC,
    /** a/x. */
    INVERSE,
    /** a·max(0, x − x0). */
    ONSET,
    /** a from x0 on. */
    STEP,
    /** a·cos(n·(x − x0)), x an angle or, of a distance, the angle by which a ball has turned; n = 4 for what comes again with each quarter turn of the heading, else 1. */
    SINE,
    /** a·(x·cos x0 + y·sin x0) over a place. */
    GRADIENT,
    /** a from x = x0 on, over a place. */
    STEP_X,
    /** a from y = x0 on, over a place. */
    STEP_Y,
    /** No simple formula. */
    CURVE
  }

  /**
   * The best formula.
   *
   * @param curve what to describe
   * @return the formula
   */
  public static SimpleFormula of(LearnedCurve curve) {
    List<Fit> fits = new ArrayList<>();
    Data data = new Data(curve);
    fits.add(data.fit(Kind.NONE, Double.NaN, List.of()));
    if (curve.isTable()) {
      fits.add(data.fit(Kind.GRADIENT, Double.NaN, List.of(Point::x, Point::y)));
      fits.add(data.best(Kind.STEP_X, Point::x, c -> p -> p.x() >= c ? 1 : 0));
      fits.add(data.best(Kind.STEP_Y, Point::y, c -> p -> p.y() >= c ? 1 : 0));
    } else if (curve.family().basis() instanceof Harmonics h) {
      double perUnit = 2 * Math.PI / h.period();
      fits.add(
          data.fit(
              Kind.SINE,
              Double.NaN,
              List.of(p -> Math.cos(perUnit * p.x()), p -> Math.sin(perUnit * p.x()))));
    } else {
      fits.add(data.fit(Kind.SLOPE, Double.NaN, List.of(Point::x)));
      fits.add(data.best(Kind.STEP, Point::x, c -> p -> p.x() >= c ? 1 : 0));
      if (!(curve.family().basis() instanceof Levels)) {
        double cut = SMALLEST_INVERSE * data.largest;
        fits.add(data.fit(Kind.QUADRATIC, Double.NaN, List.of(p -> p.x() * p.x())));
        if (cut > 0) {
          fits.add(data.fit(Kind.INVERSE, Double.NaN, List.of(p -> 1 / Math.max(cut, p.x()))));
        }
        fits.add(data.best(Kind.ONSET, Point::x, c -> p -> Math.max(0, p.x() - c)));
      }
    }
    fits.add(data.curve());
    Fit best = fits.stream().min(Comparator.comparingDouble(Fit::bic)).orElseThrow();
    return best.formula(curve);
  }

  /** A fitted candidate: coefficients after the constant, errors, χ². */
  private record Fit(
      Kind kind,
      double place,
      double[] coefficients,
      double[] errors,
      double chi2,
      double bic,
      double explained) {

    SimpleFormula formula(LearnedCurve curve) {
      double amount = 0;
      double error = 0;
      double where = place;
      if (coefficients.length == 2) {
        amount = coefficients[1];
        error = errors[1];
      } else if (coefficients.length == 3) {
        amount = Math.hypot(coefficients[1], coefficients[2]);
        where = Math.atan2(coefficients[2], coefficients[1]);
        double c = Math.cos(where);
        double s = Math.sin(where);
        error = Math.sqrt(c * c * errors[1] * errors[1] + s * s * errors[2] * errors[2]);
      }
      if (kind == Kind.SINE && curve.family().variables().contains(Variable.HEADING)) {
        where *= ((Harmonics) curve.family().basis()).period() / (2 * Math.PI);
      }
      String text = FormulaText.of(kind, amount, where, curve);
      return new SimpleFormula(kind, amount, error, where, coefficients[0], explained, text);
    }
  }

  /** The points with their weights. */
  private static final class Data {
    final List<Point> points;
    final double[] weights;
    final double[] values;
    final double largest;

    /** Independent numbers, and how much a point counts of one. */
    final int independent;

    Data(LearnedCurve curve) {
      points = curve.points();
      int n = points.size();
      independent = Math.min(n, curve.family().basis().size() + 1);
      weights = new double[n];
      values = new double[n];
      double least = LEAST_ERROR * (curve.highest().value() - curve.lowest().value());
      double far = 0;
      for (int i = 0; i < n; i++) {
        Point p = points.get(i);
        double error = Math.max(p.error(), least);
        weights[i] = Math.sqrt((double) independent / n) / (error > 0 ? error : 1);
        values[i] = weights[i] * p.value();
        far = Math.max(far, Math.abs(p.x()));
      }
      largest = far;
    }

    /** The best place of a form that has one; that place is a parameter. */
    Fit best(
        Kind kind, ToDoubleFunction<Point> axis, DoubleFunction<ToDoubleFunction<Point>> form) {
      double[] at = points.stream().mapToDouble(axis).distinct().sorted().toArray();
      Fit best = fit(Kind.NONE, Double.NaN, List.of());
      for (int i = 1; i < at.length; i++) {
        double share = (double) i / at.length;
        if (share >= FIRST_PLACE && share <= LAST_PLACE || at.length <= 3) {
          double place = kind == Kind.ONSET ? at[i - 1] : (at[i - 1] + at[i]) / 2;
          Fit fit = fit(kind, place, List.of(form.apply(place)));
          best = fit.bic() < best.bic() ? fit : best;
        }
      }
      return best;
    }

    Fit fit(Kind kind, double place, List<ToDoubleFunction<Point>> forms) {
      int n = points.size();
      int p = forms.size() + 1;
      if (p > n) {
        // So few points cannot tell this form.
        return fit(Kind.NONE, Double.NaN, List.of());
      }
      RealMatrix a = new Array2DRowRealMatrix(n, p);
      for (int i = 0; i < n; i++) {
        a.setEntry(i, 0, weights[i]);
        for (int j = 1; j < p; j++) {
          a.setEntry(i, j, weights[i] * forms.get(j - 1).applyAsDouble(points.get(i)));
        }
      }
      RealVector y = new ArrayRealVector(values);
      SingularValueDecomposition svd = new SingularValueDecomposition(a);
      RealVector x = svd.getSolver().solve(y);
      RealMatrix inverse = svd.getCovariance(1e-12);
      double[] errors = new double[p];
      for (int j = 0; j < p; j++) {
        errors[j] = Math.sqrt(inverse.getEntry(j, j));
      }
      RealVector left = y.subtract(a.operate(x));
      double chi2 = left.dotProduct(left);
      int parameters = p + (Double.isNaN(place) ? 0 : 1);
      double explained = kind == Kind.NONE ? 0 : explained(chi2);
      return new Fit(kind, place, x.toArray(), errors, chi2, bic(chi2, parameters), explained);
    }

    private double bic(double chi2, int parameters) {
      return chi2 + parameters * Math.log(independent);
    }

    private double explained(double chi2) {
      double all = fit(Kind.NONE, Double.NaN, List.of()).chi2();
      return all > 0 ? Math.max(0, 1 - chi2 / all) : 0;
    }

    Fit curve() {
      double[] none = {0};
      return new Fit(Kind.CURVE, Double.NaN, none, none, 0, bic(0, independent), 1);
    }
  }
}
