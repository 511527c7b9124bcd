package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.KickSpin;
import java.util.Random;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.junit.jupiter.api.Test;

/** In one dimension, where the likelihood is a parabola, everything a score says can be integrated. */
class ScoreTest {
  private static final Chart DRAG = Chart.of(new AirDrag(0));

  private static Score score(double information, double score) {
    return Score.of(
        DRAG,
        new Array2DRowRealMatrix(new double[][] {{information}}),
        new ArrayRealVector(new double[] {score}));
  }

  /** Logarithm of the mean likelihood over what is expected, relative to the likelihood of absence, by the trapezoid rule. */
  private static double integrated(double information, double score) {
    double expected = DRAG.expected(0) / DRAG.scale(0);
    double sum = 0;
    double step = 1e-3;
    for (double u = -20 * expected; u < 20 * expected; u += step) {
      double likelihood = Math.exp(score * u - 0.5 * information * u * u);
      double density =
          Math.exp(-0.5 * u * u / (expected * expected)) / (expected * Math.sqrt(2 * Math.PI));
      sum += likelihood * density * step;
    }
    return Math.log(sum);
  }

  @Test
  void evidenceIsTheMeanLikelihood() {
    for (double[] c : new double[][] {{1, 0.5}, {4, 8}, {25, -20}, {0.1, 0}}) {
      assertThat(score(c[0], c[1]).evidence())
          .as("information %f, score %f", c[0], c[1])
          .isCloseTo(integrated(c[0], c[1]), within(1e-3));
    }
  }

  @Test
  void estimateAndGainAreThoseOfTheParabola() {
    Score s = score(1e4, 2e4);
    assertThat(s.coordinates()[0] / DRAG.scale(0)).isCloseTo(2, within(1e-4));
    assertThat(s.gain()).isCloseTo(4e4, within(1.0));
  }

  @Test
  void whatKicksDoNotShowIsNoCandidate() {
    assertThat(score(0, 0).evidence()).isEqualTo(Double.NEGATIVE_INFINITY);
  }

  @Test
  void scatterFromKickToKickIsFound() {
    Random random = new Random(7);
    int kicks = 200;
    double[] information = new double[kicks];
    double[] varying = new double[kicks];
    double[] noise = new double[kicks];
    for (int k = 0; k < kicks; k++) {
      information[k] = 1 + 3 * random.nextDouble();
      double magnitude = 2 * random.nextGaussian();
      noise[k] = Math.sqrt(information[k]) * random.nextGaussian();
      varying[k] = information[k] * magnitude + noise[k];
    }
    Chart spin = Chart.of(new KickSpin(0));
    Score found = Score.ofRandom(spin, information, varying);
    assertThat(found.scatter() / spin.scale(0)).isCloseTo(2, within(0.4));
    assertThat(found.evidence()).isGreaterThan(50);
    assertThat(Score.ofRandom(spin, information, noise).evidence()).isLessThan(3);
  }
}
