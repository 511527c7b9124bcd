package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.cli.Main;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.measurement.BallHeightError;
import fieldcal.effect.measurement.CameraMoved;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.measurement.CameraTimeOffset;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.KickSpin;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitSettings;
import fieldcal.fit.JointFit;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Simulated recordings with a known effect: with it taken out, the simple parameters are those of the simulation. */
class ExtendedCalibratorTest {
  private static final Calibrator CALIBRATOR = new Calibrator(FitSettings.defaults());

  @TempDir private Path folder;

  private CollectedKicks simulated(String... options) throws IOException {
    Path log = folder.resolve("simulated.log.gz");
    List<String> args = new ArrayList<>(List.of("simulate", "--seed=11", "--out=" + log));
    args.addAll(Arrays.asList(options));
    CommandLine quiet = Main.commandLine().setOut(new PrintWriter(Writer.nullWriter()));
    assertThat(quiet.execute(args.toArray(String[]::new))).isZero();
    return new KickCollector((file, read, total) -> {}).collect(List.of(log));
  }

  private static CalibrationProblem problem(CollectedKicks data) {
    return new CalibrationProblem(
        data.kicks(),
        data.epoch(),
        data.cameras(),
        FlatModel.typical(),
        ChipModel.typical(),
        Optional.empty(),
        HandSelection.none());
  }

  private static ExtendedCalibration calibrated(CollectedKicks data, Effect... effects) {
    ExtendedModel model =
        new ExtendedModel(
            Optional.of(FlatModel.typical()),
            Optional.of(ChipModel.typical()),
            List.of(effects),
            data.sessionStart());
    return new ExtendedCalibrator(FitSettings.defaults(), model, data.observers())
        .calibrate(problem(data), kick -> {});
  }

  private static void assertTrue(Map<String, Average> averages, String name, double truth) {
    Average a = averages.get(name);
    assertThat(a.mean()).as(name).isCloseTo(truth, within(3 * a.standardError()));
  }

  private static void assertTrue(Optional<Estimate> joint, double truth) {
    Estimate e = joint.orElseThrow();
    assertThat(e.value()).as(e.name()).isCloseTo(truth, within(3 * e.standardError()));
  }

  @Test
  void airDragSpoilsTheSlidingUnlessItIsInTheModel() throws IOException {
    CollectedKicks data =
        simulated(
            "--scenario=flat", "--kicks=20", "--physics=contact", "--effect=air_drag:cd=0.45");
    // A solid sphere on a carpet with friction 0.3: the simulation's own numbers.
    double accSlide = -0.3 * 9.81;
    double kSwitch = 1 / 1.4;

    JointFit simple = CALIBRATOR.calibrate(problem(data), kick -> {}).joint().orElseThrow();
    Estimate biased = simple.flat("accSlide").orElseThrow();
    // Drag makes kicks of different speeds differ, which the error covers.
    assertThat(Math.abs(biased.value() - accSlide)).isLessThan(2 * biased.standardError());

    ExtendedCalibration extended = calibrated(data, new AirDrag(0.45));
    Calibration c = extended.calibration();
    assertTrue(c.flat(), "accSlide", accSlide);
    assertTrue(c.flat(), "accRoll", -0.28);
    assertTrue(c.flat(), "kSwitch", kSwitch);
    assertTrue(c.joint().flatMap(j -> j.flat("accSlide")), accSlide);
    assertTrue(c.joint().flatMap(j -> j.flat("accRoll")), -0.28);
    assertTrue(c.joint().flatMap(j -> j.flat("kSwitch")), kSwitch);
    Estimate right = c.joint().flatMap(j -> j.flat("accSlide")).orElseThrow();
    assertThat(biased.standardError()).isGreaterThan(3 * right.standardError());
    assertThat(c.joint().orElseThrow().reducedChiSquare()).isBetween(0.9, 1.15);
    assertThat(extended.settled()).isTrue();
    assertThat(extended.rounds()).isBetween(2, 4);
  }

  /** A ball with backspin slides longer: plain repetition of the correction diverges here. */
  @Test
  void backspinIsTakenOut() throws IOException {
    CollectedKicks data =
        simulated(
            "--scenario=flat",
            "--kicks=16",
            "--physics=contact",
            "--effect=kick_spin:fraction=-0.35");
    ExtendedCalibration extended = calibrated(data, new KickSpin(-0.35));
    Calibration c = extended.calibration();
    assertTrue(c.flat(), "accSlide", -0.3 * 9.81);
    assertTrue(c.flat(), "accRoll", -0.28);
    assertTrue(c.flat(), "kSwitch", 1 / 1.4);
    assertTrue(c.joint().flatMap(j -> j.flat("kSwitch")), 1 / 1.4);
    assertThat(extended.lastMoveMm()).isLessThan(0.2);
  }

  @Test
  void whatCamerasDoIsTakenOutToo() throws IOException {
    CollectedKicks data =
        simulated(
            "--scenario=mixed",
            "--kicks=20",
            "--flat-model=-3.1,-0.28,0.65",
            "--chip-model=0.75,0.95,0.52",
            "--effect=camera_offset:x_mm=20,y_mm=-10,camera=1",
            "--effect=camera_time_offset:ms=4,camera=2",
            "--effect=ball_height_error:mm=8");
    Calibration c =
        calibrated(
                data,
                new CameraOffset(20, -10, 1),
                new CameraTimeOffset(4, 2),
                new BallHeightError(8))
            .calibration();
    assertTrue(c.flat(), "accSlide", -3.1);
    assertTrue(c.flat(), "accRoll", -0.28);
    assertTrue(c.flat(), "kSwitch", 0.65);
    assertTrue(c.chip(), "dampingXyFirstHop", 0.75);
    assertTrue(c.chip(), "dampingXyOtherHops", 0.95);
    assertTrue(c.chip(), "dampingZ", 0.52);
    // The cameras agree: there is nothing left for their offsets to take out.
    assertThat(c.joint().orElseThrow().offsets().values())
        .allSatisfy(o -> assertThat(Math.hypot(o.x(), o.y())).isLessThan(4e-4));
  }

  @Test
  void aKnockedCameraIsCorrectedFromThenOnOnly() throws IOException {
    CollectedKicks data =
        simulated(
            "--scenario=flat",
            "--kicks=12",
            "--flat-model=-3.1,-0.28,0.65",
            "--effect=camera_moved:x_mm=25,y_mm=-15,at=40,camera=1");
    Calibration c = calibrated(data, new CameraMoved(25, -15, 40, 1)).calibration();
    assertTrue(c.flat(), "accRoll", -0.28);
    assertThat(c.joint().orElseThrow().offsets().values())
        .allSatisfy(o -> assertThat(Math.hypot(o.x(), o.y())).isLessThan(4e-4));
  }

  @Test
  void withoutEffectsNothingChanges() throws IOException {
    CollectedKicks data = simulated("--scenario=mixed", "--kicks=6");
    Calibration simple = CALIBRATOR.calibrate(problem(data), kick -> {});
    ExtendedCalibration extended = calibrated(data);
    assertThat(extended.rounds()).isEqualTo(1);
    assertThat(extended.lastMoveMm()).isLessThan(0.05);
    for (String name : List.of("accSlide", "accRoll", "kSwitch")) {
      Average a = simple.flat().get(name);
      assertThat(extended.calibration().flat().get(name).mean())
          .isCloseTo(a.mean(), within(0.2 * a.standardError()));
    }
  }

  @Test
  void withoutKicksItIsEmpty() throws IOException {
    CollectedKicks data = simulated("--scenario=flat", "--kicks=1");
    CalibrationProblem none = problem(data).withKicks(List.of());
    ExtendedModel model =
        new ExtendedModel(
            Optional.of(FlatModel.typical()), Optional.empty(), List.of(new AirDrag(0.4)), 0);
    ExtendedCalibration extended =
        new ExtendedCalibrator(FitSettings.defaults(), model, data.observers())
            .calibrate(none, kick -> {});
    assertThat(extended.calibration().kicks()).isEmpty();
    assertThat(extended.settled()).isTrue();
  }
}
