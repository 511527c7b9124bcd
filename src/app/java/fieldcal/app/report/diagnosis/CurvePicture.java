package fieldcal.app.report.diagnosis;

import fieldcal.app.report.Rounded;
import fieldcal.app.wording.LearnedWords;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.LearnedCurve.Point;
import fieldcal.effect.learned.SimpleFormula;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * A learned curve, or a table over two numbers, to draw; columns of equal length.
 *
 * @param title what it shows
 * @param unit of it; may be empty
 * @param axes over what: one name of a curve, two of a table
 * @param axisUnits units of these; may be empty
 * @param formula the best simple formula, in words
 * @param x first number
 * @param y second number of a table, else 0
 * @param value the curve
 * @param error standard error of the value
 */
public record CurvePicture(
    String title,
    String unit,
    List<String> axes,
    List<String> axisUnits,
    String formula,
    @Rounded(4) double[] x,
    @Rounded(4) double[] y,
    @Rounded(6) double[] value,
    @Rounded(6) double[] error) {

  /** Copies the lists. */
  public CurvePicture {
    axes = List.copyOf(axes);
    axisUnits = List.copyOf(axisUnits);
  }

  static CurvePicture of(LearnedCurve curve) {
    boolean table = curve.isTable();
    String unit = LearnedWords.axisUnit(curve, 0);
    return new CurvePicture(
        LearnedWords.quantity(curve),
        LearnedWords.unit(curve),
        table
            ? List.of(LearnedWords.axis(curve, 0), LearnedWords.axis(curve, 1))
            : List.of(LearnedWords.axis(curve, 0)),
        table ? List.of(unit, LearnedWords.axisUnit(curve, 1)) : List.of(unit),
        SimpleFormula.of(curve).text(),
        column(curve, p -> LearnedWords.onAxis(curve, 0, p.x())),
        column(curve, p -> table ? LearnedWords.onAxis(curve, 1, p.y()) : 0),
        column(curve, p -> LearnedWords.inUnit(curve, p.value())),
        column(curve, p -> LearnedWords.inUnit(curve, p.error())));
  }

  private static double[] column(LearnedCurve curve, ToDoubleFunction<Point> of) {
    return curve.points().stream().mapToDouble(of).toArray();
  }
}
