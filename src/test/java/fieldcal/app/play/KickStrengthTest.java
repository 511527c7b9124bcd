package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.play.KickStrength.Pair;
import fieldcal.kick.KickKind;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

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
    // Residuals -1/15, 2/15, -1/15 leave one degree of freedom.
    assertThat(s.speedScatter()).isCloseTo(Math.sqrt(6) / 15, within(1e-9));
    assertThat(s.gainError()).isCloseTo(s.speedScatter() / Math.sqrt(8), within(1e-9));
    assertThat(s.offsetError())
        .isCloseTo(s.speedScatter() * Math.sqrt(1 / 3.0 + 16 / 8.0), within(1e-9));
  }
}
