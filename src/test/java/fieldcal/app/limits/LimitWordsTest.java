package fieldcal.app.limits;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.movement.Envelope;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.MovementEffect;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.TeamLimits;
import fieldcal.movement.TurnLimits;
import fieldcal.vision.Team;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class LimitWordsTest {
  private static LimitEstimate of(double value) {
    return new LimitEstimate(value, 0.01, 100, true, "");
  }

  private static String words(LimitEstimate braking, MovementEffect effect, String seenIn) {
    LimitDeviation deviation = new LimitDeviation(effect, 0.4, 0.01, seenIn, 0.3, 0.9);
    return LimitWords.sentence(limits(braking, List.of(deviation), List.of()), deviation);
  }

  private static TeamLimits limits(
      LimitEstimate braking, List<LimitDeviation> deviations, List<Envelope> envelopes) {
    return new TeamLimits(
        Team.BLUE,
        of(3),
        of(4),
        braking,
        of(3.1),
        of(4.5),
        of(8),
        deviations,
        List.of(),
        new TurnLimits(of(10), of(40), of(40), 100),
        envelopes,
        List.of(),
        100);
  }

  private static String oneLimit(int directions) {
    List<Envelope.Point> points =
        IntStream.range(0, directions)
            .mapToObj(i -> new Envelope.Point(2 * Math.PI * i / Envelope.DIRECTIONS, 3, 0.1, 20))
            .toList();
    Envelope envelope = new Envelope("acceleration", points, 0.4, 0.4, false);
    return LimitWords.oneLimit(limits(of(5), List.of(), List.of(envelope)));
  }

  /** "Known in 2 of 36 directions" and "one limit holds for all directions" contradict each other. */
  @Test
  void nothingIsSaidOfDirectionsThatWereNotMeasured() {
    assertThat(oneLimit(2))
        .isEqualTo(
            "no difference between the speeds that were driven, nor between the directions that"
                + " were measured (2 of 36)");
    assertThat(oneLimit(1))
        .isEqualTo(
            "no difference between the speeds that were driven; too few manoeuvres to compare"
                + " directions");
    assertThat(oneLimit(36)).isEqualTo("one limit holds for all speeds and directions");
  }

  @Test
  void anEffectIsToldInWhatIsLeftOfTheLimit() {
    assertThat(words(of(5), MovementEffect.TORQUE_LIMITED, "acceleration"))
        .isEqualTo(
            "accelerates less the faster it drives: 4.00 m/s² from standstill, 2.40 m/s² at 3.00"
                + " m/s");
    assertThat(words(of(5), MovementEffect.DIRECTIONAL, "acceleration"))
        .isEqualTo(
            "accelerates less sideways than along its front: 4.00 m/s² along it, 2.40 m/s²"
                + " sideways");
    assertThat(words(of(5), MovementEffect.DIRECTIONAL, "braking"))
        .isEqualTo(
            "brakes less sideways than along its front: 5.00 m/s² along it, 3.00 m/s² sideways");
  }

  @Test
  void anEnvelopeIsToldByItsStrongestAndWeakestDirection() {
    List<Envelope.Point> points =
        List.of(
            new Envelope.Point(0, 3.5, 0.04, 20),
            new Envelope.Point(Math.PI / 2, 1.5, 0.02, 10),
            new Envelope.Point(Math.PI, 3, 0.04, 20));
    assertThat(LimitWords.sentence(new Envelope("acceleration", points, 0.4, 0.8, true)))
        .isEqualTo(
            "acceleration by direction: strongest 3.50 ± 0.04 m/s² at 0°, weakest 1.50 ± 0.02 m/s²"
                + " at 90° (0° is the front, 90° the left); known in 3 of 36 directions");
    Envelope single = new Envelope("braking", points.subList(0, 1), 0.4, 0.8, false);
    assertThat(LimitWords.sentence(single))
        .isEqualTo(
            "braking by direction: 3.50 ± 0.04 m/s² at 0° (0° is the front, 90° the left); known in"
                + " 1 of 36 directions");
  }

  @Test
  void aRobotThatDiffersIsComparedWithItsTeamMates() {
    assertThat(LimitWords.sentence(new RobotDifference(3, "braking", 3, 0.02, 4, 51)))
        .isEqualTo(
            "robot 3 is weaker: braking 3.00 ± 0.02 m/s², 75 % of its team mates' 4.00 m/s² (51"
                + " manoeuvres)");
    assertThat(LimitWords.sentence(new RobotDifference(3, "braking", 5, 0.02, 4, 51)))
        .contains("is stronger")
        .contains("125 %");
  }

  @Test
  void withoutALimitNothingIsInvented() {
    LimitEstimate unknown = new LimitEstimate(Double.NaN, Double.NaN, 0, false, "too few");
    assertThat(words(unknown, MovementEffect.DIRECTIONAL, "braking"))
        .isEqualTo("brakes less sideways than along its front");
  }
}
