package fieldcal.diagnosis.decision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.decision.KickValues.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class KickValuesTest {
  private static final double MEAN = -0.11;

  private static KickValues of(double... values) {
    List<Kick> kicks = new ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      kicks.add(new Kick(i, values[i], 1, KickKind.FLAT, i, 3, 0, 0, 0));
    }
    return new KickValues(MEAN, kicks);
  }

  @Test
  void theFarthestValuesAreLeftOut() {
    KickValues all = of(-0.112, -0.2, -0.108, -0.11, -0.114, -0.106, 0.1);
    assertThat(all.scatter()).isGreaterThan(0.05);
    KickValues most = all.withoutFarthest(2);
    assertThat(most.kicks()).extracting(Kick::index).containsExactly(0, 2, 3, 4, 5);
    assertThat(most.scatter()).isCloseTo(Math.sqrt(1e-5), within(1e-9));
  }

  @Test
  void nothingIsLeftOfTwo() {
    assertThat(of(0.1, 0.2).withoutFarthest(2).kicks()).isEmpty();
    assertThat(of().withoutFarthest(2).scatter()).isZero();
  }
}
