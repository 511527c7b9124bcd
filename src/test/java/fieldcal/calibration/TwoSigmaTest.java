package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TwoSigmaTest {
  private static List<Sample> samples(double error, double... values) {
    List<Sample> samples = new ArrayList<>();
    for (double v : values) {
      samples.add(new Sample(samples.size() + 1, "accSlide", v, error, Optional.empty()));
    }
    return samples;
  }

  private static List<Integer> left(List<Sample> samples) {
    return samples.stream().filter(s -> s.dropped().isEmpty()).map(Sample::kickId).toList();
  }

  @Test
  void whatIsFarOffLeavesWithAReason() {
    List<Sample> before = samples(0.05, -3.0, -3.02, -2.98, -3.01, -2.99, -3.05, -2.95, -6);
    List<Sample> after = TwoSigma.repeated(before);
    assertThat(left(after)).containsExactly(1, 2, 3, 4, 5, 6, 7);
    assertThat(after.get(7).dropped())
        .hasValueSatisfying(r -> assertThat(r).contains("acc_slide").contains("σ from the mean"));
    assertThat(after)
        .extracting(Sample::value)
        .isEqualTo(before.stream().map(Sample::value).toList());
  }

  /** The far one hides the less far one in the first round; the second round finds it. */
  @Test
  void roundsGoOnUntilNothingLeaves() {
    List<Sample> before =
        samples(0.05, -3.0, -3.02, -2.98, -3.01, -2.99, -3.05, -2.95, -3.03, -2.97, -3.6, -12);
    assertThat(left(TwoSigma.once(before))).contains(10).doesNotContain(11);
    List<Sample> after = TwoSigma.repeated(before);
    assertThat(left(after)).doesNotContain(10, 11).hasSize(9);
    assertThat(TwoSigma.repeated(after)).isEqualTo(after);
  }

  /** The reason stands beside the distance from the mean, which moves on with each value that is excluded later. */
  @Test
  void reasonsSpeakOfTheMeanThatIsGiven() {
    List<Sample> before =
        samples(0.05, -3.0, -3.02, -2.98, -3.01, -2.99, -3.05, -2.95, -3.03, -2.97, -3.6, -12);
    List<Sample> rounds = TwoSigma.repeated(before);
    List<Sample> after = TwoSigma.restated(rounds);
    assertThat(left(after)).isEqualTo(left(rounds));
    Average mean = Average.of(after);
    assertThat(after.get(10).dropped())
        .contains(
            String.format(
                Locale.ROOT, "acc_slide is %.1f σ from the mean", mean.sigmas(after.get(10))))
        .isNotEqualTo(rounds.get(10).dropped());
    assertThat(after.get(10).leftForItsValue()).isTrue();

    List<Sample> near = samples(0.05, -3.0, -3.02, -2.98, -3.01, -2.99);
    near.set(4, near.get(4).dropForItsValue("acc_slide is 2.3 σ from the mean"));
    Sample restated = TwoSigma.restated(near).get(4);
    assertThat(restated.dropped())
        .contains("acc_slide was excluded earlier; the mean has moved since");
    assertThat(restated.leftForItsValue()).isTrue();
  }

  /** What excludes a sample is no matter of the sentence that says so. */
  @Test
  void aKickIsNoValueWhateverTheReasonSays() {
    Sample sample = samples(0.05, -3.0).get(0);
    assertThat(sample.dropForItsValue("far from the mean").leftForItsValue()).isTrue();
    assertThat(sample.drop("acc_slide cannot be right, said the operator").leftForItsValue())
        .isFalse();
    assertThat(sample.leftForItsValue()).isFalse();
  }

  @Test
  void anImpreciseSampleIsNotDroppedForBeingImprecise() {
    List<Sample> before = samples(0.02, -3.0, -3.02, -2.98, -3.01, -2.99);
    before.add(new Sample(6, "accSlide", -4, 0.8, Optional.empty()));
    assertThat(left(TwoSigma.repeated(before))).contains(6);
  }

  @Test
  void threeSamplesHaveNoScatterToJudgeBy() {
    List<Sample> few = samples(0.01, -3, -3, -9);
    assertThat(TwoSigma.repeated(few)).isEqualTo(few);
    assertThat(TwoSigma.repeated(List.of())).isEmpty();
  }

  @Test
  void whatWasDroppedBeforeStaysDroppedForItsReason() {
    List<Sample> before = samples(0.05, -3.0, -3.02, -2.98, -3.01, -2.99);
    before.set(2, before.get(2).drop("by hand: a foot"));
    assertThat(TwoSigma.repeated(before).get(2).dropped()).contains("by hand: a foot");
  }

  @Test
  void ofGaussianSamplesFewLeaveAndTheMeanStaysRight() {
    SplittableRandom random = new SplittableRandom(6);
    double dropped = 0;
    double bias = 0;
    for (int trial = 0; trial < 200; trial++) {
      List<Sample> samples = new ArrayList<>();
      for (int i = 0; i < 30; i++) {
        double value = 0.1 * AverageTest.gaussian(random);
        samples.add(new Sample(i, "kSwitch", value, 0.1, Optional.empty()));
      }
      List<Sample> after = TwoSigma.repeated(samples);
      dropped += 30 - left(after).size();
      bias += Average.of(after).mean() / 200;
    }
    // 4.6 % in the first round and a few in the next ones.
    assertThat(dropped / (200 * 30)).isBetween(0.03, 0.09);
    assertThat(bias).isEqualTo(0, within(0.005));
  }
}
