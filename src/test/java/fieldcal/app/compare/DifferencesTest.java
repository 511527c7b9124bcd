package fieldcal.app.compare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Gain;
import fieldcal.effect.motion.KickSpin;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** How certain it is that only one side has a cause. */
class DifferencesTest {
  private static Cause spin(double mean, double scatter, double evidence) {
    return new Cause(
        new KickSpin(mean),
        Map.of("fraction", 0.04),
        scatter,
        evidence,
        new Gain(1, 10, 0.5, 1.5),
        List.of());
  }

  @Test
  void aCauseThatScattersIsThereWhateverItsMeanIs() {
    assertThat(Differences.ofPresence(spin(0.001, 0.2, 400), 0.025)).isLessThan(1e-12);
    // Two degrees of freedom: the probability is e to the minus half of chi-square.
    assertThat(Differences.ofPresence(spin(0.1, 0.2, 3), 2.5))
        .isCloseTo(Math.exp(-3), within(1e-9));
  }

  @Test
  void aCauseThatIsTheSameForAllKicksIsTestedByItsSize() {
    assertThat(Differences.ofPresence(spin(0.04, 0, 400), 1)).isCloseTo(0.3173, within(1e-4));
  }
}
