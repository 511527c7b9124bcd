package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.JointFit;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Whole calibrations of the recordings in test-data; the numbers they must reach are those of the project's acceptance. */
class CalibratorTest {
  private static final Path DATA =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  private static CollectedKicks erforceKicks;
  private static CollectedKicks idealKicks;
  private static Calibration erforce;
  private static Calibration ideal;

  @BeforeAll
  static void calibrate() throws IOException {
    erforceKicks = collect("erforce-flat", "erforce-chip");
    idealKicks = collect("world-null-flat", "world-null-chip");
    erforce = calibrate(erforceKicks, HandSelection.none(), Optional.empty());
    ideal = calibrate(idealKicks, HandSelection.none(), Optional.empty());
  }

  private static CollectedKicks collect(String... names) throws IOException {
    List<Path> logs = Stream.of(names).map(n -> DATA.resolve(n + ".log.gz")).toList();
    return new KickCollector((log, read, total) -> {}).collect(logs);
  }

  private static Calibration calibrate(
      CollectedKicks data, HandSelection selection, Optional<KickKind> kind) {
    return calibrate(data, data.kicks(), selection, kind);
  }

  private static Calibration calibrate(
      CollectedKicks data, List<Kick> kicks, HandSelection selection, Optional<KickKind> kind) {
    FlatModel flat = data.published().flat().orElse(FlatModel.typical());
    ChipModel chip = data.published().chip().orElse(ChipModel.typical());
    return new Calibrator(FitSettings.defaults())
        .calibrate(
            new CalibrationProblem(
                kicks, data.epoch(), data.cameras(), flat, chip, kind, selection),
            kick -> {});
  }

  private static List<Kick> flats(CollectedKicks data) {
    return data.kicks().stream().filter(k -> data.sources().get(k.id()).contains("flat")).toList();
  }

  @Test
  void everyKickIsThereWithItsKind() {
    assertKinds(erforce, erforceKicks, 28, 32);
    assertKinds(ideal, idealKicks, 24, 24);
  }

  private static void assertKinds(Calibration c, CollectedKicks data, int flats, int chips) {
    assertThat(c.kicks(KickKind.FLAT)).hasSize(flats);
    assertThat(c.kicks(KickKind.CHIP)).hasSize(chips);
    for (CalibratedKick k : c.kicks()) {
      assertThat(data.sources().get(k.fit().kick().id()))
          .as(k.fit().toString())
          .contains(k.fit().kind().id());
    }
  }

  /** In ER-Force's simulator chips bounce in two ways; in the ideal one all alike. */
  @Test
  void errorsCoverBouncesThatDifferWhereChipsDifferAndOnlyThere() {
    assertThat(widest(erforce, erforceKicks)).isGreaterThan(1.2);
    assertThat(widest(ideal, idealKicks)).isLessThan(1.02);
  }

  /** By how much the error of a chip's dampingZ is at most larger than that of its fit alone. */
  private static double widest(Calibration c, CollectedKicks data) {
    KickFitter fitter = new KickFitter(FitSettings.defaults());
    FlatModel flat = data.published().flat().orElse(FlatModel.typical());
    ChipModel chip = data.published().chip().orElse(ChipModel.typical());
    double widest = 0;
    for (CalibratedKick kick : c.kicks(KickKind.CHIP)) {
      KickFit fit = kick.fit();
      if (fit.failure().isEmpty() && fit.estimate("dampingZ").usable()) {
        double roll = fit.estimate("accRoll").value();
        FitProblem problem =
            FitProblem.of(fit.kick(), c.cameras(), flat, chip).withChipRollFixed(roll);
        double alone = fitter.refit(problem, fit).estimate("dampingZ").standardError();
        widest = Math.max(widest, fit.estimate("dampingZ").standardError() / alone);
      }
    }
    return widest;
  }

  /** A fit that failed does not stand out, and yet is no better than one that does. */
  @Test
  void aFreeFitThatFailedDoesNotFreeTheRolling() {
    List<KickFit> fits = ideal.kicks(KickKind.CHIP).stream().map(CalibratedKick::fit).toList();
    KickFit free = fits.get(0);
    Kick kick = free.kick();
    Kick cut = kick.withObservations(kick.observations().between(0, kick.time() + 0.02));
    FlatModel flat = FlatModel.typical();
    ChipModel chip = ChipModel.typical();
    KickFitter fitter = new KickFitter(FitSettings.defaults());
    FitProblem problem = FitProblem.of(kick, ideal.cameras(), flat, chip);
    KickFit held = fitter.fit(problem.withChipRollFixed(-2), KickKind.CHIP);
    KickFit failed = fitter.fit(FitProblem.of(cut, ideal.cameras(), flat, chip), KickKind.CHIP);
    assertThat(failed.failure()).isPresent();
    assertThat(Selection.isBetterFree(held, free, fits)).isTrue();
    assertThat(Selection.isBetterFree(held, failed, fits)).isFalse();
  }

  @Test
  void jointFitOfErforceReachesWhatAnIndependentLeastSquaresReached() {
    JointFit joint = erforce.joint().orElseThrow();
    assertThat(joint.converged()).isTrue();
    assertThat(joint.rmsFlatMm()).isLessThanOrEqualTo(2.3);
    assertThat(joint.rmsChipMm()).isLessThanOrEqualTo(4.0);
    assertThat(joint.offsets()).containsOnlyKeys(0, 1);
    double apart = joint.offsets().get(1).x() - joint.offsets().get(0).x();
    assertThat(Math.abs(apart)).isEqualTo(0.040, within(0.0015));
    assertThat(joint.offsets().get(0).y()).isEqualTo(0, within(0.0015));
  }

  @ParameterizedTest
  @CsvSource({
    "flat, accSlide, acc_slide",
    "flat, accRoll, acc_roll",
    "flat, kSwitch, k_switch",
    "chip, dampingXyFirstHop, damping_xy_first_hop",
    "chip, dampingXyOtherHops, damping_xy_other_hops",
    "chip, dampingZ, damping_z"
  })
  void theTruthOfAnIdealWorldIsFound(String kind, String name, String inFile) throws IOException {
    double truth =
        new ObjectMapper()
            .readTree(DATA.resolve("world-null-" + kind + ".truth.json").toFile())
            .get("ideal_model")
            .get(inFile)
            .doubleValue();
    Average average = (kind.equals("flat") ? ideal.flat() : ideal.chip()).get(name);
    assertThat(average.n()).isGreaterThanOrEqualTo(12);
    assertThat(average.mean()).isEqualTo(truth, within(0.01 * Math.abs(truth)));
    assertThat(Math.abs(average.mean() - truth) / average.standardError())
        .as("%s", average)
        .isLessThan(3);
    JointFit joint = ideal.joint().orElseThrow();
    Estimate e = (kind.equals("flat") ? joint.flat(name) : joint.chip(name)).orElseThrow();
    assertThat(e.usable()).isTrue();
    assertThat(e.value()).isEqualTo(truth, within(0.01 * Math.abs(truth)));
    assertThat(Math.abs(e.value() - truth) / e.standardError()).as("%s", e).isLessThan(3);
    // The joint fit uses what partial kicks know, so it is not the worse one.
    assertThat(e.standardError()).isLessThan(1.5 * average.standardError());
  }

  /**
   * What this version finds, so that a change of the fit is a decision. The tolerances are some standard errors of the means; which
   * kicks the 2σ rule drops moves accSlide most. dampingXyFirstHop was 0.7127 before a number of flights against the 10 mm rule got its
   * price, and 0.7107 while the joint fit, whose offsets and accRoll these fits use, took all kicks for alike: the 2σ rule then kept 29 of them, later 22 that differ by half as much. dampingZ was 0.5692 while nothing covered bounces that differ; with it the 2σ rule keeps 21 instead of 24 kicks. The joint fit says 0.7123 ± 0.0003 and 0.5723 ± 0.0014.
   */
  @ParameterizedTest
  @CsvSource({
    "flat, accSlide, -3.922, 0.04",
    "flat, accRoll, -0.3520, 0.001",
    "flat, kSwitch, 0.6876, 0.001",
    "chip, dampingXyFirstHop, 0.7123, 0.001",
    "chip, dampingXyOtherHops, 1.0016, 0.001",
    "chip, dampingZ, 0.5699, 0.002"
  })
  void theNumbersOfErforceArePinned(String kind, String name, double mean, double tolerance) {
    Average average = (kind.equals("flat") ? erforce.flat() : erforce.chip()).get(name);
    assertThat(average.mean()).isEqualTo(mean, within(tolerance));
  }

  @Test
  void theModelsAreComplete() {
    assertThat(ideal.flatModel()).isPresent();
    assertThat(ideal.chipModel(-0.28)).isPresent();
    assertThat(ideal.chipModel(-0.28).orElseThrow().accRoll()).isEqualTo(-0.28);
    assertThat(ideal.joint().orElseThrow().reducedChiSquare()).isBetween(0.8, 1.25);
  }

  @Test
  void anIdealWorldHasNoOffsetsAndTheNoiseItWasMadeWith() {
    ideal
        .joint()
        .orElseThrow()
        .offsets()
        .forEach(
            (id, o) -> assertThat(Math.hypot(o.x(), o.y())).as("camera %d", id).isLessThan(0.001));
    ideal.cameras().all().forEach(v -> assertThat(v.noise()).isEqualTo(0.002, within(0.0003)));
  }

  private static List<Sample> samples(Calibration c, KickKind kind, String parameter) {
    return c.kicks(kind).stream()
        .flatMap(k -> k.samples().stream())
        .filter(s -> s.parameter().equals(parameter))
        .toList();
  }

  @Test
  void whatIsNotUsedSaysWhy() {
    for (Calibration c : List.of(erforce, ideal)) {
      int dropped = 0;
      for (CalibratedKick k : c.kicks()) {
        for (Sample s : k.samples()) {
          // Nothing that stays would leave in another round.
          if (s.dropped().isEmpty()) {
            Average mean = Average.of(samples(c, k.fit().kind(), s.parameter()));
            assertThat(mean.sigmas(s)).as(s.toString()).isLessThanOrEqualTo(2);
          }
        }
        k.rejected().ifPresent(r -> assertThat(r).isNotBlank());
        dropped += k.selected() ? 0 : 1;
      }
      assertThat(dropped).isLessThan(c.kicks().size() / 5);
    }
  }

  @Test
  void aKickDroppedByHandIsNotUsedAndOneKeptIs() {
    List<Kick> flats = flats(idealKicks);
    Epoch epoch = idealKicks.epoch();
    String dropped = HandSelection.key(epoch.unixSeconds(flats.get(3).time()));
    HandSelection byHand = HandSelection.none().drop(dropped, "somebody stepped on the ball");
    for (Kick k : flats) {
      if (k != flats.get(3)) {
        byHand = byHand.keep(HandSelection.key(epoch.unixSeconds(k.time())));
      }
    }
    Calibration c = calibrate(idealKicks, flats, byHand, Optional.of(KickKind.FLAT));
    for (CalibratedKick k : c.kicks()) {
      boolean expected = k.fit().kick().id() != flats.get(3).id();
      assertThat(k.selected()).as(k.fit().toString()).isEqualTo(expected);
      if (expected) {
        assertThat(k.samples()).allMatch(s -> s.dropped().isEmpty());
      } else {
        assertThat(k.rejected()).contains("by hand: somebody stepped on the ball");
        assertThat(k.samples()).allMatch(s -> s.dropped().isPresent());
      }
    }
    assertThat(c.joint().orElseThrow().used())
        .isLessThan(
            flats.stream().mapToInt(k -> k.observations().size()).sum()
                - flats.get(3).observations().size()
                + 1);
    assertThat(c.chip().values()).allMatch(a -> a.n() == 0);
    assertThat(c.chipModel(-0.28)).isEmpty();
  }

  @Test
  void fittedInParallelItIsTheSameEveryTime() {
    List<Kick> some = new ArrayList<>(flats(idealKicks).subList(0, 5));
    some.addAll(idealKicks.kicks().subList(24, 28));
    Calibration a = calibrate(idealKicks, some, HandSelection.none(), Optional.empty());
    Calibration b = calibrate(idealKicks, some, HandSelection.none(), Optional.empty());
    assertThat(b.flat()).isEqualTo(a.flat());
    assertThat(b.chip()).isEqualTo(a.chip());
    assertThat(b.joint()).isEqualTo(a.joint());
    assertThat(b.kicks().toString().replaceAll("@\\w+", ""))
        .isEqualTo(a.kicks().toString().replaceAll("@\\w+", ""));
  }

  @Test
  void withoutKicksTheCalibrationIsEmpty() {
    AtomicInteger told = new AtomicInteger();
    Calibration none =
        new Calibrator(FitSettings.defaults())
            .calibrate(
                new CalibrationProblem(
                    List.of(),
                    Epoch.atSecondOf(1e9),
                    CameraViews.of(List.of()),
                    FlatModel.typical(),
                    ChipModel.typical(),
                    Optional.empty(),
                    HandSelection.none()),
                k -> told.incrementAndGet());
    assertThat(none.kicks()).isEmpty();
    assertThat(none.joint()).isEmpty();
    assertThat(none.flatModel()).isEmpty();
    for (Map<String, Average> m : List.of(none.flat(), none.chip())) {
      assertThat(m).hasSize(3);
      assertThat(m.values()).allMatch(a -> a.n() == 0);
    }
    assertThat(told).hasValue(0);
  }

  @Test
  void everyKickIsReportedOnceAsProgress() {
    AtomicInteger told = new AtomicInteger();
    List<Kick> some = flats(idealKicks).subList(0, 3);
    new Calibrator(FitSettings.defaults())
        .calibrate(
            new CalibrationProblem(
                some,
                idealKicks.epoch(),
                idealKicks.cameras(),
                FlatModel.typical(),
                ChipModel.typical(),
                Optional.empty(),
                HandSelection.none()),
            k -> told.incrementAndGet());
    assertThat(told).hasValue(3);
  }

  /** A chip fitted as flat is three times worse than its fellows; the calibration of flats must not feel it. */
  @Test
  void aKickThatIsSomethingElseIsLeftOut() {
    List<Kick> mixed = new ArrayList<>(flats(idealKicks).subList(0, 8));
    mixed.add(idealKicks.kicks().get(30));
    Calibration c = calibrate(idealKicks, mixed, HandSelection.none(), Optional.of(KickKind.FLAT));
    CalibratedKick stranger = c.kicks().get(8);
    assertThat(stranger.selected()).isFalse();
    assertThat(stranger.rejected().orElseThrow()).containsAnyOf("the others", "do not fit");
    assertThat(stranger.trusted()).isFalse();
    assertThat(c.trusted()).hasSize(8).doesNotContain(stranger.fit());
    assertThat(c.joint().orElseThrow().flat("accSlide").orElseThrow().value())
        .isEqualTo(-3.1, within(0.05));
  }

  /** That a kick departs from the average is no reason to distrust it. */
  @Test
  void aKickWhoseParametersAllLeftIsStillTrusted() {
    Calibration c =
        calibrate(idealKicks, flats(idealKicks), HandSelection.none(), Optional.of(KickKind.FLAT));
    CalibratedKick kick = c.kicks().get(0);
    List<Sample> left =
        kick.samples().stream().map(s -> s.drop(s.parameter() + " is 3 sigma off")).toList();
    CalibratedKick departed = new CalibratedKick(kick.fit(), left, Optional.empty());
    assertThat(departed.selected()).isFalse();
    assertThat(departed.rejected().orElseThrow()).contains("3 sigma off");
    assertThat(departed.trusted()).isTrue();
    CalibratedKick mute = new CalibratedKick(kick.fit(), List.of(), Optional.empty());
    assertThat(mute.rejected()).contains("determines no parameter");
    assertThat(mute.trusted()).isTrue();
    Sample ofNoMean = new Sample(kick.fit().kick().id(), "dampingZ", 0.5, 0.01, Optional.empty());
    CalibratedKick other = new CalibratedKick(kick.fit(), List.of(ofNoMean), Optional.empty());
    assertThat(other.selected()).as("its value is in no mean of its kind").isFalse();
    // The joint fit was made from the same.
    int observations = c.trusted().stream().mapToInt(f -> f.kick().observations().size()).sum();
    assertThat(c.joint().orElseThrow().used() + c.joint().orElseThrow().rejected())
        .isEqualTo(observations);
  }
}
