package fieldcal.app.limits;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.MovementEffect;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.List;
import org.junit.jupiter.api.Test;

class LimitWordsTest {
  private static LimitEstimate of(double value) {
    return new LimitEstimate(value, 0.01, 100, true, "");
  }

  private static String words(LimitEstimate braking, MovementEffect effect, String seenIn) {
    LimitDeviation deviation = new LimitDeviation(effect, 0.4, 0.01, seenIn, 0.3, 0.9);
    TeamLimits limits =
        new TeamLimits(
            Team.BLUE,
            of(3),
            of(4),
            braking,
            of(3.1),
            of(4.5),
            of(8),
            List.of(deviation),
            List.of(),
            100);
    return LimitWords.sentence(limits, deviation);
  }

  @Test
  void anEffectIsToldInWhatIsLeftOfTheLimit() {
    assertThat(words(of(5), MovementEffect.TORQUE_LIMITED, "acceleration"))
        .isEqualTo(
            "accelerates less the faster it drives: 4.00 m/s² from standstill, 2.40 at 3.00 m/s");
    assertThat(words(of(5), MovementEffect.DIRECTIONAL, "acceleration"))
        .isEqualTo(
            "accelerates less sideways than along its front: 4.00 m/s² along it, 2.40 sideways");
    assertThat(words(of(5), MovementEffect.DIRECTIONAL, "braking"))
        .isEqualTo("brakes less sideways than along its front: 5.00 m/s² along it, 3.00 sideways");
  }

  @Test
  void withoutALimitNothingIsInvented() {
    LimitEstimate unknown = new LimitEstimate(Double.NaN, Double.NaN, 0, false, "too few");
    assertThat(words(unknown, MovementEffect.DIRECTIONAL, "braking"))
        .isEqualTo("brakes less sideways than along its front");
  }
}
