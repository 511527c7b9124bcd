package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Noise of robots that stand. */
class StandingNoiseTest {
  /** Of 20,000 groups: the median's standard error is 0.12 %; without its correction it is 1.1 % too small. */
  @Test
  void theMedianOfGroupsIsCorrected() {
    Random random = new Random(2);
    StandingNoise noise = new StandingNoise();
    Histogram squares = new Histogram(0.02, 5000);
    Grid places = Grid.centred(0.5, 48);
    for (int i = 0; i < 20_000 * 16; i++) {
      noise.add(1 + 0.002 * random.nextGaussian(), 0.002 * random.nextGaussian(), places, squares);
    }
    assertThat(StandingNoise.standardDeviation(squares)).isCloseTo(2, within(0.01));
  }

  @Test
  void ofNoRobotItIsUnknown() {
    assertThat(StandingNoise.standardDeviation(new Histogram(0.02, 5000))).isNaN();
  }
}
