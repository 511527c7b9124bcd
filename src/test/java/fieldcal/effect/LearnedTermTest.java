package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Gravity;
import fieldcal.ball.Parameter;
import fieldcal.camera.Camera;
import fieldcal.effect.learned.LearnedFamily;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Polynomial;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Spline;
import fieldcal.effect.learned.Surface;
import fieldcal.effect.learned.Variable;
import fieldcal.effect.motion.FieldSlope;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the contract asks of every effect, for each family of learned terms; and that each changes what it says. */
class LearnedTermTest {
  private static final FlatModel FLAT = new FlatModel(-3.1, -0.28, 0.65);
  private static final ChipModel CHIP = new ChipModel(0.75, 0.95, 0.52, -0.28);
  private static final ObservedCamera CAMERA =
      new ObservedCamera(
          1,
          2,
          Optional.of(Camera.ofPosition(1, 2, 0, 5)),
          Double.NaN,
          Double.NaN,
          Double.NaN,
          Double.NaN,
          0);
  private static final Arena ARENA =
      new Arena(
          -6, 6, -4.5, 4.5, new double[] {20, 100, 600}, true, true, List.of(CAMERA), List.of());

  /** A tenth of the noise of good cameras, m. */
  private static final double SHORT_ENOUGH = 5e-5;

  static List<LearnedTerm> terms() {
    return Stream.concat(LearnedLibrary.of(ARENA).stream(), LearnedLibrary.forms(ARENA).stream())
        .toList();
  }

  /** With coefficients that differ from each other, about half a scale each. */
  static LearnedTerm present(LearnedTerm term) {
    double[] values = new double[term.family().size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = term.family().quantity().scale() * 0.6 * Math.cos(1 + 2.3 * i);
    }
    return term.withParameters(values);
  }

  /** Reports of a flat kick and of a chip from (1, 2), kicked at session time 100 s, m. */
  private static double[] predict(Effect with) {
    MotionEffects motion =
        MotionEffects.of(with instanceof MotionEffect m ? List.of(m) : List.of());
    MeasurementEffects seen =
        MeasurementEffects.of(
            List.of(CAMERA), with instanceof MeasurementEffect m ? List.of(m) : List.of());
    ExtendedTrajectory[] paths = {
      ExtendedTrajectory.flat(FLAT, motion, -100, 0, 1, 2, -4, -1.5),
      ExtendedTrajectory.chipWithHops(CHIP, FLAT, motion, -100, 0, 1, 2, -3, -1, 3.5, 5)
    };
    int n = 60;
    int[] cameras = new int[n];
    double[] stamps = new double[n];
    double[] rows = new double[n];
    for (int i = 0; i < n; i++) {
      cameras[i] = 1;
      stamps[i] = 0.1 * i + 0.01;
    }
    Sightings sightings = new Sightings(cameras, stamps, rows);
    double[] result = new double[4 * n];
    double[] ground = new double[2 * n];
    for (int k = 0; k < 2; k++) {
      seen.report(sightings, paths[k], -100, ground);
      System.arraycopy(ground, 0, result, 2 * n * k, 2 * n);
    }
    return result;
  }

  @ParameterizedTest
  @MethodSource("terms")
  void zeroIsAbsentToTheLastBit(LearnedTerm term) {
    assertThat(term.isAbsent()).isTrue();
    assertThat(present(term).isAbsent()).isFalse();
    assertThat(present(term).withNone()).isEqualTo(term);
    assertThat(predict(term)).isEqualTo(predict(null));
    assertThat(predict(present(term))).isNotEqualTo(predict(null));
  }

  @ParameterizedTest
  @MethodSource("terms")
  void saysWhatItIs(LearnedTerm term) {
    assertThat(term.sentence()).endsWith(".").hasSizeBetween(20, 160);
    assertThat(term.magnitudes()).hasSize(term.family().size()).startsWith("c1");
    assertThat(term.parameters())
        .allMatch(p -> p.estimated() && p.isWithinBounds() && !p.source().isBlank());
    assertThat(term.actsOn()).isIn("ground", "impact", "kick", "measurement");
    LearnedTerm present = present(term);
    assertThat(present.withParameters(present.coefficients())).isEqualTo(present);
    assertThatThrownBy(() -> term.withParameters(new double[99]))
        .isInstanceOf(IllegalArgumentException.class);
    double[] values = present.coefficients();
    values[0] = Double.NaN;
    assertThatThrownBy(() -> term.withParameters(values))
        .isInstanceOf(IllegalArgumentException.class);
  }

  /** Where friction acts aside a path is exact to 0.1 µm, which is that much of a slope over a thousandth of a scale, m. */
  private static final double ASIDE = 1e-7 / 1e-3;

  @ParameterizedTest
  @MethodSource("terms")
  void changesSmoothlyWithItsCoefficients(LearnedTerm term) {
    double rough = term.family().quantity() == Quantity.SLIDING ? ASIDE : 1e-5;
    for (LearnedTerm at : List.of(term, present(term))) {
      for (Parameter p : at.parameters()) {
        double[] coarse = slope(at, p, 1e-2 * p.scale());
        double[] fine = slope(at, p, 1e-3 * p.scale());
        double size = EffectContract.largest(coarse, new double[coarse.length]);
        for (int i = 0; i < fine.length; i++) {
          assertThat(fine[i]).as(p.name()).isEqualTo(coarse[i], within(2e-3 * size + rough));
        }
      }
    }
  }

  /** Central difference per scale, m. */
  private static double[] slope(Effect effect, Parameter p, double step) {
    double[] up = predict(effect.with(p.name(), p.value() + step));
    double[] down = predict(effect.with(p.name(), p.value() - step));
    double[] slope = new double[up.length];
    for (int i = 0; i < slope.length; i++) {
      slope[i] = (up[i] - down[i]) / (2 * step) * p.scale();
    }
    return slope;
  }

  @Test
  void everyFamilyHasItsOwnKey() {
    assertThat(LearnedLibrary.of(ARENA))
        .extracting(t -> t.family().key())
        .doesNotHaveDuplicates()
        .hasSize(40);
  }

  @Test
  void whatCannotShowIsLeftOut() {
    Arena flats = new Arena(-6, 6, -4, 4, new double[0], true, false, List.of(), List.of());
    assertThat(LearnedLibrary.of(flats))
        .noneMatch(t -> t.actsOn().equals("impact") || t.actsOn().equals("measurement"))
        .hasSize(22);
  }

  /** An acceleration that is the same everywhere is accRoll and accSlide changed by it. */
  @Test
  void aConstantAccelerationIsThatOfTheModel() {
    LearnedTerm constant =
        LearnedFamily.of(Quantity.ACCELERATION_ALONG, Variable.SPEED, new Spline(0, 6, 4, false))
            .term(-0.1, -0.1, -0.1, -0.1);
    ExtendedTrajectory rolls =
        ExtendedTrajectory.chipWithHops(
            CHIP, FLAT, MotionEffects.of(List.of((MotionEffect) constant)), 0, 0, 0, 0, 2, 1, 0, 0);
    ExtendedTrajectory slower =
        ExtendedTrajectory.chipWithHops(
            new ChipModel(0.75, 0.95, 0.52, -0.38),
            FLAT,
            MotionEffects.NONE,
            0,
            0,
            0,
            0,
            2,
            1,
            0,
            0);
    assertThat(rolls.restTime()).isEqualTo(slower.restTime(), within(1e-6));
    assertThat(rolls.stateAt(3).x()).isEqualTo(slower.stateAt(3).x(), within(1e-6));
  }

  /** Friction that is the same factor everywhere is accSlide and accRoll times it. */
  @Test
  void aConstantFrictionIsThatOfTheModel() {
    assertBrakesLike(Quantity.FRICTION, 1.2 * FLAT.accSlide());
  }

  /** Rolling that is the same factor everywhere is accRoll times it, and sliding is as before. */
  @Test
  void aConstantRollingIsThatOfTheModel() {
    assertBrakesLike(Quantity.ROLLING, FLAT.accSlide());
  }

  /** A fifth more of a quantity everywhere is a model with a fifth more accRoll, and this accSlide. */
  private static void assertBrakesLike(Quantity quantity, double accSlide) {
    LearnedTerm constant =
        LearnedFamily.of(quantity, Variable.SPEED, new Spline(0, 8, 4, false))
            .term(0.2, 0.2, 0.2, 0.2);
    ExtendedTrajectory braked =
        ExtendedTrajectory.flat(
            FLAT, MotionEffects.of(List.of((MotionEffect) constant)), 0, 0, 0, 0, 4, 1);
    FlatModel stronger = new FlatModel(accSlide, 1.2 * FLAT.accRoll(), FLAT.kSwitch());
    ExtendedTrajectory same =
        ExtendedTrajectory.flat(stronger, MotionEffects.NONE, 0, 0, 0, 0, 4, 1);
    assertThat(braked.restTime()).isEqualTo(same.restTime(), within(1e-6));
    for (double t : new double[] {0.3, 2}) {
      assertThat(braked.stateAt(t).x()).isEqualTo(same.stateAt(t).x(), within(1e-6));
    }
  }

  /** Steps an eighth as long change the path by less than a twentieth of a millimetre. */
  @ParameterizedTest
  @MethodSource("terms")
  void theIntegratorsStepsAreShortEnough(LearnedTerm term) {
    if (present(term) instanceof MotionEffect.PathAcceleration acceleration) {
      double[] usual = predict(acceleration);
      assertThat(predict(new ShortSteps(acceleration)))
          .containsExactly(usual, within(SHORT_ENOUGH));
    }
  }

  /** The same acceleration, for which the integrator makes shorter steps. */
  private record ShortSteps(MotionEffect.PathAcceleration effect)
      implements MotionEffect.PathAcceleration {
    @Override
    public String id() {
      return effect.id();
    }

    @Override
    public String sentence() {
      return effect.sentence();
    }

    @Override
    public List<Parameter> parameters() {
      return effect.parameters();
    }

    @Override
    public MotionEffect withParameters(double... values) {
      throw new UnsupportedOperationException();
    }

    @Override
    public boolean isAbsent() {
      return false;
    }

    @Override
    public double along(BallMotion motion) {
      return effect.along(motion);
    }

    @Override
    public double across(BallMotion motion) {
      return effect.across(motion);
    }

    @Override
    public double longestStep(BallMotion motion) {
      return Math.min(0.005, effect.longestStep(motion) / 8);
    }
  }

  @Test
  void anAccelerationAcrossTurnsTheBallToItsLeft() {
    LearnedTerm left =
        LearnedFamily.of(Quantity.ACCELERATION_ACROSS, Variable.SPEED, new Spline(0, 6, 3, false))
            .term(0.1, 0.1, 0.1);
    ExtendedTrajectory path =
        ExtendedTrajectory.chipWithHops(
            CHIP, FLAT, MotionEffects.of(List.of((MotionEffect) left)), 0, 0, 0, 0, 3, 0, 0, 0);
    assertThat(path.stateAt(1).y()).isEqualTo(0.05, within(0.002));
  }

  /** On top of a mound a rolling ball has lost (10/7)·g·h of its squared speed, and behind it has it back. */
  @Test
  void aBallHasItsSpeedAgainBehindAMound() {
    int knots = 9;
    double[] heights = new double[knots * knots];
    heights[heights.length / 2] = 6;
    Spline axis = new Spline(-2, 2, knots, false);
    LearnedTerm mound =
        LearnedFamily.of(Quantity.FLOOR, Variable.PLACE, new Surface(axis, axis, false))
            .term(heights);
    FlatModel hardlyBraked = new FlatModel(-3, -1e-7, 5.0 / 7);
    ExtendedTrajectory crosses =
        ExtendedTrajectory.flat(
            hardlyBraked, MotionEffects.of(List.of((MotionEffect) mound)), 0, 0, -3, 0, 1.4, 0);
    double rolling = 1;
    double top = 0;
    while (crosses.stateAt(top).x() < 0) {
      top += 1e-4;
    }
    double loss = 10.0 / 7 * Gravity.ACCELERATION * 1e-3 * mound.valueAt(0, 0, 0);
    assertThat(mound.valueAt(0, 0, 0)).isEqualTo(6 * 4.0 / 9, within(1e-9));
    assertThat(crosses.stateAt(top).vx()).isEqualTo(Math.sqrt(rolling - loss), within(1e-5));
    assertThat(crosses.stateAt(top + 3).vx()).isEqualTo(rolling, within(1e-5));
  }

  @Test
  void aFloorNeedsASurface() {
    assertThatThrownBy(
            () ->
                LearnedFamily.of(
                    Quantity.FLOOR, Variable.PLACE, new Polynomial(2, -1, 1, -1, 1, true)))
        .hasMessage("basis: must be a surface for floor, but is polynomial");
  }

  @Test
  void aCurveOfTheHopChangesThatImpact() {
    LearnedFamily hops =
        terms().stream()
            .map(LearnedTerm::family)
            .filter(f -> f.key().equals("vertical_restitution/hop"))
            .findFirst()
            .orElseThrow();
    MotionEffects second = MotionEffects.of(List.of((MotionEffect) hops.term(-0.1, 0, 0)));
    ExtendedTrajectory changed =
        ExtendedTrajectory.chipWithHops(CHIP, FLAT, second, 0, 0, 0, 0, 3, 0, 3, 3);
    ExtendedTrajectory same =
        ExtendedTrajectory.chipWithHops(CHIP, FLAT, MotionEffects.NONE, 0, 0, 0, 0, 3, 0, 3, 3);
    // First flight 0.61 s, second 0.32 s, third 0.17 s.
    assertThat(changed.stateAt(0.9).z()).isEqualTo(same.stateAt(0.9).z(), within(1e-12));
    assertThat(changed.stateAt(1).z()).isLessThan(same.stateAt(1).z() - 1e-3);
  }

  @Test
  void aTurnAtAnImpactTurnsThePath() {
    LearnedTerm turn =
        new LearnedFamily(
                Quantity.TURN,
                List.of(Variable.GROUND_SPEED),
                new Spline(0, 5, 3, false),
                OptionalInt.empty())
            .term(0.02, 0.02, 0.02);
    ExtendedTrajectory path =
        ExtendedTrajectory.chipWithHops(
            CHIP, FLAT, MotionEffects.of(List.of((MotionEffect) turn)), 0, 0, 0, 0, 3, 0, 3, 2);
    var s = path.stateAt(1.5);
    assertThat(Math.atan2(s.vy(), s.vx())).isEqualTo(0.04, within(1e-9));
  }

  @Test
  void whatDependsOnTheSessionTimeIsLeftOutWhereThatIsNotKnown() {
    LearnedTerm shift =
        LearnedFamily.of(Quantity.SHIFT, Variable.SESSION_TIME, new Spline(0, 10, 3, false), 1)
            .term(10, 10, 10, -20, -20, -20);
    MeasurementEffects seen =
        MeasurementEffects.of(List.of(CAMERA), List.of((MeasurementEffect) shift));
    double[] ground = new double[2];
    seen.report(1, 5, new double[] {1, 2, 0}, ground);
    assertThat(ground).containsExactly(new double[] {1.01, 1.98}, within(1e-12));
    seen.report(1, new double[] {1, 2, 0}, ground);
    assertThat(ground).containsExactly(new double[] {1, 2}, within(1e-12));
  }

  /** The slope alone would set the ball free again, and what was learned stops it at once: it must stay at rest. */
  @Test
  void aBallThatALearnedBrakeHoldsRests() {
    LearnedFamily family =
        LearnedFamily.of(Quantity.ACCELERATION_ALONG, Variable.SPEED, new Spline(0, 6.5, 6, true));
    MotionEffect brake = (MotionEffect) family.term(-0.1, 0, 0, 0, 0);
    MotionEffects motion = MotionEffects.of(List.of(new FieldSlope(4.5, 0), brake));
    ExtendedTrajectory path = ExtendedTrajectory.flat(FLAT, motion, 0, 0, 0, 0, 1, 0);
    double kSwitch = 0.65;
    // Later than without the slope, and sooner than with half of what brakes the ball at rest.
    double least = 0.28 + 0.1 - 0.045 * 9.81 * 5 / 7;
    assertThat(path.restTime()).isBetween(kSwitch / 0.28, 2 * kSwitch / least);
  }
}
