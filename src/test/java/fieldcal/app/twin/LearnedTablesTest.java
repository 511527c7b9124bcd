package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.effect.learned.Basis;
import fieldcal.effect.learned.Harmonics;
import fieldcal.effect.learned.LearnedFamily;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Spline;
import fieldcal.effect.learned.Variable;
import fieldcal.simulation.physics.Table;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Learned terms as the simulator gets them. */
class LearnedTablesTest {
  private static final double[] FIELD = {4.5, 3};

  /** A straight line between two of the points misses a curve by less than that part of its height. */
  private static final double CLOSE = 2e-3;

  private static LearnedTerm term(Quantity quantity, Variable variable, Basis basis) {
    double[] coefficients = new double[quantity.components() * basis.size()];
    Arrays.setAll(coefficients, i -> i % 3 == 0 ? 1 : -0.5);
    return LearnedFamily.of(quantity, variable, basis).absent().withParameters(coefficients);
  }

  private static void isTheTerm(LearnedTerm term, double from, double to) {
    Table table = LearnedTables.laws(term, FIELD).get(0).table();
    for (int i = 0; i <= 1000; i++) {
      double x = from + (to - from) * i / 1000;
      assertThat(table.at(x, 0)).as("at %s", x).isCloseTo(term.valueAt(0, x, 0), within(CLOSE));
    }
  }

  /** One turn of the ball repeats, a curve over the whole way does not. */
  @Test
  void aCurveOverTheWayDoesNotRepeat() {
    Quantity along = Quantity.ACCELERATION_ALONG;
    isTheTerm(term(along, Variable.DISTANCE_ROLLED, new Spline(0, 11, 6, true)), 0, 12);
    isTheTerm(term(along, Variable.DISTANCE_ROLLED, new Harmonics(1, 0.135)), 0, 2);
  }

  /** What repeats during a session has as many points within a period as any other curve. */
  @Test
  void aWaveOverTheSessionIsTabulatedOverOnePeriod() {
    Quantity friction = Quantity.FRICTION;
    isTheTerm(term(friction, Variable.SESSION_TIME, new Harmonics(1, 0.2)), 0, 30);
    isTheTerm(term(friction, Variable.SESSION_TIME, new Spline(3, 600, 5, true)), 0, 700);
    isTheTerm(term(friction, Variable.HEADING, Harmonics.ofAngle(1)), -4, 4);
  }

  /** All balls of a frame have one time stamp. */
  @Test
  void timeStampsThatDependOnTheSpeedOfTheBallHaveNoTable() {
    Basis speed = new Spline(0, 6.5, 4, false);
    LearnedTerm late =
        LearnedFamily.of(Quantity.TIME_ERROR, Variable.SPEED, speed, 0)
            .absent()
            .withParameters(1, 2, 3, 4);
    assertThat(LearnedTables.error(late, FIELD)).isEmpty();
    LearnedTerm drifts =
        LearnedFamily.of(Quantity.TIME_ERROR, Variable.SESSION_TIME, speed, 0)
            .absent()
            .withParameters(1, 2, 3, 4);
    assertThat(LearnedTables.error(drifts, FIELD)).isPresent();
  }
}
