package fieldcal.app.twin;

import fieldcal.camera.Camera;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Variable;
import fieldcal.simulation.KickBehaviour.SpinTable;
import fieldcal.simulation.imaging.TabulatedError;
import fieldcal.simulation.physics.Table;
import fieldcal.simulation.physics.TabulatedLaw;
import java.util.ArrayList;
import java.util.List;

/** Learned terms of a diagnosis as tables, which the simulator integrates: it knows nothing of the functions that they were fitted with. */
final class LearnedTables {
  /** Points of a curve: between two of them a spline of six knots differs from a straight line by less than a thousandth of its height. */
  private static final int POINTS = 129;

  /** Points of a surface along each axis: 0.2 m apart on a field of 12 m, a fifth of the way between two knots of stripes. */
  private static final int GRID = 65;

  /** Impacts that are distinguished; later hops are below 10 mm. */
  private static final int HOPS = 8;

  /** How far tables over a speed and over the time since the kick reach, m/s and s: a learned curve is constant beyond its last knot, which lies before. */
  private static final double FASTEST = 10;

  private static final double LONGEST = 20;

  private LearnedTables() {}

  /** One law for each component of the term. */
  static List<TabulatedLaw> laws(LearnedTerm term, double[] field, double[] session) {
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
              table(term, c, variable, field, session)));
    }
    return laws;
  }

  static SpinTable spin(LearnedTerm term) {
    Variable variable = term.family().variables().get(0);
    return new SpinTable(
        variable == Variable.HEADING, table(term, 0, variable, new double[2], new double[2]));
  }

  static TabulatedError error(LearnedTerm term, double[] view, double[] session) {
    Variable variable = term.family().variables().get(0);
    Quantity quantity = term.family().quantity();
    List<Table> tables = new ArrayList<>();
    for (int c = 0; c < quantity.components(); c++) {
      tables.add(table(term, c, variable, view, session));
    }
    return new TabulatedError(
        TabulatedError.Quantity.valueOf(quantity.name()),
        TabulatedError.Variable.valueOf(variable.name()),
        tables);
  }

  private static Table table(
      LearnedTerm term, int component, Variable variable, double[] reach, double[] session) {
    return switch (variable) {
      case PLACE, IMAGE_POSITION -> surface(term, component, reach[0], reach[1]);
      case HEADING -> curve(term, component, -Math.PI, Math.PI, POINTS, 2 * Math.PI);
      case DISTANCE_ROLLED -> {
        double turn = 2 * Math.PI * Camera.BALL_RADIUS;
        yield curve(term, component, 0, turn, POINTS, turn);
      }
      case HOP -> curve(term, component, 1, HOPS, HOPS, 0);
      case SESSION_TIME -> curve(term, component, session[0], session[1], POINTS, 0);
      case TIME_SINCE_KICK -> curve(term, component, 0, LONGEST, POINTS, 0);
      case SPEED, SLIP, VERTICAL_SPEED, GROUND_SPEED ->
          curve(term, component, 0, FASTEST, POINTS, 0);
    };
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
