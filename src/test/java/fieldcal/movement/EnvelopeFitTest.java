package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Limits by direction from manoeuvres that are drawn, not driven. */
class EnvelopeFitTest {
  private static final double LIMIT = 4;

  /** What a robot can do in a direction, in parts. */
  enum Shape {
    ELLIPSE(phi -> 0.5 / Math.hypot(0.5 * Math.cos(phi), Math.sin(phi))),
    SINE(phi -> 1 - 0.5 * Math.abs(Math.sin(phi))),
    SINE_SQUARED(phi -> 1 - 0.5 * Math.pow(Math.sin(phi), 2)),
    FOUR_LOBES(phi -> 1 - 0.5 * Math.pow(Math.sin(2 * phi), 2));

    private final DoubleUnaryOperator factor;

    Shape(DoubleUnaryOperator factor) {
      this.factor = factor;
    }
  }

  private static AccelerationLimit limit(DoubleUnaryOperator factor, int n, long seed) {
    Random random = new Random(seed);
    ManoeuvreTable table = new ManoeuvreTable(ManoeuvreTable.Scale.DRIVING);
    for (int i = 0; i < n; i++) {
      // A team that never drives backwards.
      double phi = Math.PI * (1.5 * random.nextDouble() - 0.75);
      double most = LIMIT * factor.applyAsDouble(phi);
      double a = random.nextDouble() < 0.6 ? most : most * random.nextDouble();
      double error = a * (0.01 + 0.05 * random.nextDouble());
      table.add(a + error * random.nextGaussian(), error, 1, phi);
    }
    return new AccelerationLimit(table, AccelerationLimit.Kind.ACCELERATION, 3, 6);
  }

  @ParameterizedTest
  @EnumSource(Shape.class)
  void everyShapeComesOut(Shape shape) {
    int covered = 0;
    int known = 0;
    for (int seed = 1; seed <= 3; seed++) {
      AccelerationLimit found = limit(shape.factor, 900, seed);
      Envelope envelope = found.byDirection().orElseThrow();
      assertThat(envelope.points()).hasSizeBetween(24, 29);
      for (Envelope.Point p : envelope.points()) {
        double truth = LIMIT * shape.factor.applyAsDouble(p.angle());
        assertThat(p.value()).as(shape + " " + p).isEqualTo(truth, within(0.05 * truth));
        covered += Math.abs(p.value() - truth) < 2 * p.standardError() ? 1 : 0;
        known++;
      }
      assertThat(envelope.at(Math.PI)).isEmpty();
      assertThat(envelope.at(-0.2).orElseThrow())
          .isEqualTo(LIMIT * shape.factor.applyAsDouble(-0.2), within(0.2));
      assertThat(found.estimate().value()).isEqualTo(LIMIT, within(0.05 * LIMIT));
    }
    assertThat((double) covered / known).isGreaterThan(0.88);
  }

  @Test
  void aShapeThatDirectionalDoesNotHaveIsCalledOne() {
    assertThat(limit(Shape.FOUR_LOBES.factor, 900, 1).byDirection().orElseThrow().shaped())
        .isTrue();
    assertThat(limit(Shape.SINE.factor, 900, 1).byDirection().orElseThrow().shaped()).isFalse();
    for (int seed = 0; seed < 10; seed++) {
      AccelerationLimit uniform = limit(phi -> 1, 900, seed);
      assertThat(uniform.byDirection().orElseThrow().shaped()).isFalse();
      assertThat(uniform.deviations()).isEmpty();
    }
  }

  @Test
  void tooFewManoeuvresHaveNoEnvelope() {
    assertThat(limit(phi -> 1, 40, 1).byDirection()).isEmpty();
    assertThat(limit(phi -> 1, 70, 1).byDirection().orElseThrow().points()).hasSizeLessThan(8);
  }
}
