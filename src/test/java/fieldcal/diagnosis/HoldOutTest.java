package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Gains are believed when many kicks have them that the fit never saw. */
class HoldOutTest {
  private static final long SEED = 1;
  private static final int COUNT = 100;

  private final ChipsField field = ChipsField.fitted();

  /** As if kicks of a hundred residuals each had these errors, mm. */
  private static HoldOut errors(double... mm) {
    int[] counts = new int[mm.length];
    Arrays.fill(counts, COUNT);
    return new HoldOut(
        Arrays.stream(mm).map(e -> COUNT * e * e * 1e-6).toArray(), counts, Map.of());
  }

  @Test
  void theErrorIsThatOfAllResiduals() {
    assertThat(errors(3, 4).rmsMm()).isCloseTo(Math.sqrt(12.5), within(1e-9));
    assertThat(errors(3, 4).rmsMm(1)).isCloseTo(4, within(1e-9));
    assertThat(new HoldOut(new double[1], new int[1], Map.of()).rmsMm()).isNaN();
  }

  @Test
  void aGainThatAllKicksShareIsSure() {
    Gain gain = errors(2, 2.1, 1.9, 2, 2, 2.05).gainOn(errors(3, 3.1, 2.9, 3, 3.05, 2.95), SEED);
    assertThat(gain.mm()).isCloseTo(1, within(0.05));
    assertThat(gain.percent()).isCloseTo(33, within(1.0));
    assertThat(gain.lowMm()).isPositive().isLessThan(gain.mm());
    assertThat(gain.highMm()).isGreaterThan(gain.mm());
  }

  @Test
  void aGainThatOthersPayForIsNone() {
    HoldOut after = errors(1, 3.5, 3.5, 3.5, 1, 3.5);
    assertThat(after.gainOn(errors(3, 3, 3, 3, 3, 3), SEED).lowMm()).isNegative();
  }

  @Test
  void theGainOfOneKickIsToldFromThatOfMany() {
    HoldOut before = errors(9, 3, 3, 3, 3);
    assertThat(errors(2, 3, 3, 3, 3).gainsByOneKick(before)).isTrue();
    assertThat(errors(8, 2, 2, 2, 2).gainsByOneKick(before)).isFalse();
    assertThat(errors(2, 2, 2, 2, 2).gainsByOneKick(errors(17, 2.2, 2.2, 2.2, 2.2))).isFalse();
  }

  @Test
  void kicksThatWereNotFittedAreExplainedToTheNoise() {
    HoldOut held = HoldOut.of(field.fitter, field.simple, SEED);
    double chi = 0;
    for (int k = 0; k < field.fitter.kicks.size(); k++) {
      KickModel model = field.model(field.simple, k);
      double[] rx = new double[model.data.size];
      double[] ry = new double[model.data.size];
      model.plainResiduals(field.state(), rx, ry);
      for (int i = 0; i < rx.length; i++) {
        chi += model.data.used[i] ? rx[i] * rx[i] + ry[i] * ry[i] : 0;
      }
    }
    double fitted = 1000 * Math.sqrt(chi / field.simple.residuals());
    assertThat(held.rmsMm()).isBetween(fitted, 1.03 * fitted);
    assertThat(held.predictionMm()).containsKeys(0.5, 1.0, 2.0);
  }
}
