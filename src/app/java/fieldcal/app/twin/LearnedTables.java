package fieldcal.app.twin;

import fieldcal.effect.learned.Basis;
import fieldcal.effect.learned.Harmonics;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Levels;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Spline;
import fieldcal.effect.learned.Variable;
import fieldcal.simulation.KickBehaviour.SpinTable;
import fieldcal.simulation.imaging.TabulatedError;
import fieldcal.simulation.physics.Table;
import fieldcal.simulation.physics.TabulatedLaw;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Learned terms of a diagnosis as tables, which the simulator integrates: it knows nothing of the functions that they were fitted with. */
final class LearnedTables {
  /** Points of a curve: between two of them a spline of six knots differs from a straight line by less than a thousandth of its height. */
  private static final int POINTS = 129;

  /** Points of a surface along each axis: 0.2 m apart on a field of 12 m, a fifth of the way between two knots of stripes. */
  private static final int GRID = 65;

  /** Impacts that are distinguished; later hops are below 10 mm. */
  private static final int HOPS = 8;

  private LearnedTables() {}

  /** One law for each component of the term. */
  static List<TabulatedLaw> laws(LearnedTerm term, double[] field) {
    Variable variable = term.family().variables().get(0);
    Quantity quantity = term.family().quantity();
    List<TabulatedLaw.Quantity> changes =
        switch (quantity) {
          case PUSH -> List.of(TabulatedLaw.Quantity.PUSH_X, TabulatedLaw.Quantity.PUSH_Y);
          case NAP -> List.of(TabulatedLaw.Quantity.NAP_X, TabulatedLaw.Quantity.NAP_Y);
          case AIR -> List.of(TabulatedLaw.Quantity.AIR_X, TabulatedLaw.Quantity.AIR_Y);
          case SLIDING ->
              List.of(TabulatedLaw.Quantity.SLIDING_ALONG, TabulatedLaw.Quantity.SLIDING_ACROSS);
          default -> List.of(TabulatedLaw.Quantity.valueOf(quantity.name()));
        };
    List<TabulatedLaw> laws = new ArrayList<>();
    for (int c = 0; c < changes.size(); c++) {
      laws.add(
          new TabulatedLaw(
              changes.get(c),
              TabulatedLaw.Variable.valueOf(variable.name()),
              table(term, c, field)));
    }
    return laws;
  }

  static SpinTable spin(LearnedTerm term) {
    Variable variable = term.family().variables().get(0);
    return new SpinTable(variable == Variable.HEADING, table(term, 0, new double[2]));
  }

  /** Empty where the simulator's cameras have no such error: all balls of a frame have one time stamp, so it cannot depend on the speed of one of them. */
  static Optional<TabulatedError> error(LearnedTerm term, double[] view) {
    Variable variable = term.family().variables().get(0);
    Quantity quantity = term.family().quantity();
    if (variable == Variable.SPEED) {
      return Optional.empty();
    }
    List<Table> tables = new ArrayList<>();
    for (int c = 0; c < quantity.components(); c++) {
      tables.add(table(term, c, view));
    }
    return Optional.of(
        new TabulatedError(
            TabulatedError.Quantity.valueOf(quantity.name()),
            TabulatedError.Variable.valueOf(variable.name()),
            tables));
  }

  /** Over one period, or over the range of the knots, beyond which both the term and the table are constant. */
  private static Table table(LearnedTerm term, int component, double[] reach) {
    Basis basis = term.family().basis();
    if (basis instanceof Harmonics h) {
      return curve(term, component, 0, h.period(), POINTS, h.period());
    }
    if (basis instanceof Spline s) {
      return curve(term, component, s.from(), s.to(), POINTS, 0);
    }
    if (basis instanceof Levels) {
      return curve(term, component, 1, HOPS, HOPS, 0);
    }
    return surface(term, component, reach[0], reach[1]);
  }

  private static double[] grid(double from, double to, int points) {
    double[] grid = new double[points];
    for (int i = 0; i < points; i++) {
      grid[i] = from + (to - from) * i / (points - 1);
    }
    return grid;
  }

  private static Table curve(
      LearnedTerm term, int component, double from, double to, int points, double period) {
    double[] x = grid(from, to, points);
    double[] values = new double[points];
    for (int i = 0; i < points; i++) {
      values[i] = term.valueAt(component, x[i], 0);
    }
    return Table.curve(x, values, period);
  }

  private static Table surface(LearnedTerm term, int component, double halfX, double halfY) {
    double[] x = grid(-halfX, halfX, GRID);
    double[] y = grid(-halfY, halfY, GRID);
    double[] values = new double[GRID * GRID];
    for (int j = 0; j < GRID; j++) {
      for (int i = 0; i < GRID; i++) {
        values[j * GRID + i] = term.valueAt(component, x[i], y[j]);
      }
    }
    return Table.surface(x, y, values);
  }
}
