package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.play.KickStrength.Pair;
import fieldcal.fit.Estimate;
import fieldcal.kick.KickKind;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a robot makes of its kick commands, from few kicks. */
class KickStrengthTest {
  private static final RobotId ROBOT = new RobotId(Team.YELLOW, 1);

  /** Commanded and measured speeds in turn, m/s. */
  private static KickStrength of(double... toldAndMeasured) {
    Pair[] pairs = new Pair[toldAndMeasured.length / 2];
    Arrays.setAll(
        pairs, i -> new Pair(toldAndMeasured[2 * i], toldAndMeasured[2 * i + 1], 0.01 * i, 0));
    return KickStrength.fit(ROBOT, KickKind.FLAT, List.of(pairs));
  }

  @Test
  void equalSpeedsTellNoOffset() {
    KickStrength s = of(4, 4.4, 4, 4.4, 4, 4.5);
    assertThat(s.offset()).isNaN();
    assertThat(s.offsetError()).isNaN();
    assertThat(s.gain()).isCloseTo(13.3 / 12, within(1e-9));
    assertThat(s.gainError()).isPositive();
  }

  @Test
  void twoSpeedsTellNoOffsetEither() {
    assertThat(of(2, 2.2, 6, 6.6).offset()).isNaN();
  }

  @Test
  void oneKickTellsNoScatter() {
    KickStrength s = of(4, 4.4);
    assertThat(s.gain()).isCloseTo(1.1, within(1e-9));
    assertThat(s.gainError()).isNaN();
    assertThat(s.speedScatter()).isNaN();
    assertThat(s.yawScatter()).isNaN();
  }

  @Test
  void differentSpeedsTellGainAndOffsetWithTheirErrors() {
    KickStrength s = of(2, 2.1, 4, 4.3, 6, 6.1);
    assertThat(s.gain()).isCloseTo(1, within(1e-9));
    assertThat(s.offset()).isCloseTo(1 / 6.0, within(1e-9));
    // Residuals -1/15, 2/15, -1/15 leave one degree of freedom: too few to tell a scatter.
    assertThat(s.speedScatter()).isNaN();
    // 1 % of the mean speed is another.
    double usual = 0.01 * 12.5 / 3;
    double scatter = Math.sqrt((6 / 225.0 + usual * usual) / 2) * Estimate.student(3);
    assertThat(s.gainError()).isCloseTo(scatter / Math.sqrt(8), within(1e-9));
    assertThat(s.offsetError()).isCloseTo(scatter * Math.sqrt(1 / 3.0 + 16 / 8.0), within(1e-9));
  }

  @Test
  void fourKicksTellAScatter() {
    assertThat(of(2, 2.1, 3, 3, 4, 4.3, 6, 6.1).speedScatter()).isBetween(0.1, 0.2);
  }

  @Test
  void kicksThatAgreeByChanceHaveErrors() {
    KickStrength two = of(2, 2, 6, 6);
    assertThat(two.gainError()).isBetween(0.004, 0.02);
    assertThat(of(2, 2, 4, 4, 6, 6).gainError()).isBetween(0.004, 0.03);
    KickStrength same =
        KickStrength.fit(
            ROBOT, KickKind.CHIP, List.of(new Pair(2, 2, 0.1, 0.2), new Pair(5, 5, 0.1, 0.2)));
    assertThat(Math.toDegrees(same.yawError())).isBetween(0.2, 2.0);
    assertThat(Math.toDegrees(same.elevationError())).isBetween(0.2, 2.0);
  }

  /** Kickers that scatter by 1 % and 2 %: the truth lies within two standard errors as often as it should, with few kicks, too. */
  @ParameterizedTest
  @CsvSource({"2,0.01", "2,0.02", "3,0.01", "3,0.02", "4,0.01", "6,0.02"})
  void theTruthLiesWithinTwoStandardErrors(int kicks, double scatter) {
    Random random = new Random(4);
    int within = 0;
    for (int i = 0; i < 2000; i++) {
      Pair[] pairs = new Pair[kicks];
      Arrays.setAll(
          pairs,
          k -> {
            double told = 2 + 4.5 * k / (kicks - 1);
            return new Pair(told, told * (1 + scatter * random.nextGaussian()), 0, 0);
          });
      KickStrength s = KickStrength.fit(ROBOT, KickKind.FLAT, List.of(pairs));
      within += Math.abs(s.gain() - 1) < 2 * s.gainError() ? 1 : 0;
    }
    assertThat(within / 2000.0).isBetween(0.85, 1.0);
  }
}
