package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Chips whose bounces differ from each other, because the ball spins. */
class UnevenBouncesTest {
  private static final ChipModel CHIP = new ChipModel(0.72, 0.91, 0.5, -0.28);

  /** What makes a first hop of 0.71 one of 0.64, as a well-known simulator's are, in units of rolling spin. */
  private static final double BACKSPIN = -0.25;

  /** Good cameras, m. */
  private static final double NOISE = 0.0007;

  private static final IdealKicks.Conditions CONDITIONS = new IdealKicks.Conditions(NOISE, 0, 0);

  private final IdealKicks source = new IdealKicks(NOISE);

  private FitProblem problem(SplittableRandom random, int id, double spin) {
    double[] truth = IdealKicks.chipTruth(random.split());
    double[] model = CHIP.parameters().stream().mapToDouble(p -> p.value()).toArray();
    System.arraycopy(model, 0, truth, FlightLayout.kickSize(KickKind.CHIP), model.length);
    source.rollSpin(spin);
    IdealKicks.Sample s = source.observe(KickKind.CHIP, truth, id, CONDITIONS, random.split());
    return FitProblem.of(s.kick(), source.views(), FlatModel.typical(), ChipModel.typical())
        .withChipRollFixed(CHIP.accRoll());
  }

  private KickFit fit(SplittableRandom random, int id, double spin) {
    return FitSupport.fit(problem(random, id, spin), KickKind.CHIP);
  }

  /** By how much this kick's bounces are damped otherwise than those of a ball without spin. */
  private static double apart(KickFit fit) {
    return Math.abs(fit.estimate("dampingXyOtherHops").value() - CHIP.dampingXyOtherHops());
  }

  private static double pull(Estimate e) {
    return (e.value() - CHIP.dampingZ()) / e.standardError();
  }

  @Test
  void valuesAndTheKicksOwnDampingStay() {
    SplittableRandom random = new SplittableRandom(1);
    for (int id = 1; id <= 6; id++) {
      KickFit plain = fit(random, id, 0);
      KickFit covered = plain.withUnevenBounces(source.views(), 0.03);
      assertThat(covered.values()).isEqualTo(plain.values());
      double other = plain.estimate("dampingXyOtherHops").standardError();
      assertThat(covered.estimate("dampingXyOtherHops").standardError())
          .isEqualTo(other, within(1e-9 * other));
      boolean several = plain.statistics().flights() > 2;
      double before = plain.estimate("dampingZ").standardError();
      double after = covered.estimate("dampingZ").standardError();
      assertThat(after / before).as("%s", plain).isBetween(several ? 1.01 : 1.0, 10.0);
      assertThat(covered.bounces().size())
          .isEqualTo(several ? plain.statistics().flights() - 2 : 0);
    }
  }

  @Test
  void lowHopsThatNobodySeesHaveNoDeviationsOfTheirOwn() {
    SplittableRandom random = new SplittableRandom(5);
    double[] truth = IdealKicks.chipTruth(random.split());
    double[] model = {0.75, 0.99, 0.82, -0.28};
    System.arraycopy(model, 0, truth, FlightLayout.kickSize(KickKind.CHIP), model.length);
    IdealKicks.Sample s = source.observe(KickKind.CHIP, truth, 1, CONDITIONS, random.split());
    KickFit plain =
        FitSupport.fit(
            FitProblem.of(s.kick(), source.views(), FlatModel.typical(), CHIP)
                .withChipRollFixed(CHIP.accRoll()),
            KickKind.CHIP);
    KickFit covered = plain.withUnevenBounces(source.views(), 0.002);
    System.out.printf(
        Locale.ROOT,
        "%d flights, %d deviations%n",
        plain.statistics().flights(),
        covered.bounces().size());
    assertThat(plain.statistics().flights()).isGreaterThan(8);
    assertThat(covered.bounces().size()).isBetween(1, plain.statistics().flights() / 2);
  }

  @Test
  void evenBouncesAndFlatKicksStayAsTheyAre() {
    SplittableRandom random = new SplittableRandom(2);
    KickFit chip = fit(random, 1, 0);
    assertThat(chip.withUnevenBounces(source.views(), 0)).isSameAs(chip);
    IdealKicks.Sample s = source.draw(KickKind.FLAT, 2, CONDITIONS, random);
    KickFit flat = FitSupport.fit(FitSupport.problem(s, source.views(), random), KickKind.FLAT);
    assertThat(flat.withUnevenBounces(source.views(), 0.03)).isSameAs(flat);
    KickFit failed = KickFit.failed(chip.kick(), KickKind.CHIP, "test", 1);
    assertThat(failed.withUnevenBounces(source.views(), 0.03)).isSameAs(failed);
  }

  /** What the spin does to the dampings of the kick is known; what it does to single bounces is not. */
  @Test
  void errorsOfASpinningBallCoverWhatItsBouncesMove() {
    SplittableRandom random = new SplittableRandom(3);
    double plainSquares = 0;
    double worst = 0;
    int n = 30;
    for (int id = 1; id <= n; id++) {
      KickFit plain = fit(random, id, BACKSPIN);
      KickFit covered = plain.withUnevenBounces(source.views(), apart(plain));
      double before = pull(plain.estimate("dampingZ"));
      plainSquares += before * before / n;
      worst = Math.max(worst, Math.abs(pull(covered.estimate("dampingZ"))));
    }
    assertThat(Math.sqrt(plainSquares)).isGreaterThan(1.5);
    assertThat(worst).isLessThan(3);
  }

  /** A third of the chips spins: the joint fit believes the others, and knows by how much. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void someChipsThatSpinDoNotMoveDampingZ(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<KickFit> plain = new ArrayList<>();
    for (int id = 1; id <= 12; id++) {
      plain.add(fit(random, id, id % 3 == 0 ? BACKSPIN : 0));
    }
    List<KickFit> covered = new ArrayList<>();
    for (KickFit f : plain) {
      boolean spins = f.kick().id() % 3 == 0;
      covered.add(spins ? f.withUnevenBounces(source.views(), apart(f)) : f);
    }
    Estimate before = jointly(plain);
    Estimate after = jointly(covered);
    assertThat(Math.abs(pull(after))).as("%s, plain %s", after, before).isLessThan(3);
    // What spins counts for less, and what does not counts for as much as before.
    assertThat(after.standardError()).isLessThan(2 * before.standardError());
  }

  private Estimate jointly(List<KickFit> fits) {
    return new JointFitter(FitSettings.defaults())
        .fit(
            new JointProblem(
                fits,
                source.views(),
                FlatModel.typical(),
                ChipModel.typical(),
                OptionalDouble.of(CHIP.accRoll()),
                true))
        .chip("dampingZ")
        .orElseThrow();
  }
}
