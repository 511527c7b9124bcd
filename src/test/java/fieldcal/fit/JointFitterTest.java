package fieldcal.fit;

import static fieldcal.fit.FitSupport.CLEAN;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Simulated kicks that share one model and are seen by cameras that disagree. */
class JointFitterTest {
  private static final FlatModel FLAT = new FlatModel(-3.1, -0.28, 0.63);
  private static final ChipModel CHIP = new ChipModel(0.74, 0.93, 0.52, -0.28);

  /** An offset of some millimetres is what is left once the first estimate was taken out, m. */
  private static final double[][] OFFSETS = {
    {0.004, -0.002}, {-0.004, 0.002}, {0.001, 0.003}, {-0.001, -0.003}
  };

  private final SplittableRandom random = new SplittableRandom(99);
  private final IdealKicks source = new IdealKicks(CLEAN.noise());
  private final KickFitter fitter = new KickFitter(FitSettings.defaults());
  private final JointFitter joint = new JointFitter(FitSettings.defaults());

  private IdealKicks.Sample draw(KickKind kind, int id) {
    return draw(kind, id, CHIP);
  }

  private IdealKicks.Sample draw(KickKind kind, int id, ChipModel chip) {
    double[] truth =
        kind == KickKind.FLAT
            ? IdealKicks.flatTruth(random.split())
            : IdealKicks.chipTruth(random.split());
    double[] model =
        (kind == KickKind.FLAT ? FLAT.parameters() : chip.parameters())
            .stream().mapToDouble(p -> p.value()).toArray();
    System.arraycopy(model, 0, truth, FlightLayout.kickSize(kind), model.length);
    return source.observe(kind, truth, id, CLEAN, random.split());
  }

  /** The kick with its cameras renamed and each camera's offset added. */
  private static Kick shifted(Kick kick, IntUnaryOperator camera) {
    Observations o = kick.observations();
    Observations.Builder b = new Observations.Builder();
    for (int i = 0; i < o.size(); i++) {
      int id = camera.applyAsInt(o.camera(i));
      double[] offset = OFFSETS[id];
      b.add(o.time(i), id, o.x(i) + offset[0], o.y(i) + offset[1], o.pixelX(i), o.pixelY(i));
    }
    return FitSupport.with(kick, true, b.build());
  }

  private CameraViews fourViews() {
    List<CameraView> views = new ArrayList<>(source.views().all());
    for (CameraView v : source.views().all()) {
      views.add(new CameraView(v.id() + 2, v.camera(), 0, 0, v.noise()));
    }
    return CameraViews.of(views);
  }

  private KickFit fit(Kick kick, CameraViews views, KickKind kind) {
    FlatModel flat = new FlatModel(-3.5, -0.25, 0.6);
    ChipModel chip = new ChipModel(0.8, 0.85, 0.47, -0.28);
    return fitter.fit(FitProblem.of(kick, views, flat, chip).withChipRollFixed(-0.28), kind);
  }

  private JointFit solve(List<KickFit> fits, CameraViews views) {
    return joint.fit(problem(fits, views));
  }

  private JointProblem problem(List<KickFit> fits, CameraViews views) {
    return new JointProblem(
        fits,
        views,
        new FlatModel(-3.5, -0.25, 0.6),
        new ChipModel(0.8, 0.85, 0.47, -0.28),
        OptionalDouble.of(-0.28),
        true);
  }

  private static void assertRecovered(Estimate e, double truth) {
    assertThat(e.usable()).as(e.toString()).isTrue();
    assertThat(Math.abs(e.value() - truth) / e.standardError())
        .as(e.toString())
        .isLessThan(FitSupport.FAR);
    assertThat(e.value()).isEqualTo(truth, within(0.01 * Math.abs(truth)));
  }

  @Test
  void findsSharedModelAndOffsetsOfTwoGroupsOfCamerasThatShareNoKick() {
    CameraViews views = fourViews();
    List<KickFit> fits = new ArrayList<>();
    for (int id = 1; id <= 16; id++) {
      KickKind kind = id % 2 == 0 ? KickKind.FLAT : KickKind.CHIP;
      int rename = id % 4 < 2 ? 0 : 2;
      fits.add(fit(shifted(draw(kind, id).kick(), c -> c + rename), views, kind));
    }
    JointFit fit = solve(fits, views);
    assertThat(fit.converged()).isTrue();
    JointFitter.Rough rough = joint.fitRoughly(problem(fits, views));
    fit.offsets()
        .forEach(
            (id, o) -> {
              assertThat(rough.offsets().get(id).x()).isEqualTo(o.x(), within(o.errorX()));
              assertThat(rough.offsets().get(id).y()).isEqualTo(o.y(), within(o.errorY()));
            });
    assertRecovered(fit.flat("accSlide").orElseThrow(), FLAT.accSlide());
    assertRecovered(fit.flat("accRoll").orElseThrow(), FLAT.accRoll());
    assertRecovered(fit.flat("kSwitch").orElseThrow(), FLAT.kSwitch());
    assertRecovered(fit.chip("dampingXyFirstHop").orElseThrow(), CHIP.dampingXyFirstHop());
    assertRecovered(fit.chip("dampingXyOtherHops").orElseThrow(), CHIP.dampingXyOtherHops());
    assertRecovered(fit.chip("dampingZ").orElseThrow(), CHIP.dampingZ());
    assertThat(fit.chip("accRoll").orElseThrow().value()).isEqualTo(-0.28);
    assertThat(fit.offsets()).containsOnlyKeys(0, 1, 2, 3);
    fit.offsets()
        .forEach(
            (id, o) -> {
              assertThat(o.x()).isEqualTo(OFFSETS[id][0], within(5 * o.errorX()));
              assertThat(o.y()).isEqualTo(OFFSETS[id][1], within(5 * o.errorY()));
              assertThat(o.errorX()).isBetween(1e-5, 3e-4);
            });
    // Within each group the mean is zero, or all its kicks could move along.
    assertThat(fit.offsets().get(0).x() + fit.offsets().get(1).x()).isEqualTo(0, within(1e-6));
    assertThat(fit.offsets().get(2).y() + fit.offsets().get(3).y()).isEqualTo(0, within(1e-6));
    assertThat(fit.reducedChiSquare()).isBetween(0.9, 1.1);
    assertThat(fit.rmsMm()).isBetween(1.3, 1.9);
    assertThat(fit.oneModel().rmsMm())
        .as("all kicks are alike")
        .isEqualTo(fit.rmsMm(), within(0.1));
  }

  @Test
  void theErrorIsThatOfAllKicksTogether() {
    List<KickFit> fits = new ArrayList<>();
    for (int id = 1; id <= 12; id++) {
      fits.add(fit(draw(KickKind.FLAT, id).kick(), source.views(), KickKind.FLAT));
    }
    JointFit fit = solve(fits, source.views());
    for (String name : List.of("accSlide", "accRoll", "kSwitch")) {
      double weights = 0;
      double best = Double.POSITIVE_INFINITY;
      for (KickFit single : fits) {
        double error = single.estimate(name).standardError();
        weights += 1 / (error * error);
        best = Math.min(best, error);
      }
      Estimate e = fit.flat(name).orElseThrow();
      assertRecovered(
          e,
          FLAT.parameters().stream()
              .filter(p -> p.name().equals(name))
              .findFirst()
              .orElseThrow()
              .value());
      assertThat(e.standardError()).as(name).isLessThan(best);
      // Jointly a little better than averaged, since parameters of a kick correlate; the scatter
      // between twelve kicks is itself uncertain by a fifth.
      assertThat(e.standardError() * Math.sqrt(weights)).as(name).isBetween(0.4, 2.0);
    }
    assertThat(fit.chip()).isEmpty();
    assertThat(fit.rmsChipMm()).isNaN();
    assertThat(fit.rmsFlatMm()).isEqualTo(fit.rmsMm());
  }

  /** All kicks that bend seem to slide for longer: taken like the others they would pull the joint fit to one side. */
  @Test
  void kicksThatBendDoNotPullTheOthersAlong() {
    double[] bends = {0, 0.03, -0.06, 0.1, -0.14, 0.02, 0.08, -0.02, 0.12, -0.05, 0.01, -0.1};
    List<KickFit> fits = new ArrayList<>();
    for (int id = 1; id <= bends.length; id++) {
      source.sideSpin(bends[id - 1]);
      fits.add(fit(draw(KickKind.FLAT, id).kick(), source.views(), KickKind.FLAT));
    }
    JointFit fit = solve(fits, source.views());
    for (Parameter truth : FLAT.parameters()) {
      Estimate e = fit.flat(truth.name()).orElseThrow();
      double off = Math.abs(e.value() - truth.value());
      assertThat(off / e.standardError()).as(e.toString()).isLessThan(2);
      assertThat(off).as(e.toString()).isLessThan(0.005 * Math.abs(truth.value()));
    }
  }

  /** A third of the chips has backspin: between the two sides, where a normal scatter has its mean, no kick is. */
  @Test
  void kicksOfTwoSidesGiveTheMedianAndAnErrorThatCoversBoth() {
    ChipModel spun = new ChipModel(0.70, 0.90, 0.52, -0.28);
    List<KickFit> fits = new ArrayList<>();
    for (int id = 1; id <= 12; id++) {
      Kick kick = draw(KickKind.CHIP, id, id % 3 == 0 ? spun : CHIP).kick();
      fits.add(fit(kick, source.views(), KickKind.CHIP));
    }
    JointFit fit = solve(fits, source.views());
    Estimate first = fit.chip("dampingXyFirstHop").orElseThrow();
    Estimate others = fit.chip("dampingXyOtherHops").orElseThrow();
    assertThat(first.value()).isEqualTo(0.74, within(0.003));
    assertThat(first.standardError()).isBetween(0.012, 0.04);
    assertThat(others.value()).isEqualTo(0.93, within(0.002));
    assertThat(others.standardError()).isBetween(0.009, 0.03);
    assertThat(fit.chip("dampingZ").orElseThrow().value()).isEqualTo(0.52, within(0.005));
    assertThat(Math.sqrt(fit.reducedChiSquare())).isBetween(0.9, 1.1);
    assertThat(Math.sqrt(fit.oneModel().reducedChiSquare()))
        .as("no model is both")
        .isGreaterThan(3);
    assertThat(fit.oneModel().rmsMm()).isGreaterThan(3 * fit.rmsMm());
  }

  @Test
  void oneCameraAloneHasNoOffset() {
    List<KickFit> fits = new ArrayList<>();
    for (int id = 1; id <= 6; id++) {
      Kick kick = draw(KickKind.FLAT, id).kick();
      // The camera on the side the kick came from saw rest and kick.
      int camera = kick.x() < 0 ? 0 : 1;
      Observations o = kick.observations();
      Kick single = FitSupport.with(kick, true, FitSupport.pick(o, i -> o.camera(i) == camera));
      Observations renamed = single.observations();
      Observations.Builder b = new Observations.Builder();
      for (int i = 0; i < renamed.size(); i++) {
        // Mirrored, so that there is but one camera.
        double side = camera == 0 ? 1 : -1;
        b.add(renamed.time(i), 0, side * renamed.x(i), renamed.y(i), 0, 0);
      }
      double side = camera == 0 ? 1 : -1;
      Kick k = single;
      Kick seen =
          new Kick(
              id,
              k.time(),
              side * k.x(),
              k.y(),
              side * k.vx(),
              k.vy(),
              k.robot(),
              true,
              k.end(),
              k.endTime(),
              b.build());
      fits.add(fit(seen, source.views(), KickKind.FLAT));
    }
    JointFit fit = solve(fits, source.views());
    assertRecovered(fit.flat("accSlide").orElseThrow(), FLAT.accSlide());
    assertThat(fit.offsets()).containsOnlyKeys(0);
    assertThat(fit.offsets().get(0).x()).isZero();
    assertThat(fit.offsets().get(0).errorX()).isNaN();
  }

  /** A kick that stops early says nothing of rolling on its own, and adds to the joint fit what it knows. */
  @Test
  void whatNoKickDeterminesIsRefused() {
    List<KickFit> fits = new ArrayList<>();
    for (int id = 1; id <= 4; id++) {
      IdealKicks.Sample s = draw(KickKind.FLAT, id);
      double[] p = s.truth();
      double speed = Math.hypot(p[2], p[3]);
      Kick caught = FitSupport.until(s.kick(), p[4] + 0.8 * speed * (1 - 0.63) / 3.1);
      fits.add(fit(caught, source.views(), KickKind.FLAT));
    }
    JointFit fit = solve(fits, source.views());
    assertThat(fit.flat("accSlide").orElseThrow().usable()).isTrue();
    assertThat(fit.flat("accRoll").orElseThrow().usable()).isFalse();
    assertThat(fit.flat("accRoll").orElseThrow().undetermined()).isPresent();
    assertThat(fit.flat("kSwitch").orElseThrow().usable()).isFalse();
  }

  /**
   * Each kick bounces a little differently, and the noise is 0.3 mm. A fit that takes the kicks for alike weights them by that noise alone: it was up to 1.1 % off the mean of dampingXyFirstHop here or gave it too large an error,
   * and failed for all five seeds.
   */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void chipsThatDifferFromKickToKickAreAveragedHoweverLowTheNoise(long seed) {
    double noise = 0.0003;
    int n = 20;
    SplittableRandom drawn = new SplittableRandom(seed);
    IdealKicks quiet = new IdealKicks(noise);
    IdealKicks.Conditions conditions = new IdealKicks.Conditions(noise, 0, 0);
    List<KickFit> fits = new ArrayList<>();
    double[] mean = new double[3];
    double[] scatter = {0.02, 0.02, 0.05};
    double[] typical = {0.70, 0.92, 0.49};
    for (int id = 1; id <= n; id++) {
      double[] truth = IdealKicks.chipTruth(drawn.split());
      for (int k = 0; k < mean.length; k++) {
        truth[6 + k] = typical[k] + scatter[k] * IdealKicks.gaussian(drawn);
        mean[k] += truth[6 + k] / n;
      }
      truth[9] = -0.28;
      Kick kick = quiet.observe(KickKind.CHIP, truth, id, conditions, drawn.split()).kick();
      fits.add(fit(kick, quiet.views(), KickKind.CHIP));
    }
    JointFit fit = solve(fits, quiet.views());
    assertThat(fit.converged()).isTrue();
    String[] names = {"dampingXyFirstHop", "dampingXyOtherHops", "dampingZ"};
    for (int k = 0; k < names.length; k++) {
      Estimate e = fit.chip(names[k]).orElseThrow();
      double expected = scatter[k] / Math.sqrt(n);
      assertThat(e.value()).as("%s", e).isEqualTo(mean[k], within(0.3 * expected));
      // The scatter of twenty is known to a sixth.
      assertThat(e.standardError()).as("%s", e).isBetween(0.6 * expected, 1.6 * expected);
    }
  }

  @Test
  void needsAKick() {
    JointProblem none =
        new JointProblem(List.of(), source.views(), FLAT, CHIP, OptionalDouble.empty(), true);
    assertThatThrownBy(() -> joint.fit(none)).isInstanceOf(IllegalArgumentException.class);
  }
}
