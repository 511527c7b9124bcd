package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Turns from orientations that are known: the robot turns on, round and round, and rests in between. */
class TurnTrackTest {
  private static final double NOISE = 0.01;

  /** Rest, turn by 3.5 rad with a trapezoid of the rate, and again; between two turns 1 s. */
  private static DoubleUnaryOperator turning(double rate, double faster, double slower) {
    double up = rate / faster;
    double down = rate / slower;
    double steady = (3.5 - 0.5 * rate * (up + down)) / rate;
    double period = up + steady + down + 1;
    return t -> {
      double turns = Math.floor(t / period);
      double s = t - turns * period;
      double one =
          0.5 * faster * square(s)
              - 0.5 * faster * square(s - up)
              - 0.5 * slower * square(s - up - steady)
              + 0.5 * slower * square(s - up - steady - down);
      return 3.5 * turns + one;
    };
  }

  private static double square(double t) {
    return t > 0 ? t * t : 0;
  }

  private static TurnLimits limits(DoubleUnaryOperator angle, double seconds, double misread) {
    Random random = new Random(1);
    TeamStatistics team = new TeamStatistics();
    ManoeuvreFinder finder = new ManoeuvreFinder(PathKind.ORIENTATION, m -> team.add(Turn.of(m)));
    TurnTrack track = new TurnTrack(new RobotId(Team.BLUE, 4), finder);
    for (int frame = 0; frame < seconds * 144; frame++) {
      double t = frame / 144.0;
      double seen = angle.applyAsDouble(t) + NOISE * random.nextGaussian();
      seen += random.nextDouble() < misread ? 2 : 0;
      track.accept(t, frame % 2, Math.IEEEremainder(seen, 2 * Math.PI));
    }
    track.end();
    return TurnLimits.of(team);
  }

  @Test
  void turnsRoundAndRoundHaveTheirLimits() {
    for (double misread : new double[] {0, 0.02}) {
      TurnLimits found = limits(turning(8, 30, 45), 60, misread);
      near(found.velocity(), 8);
      near(found.acceleration(), 30);
      near(found.braking(), 45);
    }
  }

  private static void near(LimitEstimate found, double truth) {
    assertThat(found.reached()).isTrue();
    assertThat(found.value()).isEqualTo(truth, within(0.03 * truth));
    assertThat(Math.abs(found.value() - truth)).isLessThan(3 * found.standardError());
  }

  @Test
  void robotsThatHardlyTurnAreRefusedWithTheReason() {
    TurnLimits found = limits(t -> 0.2 * Math.sin(3 * t), 60, 0);
    for (LimitEstimate e :
        new LimitEstimate[] {found.velocity(), found.acceleration(), found.braking()}) {
      assertThat(e.known()).isFalse();
      assertThat(e.note()).contains("hardly ever turned").contains("2 rad/s");
    }
  }

  @Test
  void aRateThatIsNeverKeptIsOnlyABound() {
    TurnLimits found = limits(turning(11.4, 40, 35), 60, 0);
    assertThat(found.velocity().reached()).isFalse();
    assertThat(found.velocity().value()).isBetween(9.5, 11.5);
    near(found.acceleration(), 40);
  }

  @Test
  void orientationsThatAreNotReportedDoNotCount() {
    assertThat(limits(t -> Double.NaN, 10, 0).turns()).isZero();
  }
}
