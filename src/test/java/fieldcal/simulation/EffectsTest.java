package fieldcal.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.SimulationTest.Residual;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.truth.CameraTruth;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.KickTruth.Vector3;
import fieldcal.vision.VisionFrame;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Every effect does what its name says, in the right direction, and nothing at zero. */
class EffectsTest {
  private static final SimulationSettings FLAT =
      SimulationSettings.DEFAULT
          .withScenario(ScenarioSettings.of(ScenarioKind.FLAT, 2).withReception(0))
          .withCameras(CameraSettings.DEFAULT.withNoise(0, 0))
          .withNuisance(Nuisance.NONE)
          .withSeed(11);

  private static final SimulationSettings CHIP =
      FLAT.withScenario(ScenarioSettings.of(ScenarioKind.CHIP, 2).withReception(0));

  private static final SimulationSettings NOISY =
      SimulationSettings.DEFAULT.withScenario(ScenarioKind.MIXED, 2);

  private static final SimulatedRecording WITHOUT = Simulation.record(NOISY);

  @ParameterizedTest
  @EnumSource(SimulatedEffect.class)
  void zeroIsAbsentToTheLastBit(SimulatedEffect effect) {
    EffectSetting zero = EffectSetting.of(effect, effect.parameters().get(0).name(), 0);
    for (EffectParameter parameter : effect.parameters()) {
      switch (parameter.kind()) {
        case REGION -> zero = zero.with(parameter.name(), "[0,6,-4.5,4.5]");
        case CAMERA -> zero = zero.with(parameter.name(), 1);
        default -> {
          // Without a value it concerns every team and robot.
        }
      }
    }
    SimulatedRecording with = Simulation.record(NOISY.withEffects(List.of(zero)));
    assertThat(with.packets()).isEqualTo(WITHOUT.packets());
    assertThat(with.truth().kicks()).isEqualTo(WITHOUT.truth().kicks());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "air_drag:cd=0.5",
        "kick_spin:fraction=-0.4",
        "speed_dependent_roll:slope=0.05",
        "worn_region:change=0.5,region=[-6,6,-4.5,4.5]",
        "drift:percent_per_10min=300"
      })
  void brakingEffectsShortenFlatKicks(String effect) {
    assertThat(length(FLAT.withEffects(effect))).isLessThan(length(FLAT) - 0.02);
    String opposite = effect.contains("-0.4") ? effect.replace("-0.4", "0.4") : null;
    if (opposite != null) {
      assertThat(length(FLAT.withEffects(opposite))).isGreaterThan(length(FLAT) + 0.02);
    }
  }

  @Test
  void aSlopeTurnsThePathDownhill() {
    double plain = deviation(FLAT, Math.PI / 2);
    assertThat(deviation(FLAT.withEffects("field_slope:percent=0.5,direction=1.5708"), Math.PI / 2))
        .isGreaterThan(plain + 0.05);
    assertThat(
            deviation(FLAT.withEffects("field_slope:percent=0.5,direction=-1.5708"), Math.PI / 2))
        .isLessThan(plain - 0.05);
  }

  @Test
  void napBrakesMoreInItsDirection() {
    KickTruth first = Simulation.record(FLAT).truth().kicks().get(0);
    double direction = first.velocity().direction();
    double with = length(FLAT.withEffects("carpet_nap:amplitude=0.2,direction=" + direction));
    double against = length(FLAT.withEffects("carpet_nap:amplitude=-0.2,direction=" + direction));
    assertThat(with).isLessThan(length(FLAT) - 0.02);
    assertThat(against).isGreaterThan(length(FLAT) + 0.02);
  }

  @Test
  void sideSpinPushesToTheRight() {
    KickTruth plain = Simulation.record(FLAT).truth().kicks().get(0);
    KickTruth spun =
        Simulation.record(FLAT.withEffects("side_spin:fraction=0.3")).truth().kicks().get(0);
    assertThat(spun.sideFraction(0.0215)).isEqualTo(0.3, within(1e-9));
    assertThat(spun.velocity()).isEqualTo(plain.velocity());
    int i = 100;
    double left =
        -Math.sin(plain.velocity().direction()) * (spun.path().get(i).x() - plain.path().get(i).x())
            + Math.cos(plain.velocity().direction())
                * (spun.path().get(i).y() - plain.path().get(i).y());
    assertThat(left).isLessThan(-0.02);
  }

  @Test
  void spinScattersFromKickToKick() {
    List<KickTruth> kicks =
        Simulation.record(
                FLAT.withScenario(ScenarioKind.FLAT, 12)
                    .withEffects("kick_spin:fraction=-0.3,scatter=0.1"))
            .truth()
            .commandedKicks();
    double[] fractions = kicks.stream().mapToDouble(k -> k.rollFraction(0.0215)).toArray();
    double mean = IntStream.range(0, 12).mapToDouble(i -> fractions[i]).average().orElseThrow();
    assertThat(mean).isBetween(-0.4, -0.2);
    assertThat(java.util.Arrays.stream(fractions).map(f -> Math.abs(f - mean)).max().orElse(0))
        .isBetween(0.05, 0.4);
  }

  @Test
  void chipsMaySpinOtherwiseThanFlatKicks() {
    String effect = "kick_spin:fraction=0.1,chips=-0.4";
    KickTruth flat = Simulation.record(FLAT.withEffects(effect)).truth().kicks().get(0);
    KickTruth chip = Simulation.record(CHIP.withEffects(effect)).truth().kicks().get(0);
    assertThat(flat.rollFraction(0.0215)).isEqualTo(0.1, within(1e-9));
    assertThat(chip.rollFraction(0.0215)).isEqualTo(-0.3, within(1e-9));
  }

  @Test
  void backspinWithMagnusFliesFarther() {
    SimulationSettings spun = CHIP.withEffects("kick_spin:fraction=-0.5");
    SimulationSettings lifted = CHIP.withEffects("kick_spin:fraction=-0.5", "magnus:cl=0.5");
    assertThat(firstImpact(lifted)).isGreaterThan(firstImpact(spun) + 5e-3);
    assertThat(firstImpact(spun)).isEqualTo(firstImpact(CHIP), within(1e-9));
  }

  @Test
  void fastImpactsLoseMoreWithSpeedDependentRestitution() {
    KickTruth plain = Simulation.record(CHIP).truth().kicks().get(0);
    KickTruth slope =
        Simulation.record(CHIP.withEffects("speed_dependent_restitution:slope=0.05"))
            .truth()
            .kicks()
            .get(0);
    double impact = -plain.events().get(0).vzBefore();
    assertThat(slope.events().get(0).vzAfter())
        .isEqualTo(0.52 * (1 - 0.05 * (impact - 1.5)) * impact, within(1e-9));
  }

  @Test
  void spinCouplingSlowsTheSecondHop() {
    // The first impact makes the ball spin forwards, so the second one sees the coupling.
    KickTruth plain = Simulation.record(CHIP).truth().kicks().get(0);
    KickTruth coupled =
        Simulation.record(CHIP.withEffects("bounce_spin_coupling:coefficient=0.2"))
            .truth()
            .kicks()
            .get(0);
    assertThat(coupled.events().get(0).vyAfter()).isEqualTo(plain.events().get(0).vyAfter());
    assertThat(Math.abs(coupled.events().get(1).vyAfter()))
        .isLessThan(Math.abs(plain.events().get(1).vyAfter()) - 0.05);
  }

  @Test
  void aBiasedRobotKicksFasterAndToTheLeft() {
    SimulatedRecording plain = Simulation.record(FLAT);
    KickTruth kick = plain.truth().kicks().get(0);
    String robot =
        "robot_kick_bias:percent=10,yaw=0.05,team="
            + kick.robot().team().label()
            + ",robot="
            + kick.robot().number();
    List<KickTruth> biased = Simulation.record(FLAT.withEffects(robot)).truth().kicks();
    assertThat(biased.get(0).velocity().norm() / kick.velocity().norm())
        .isEqualTo(1.1, within(1e-9));
    assertThat(biased.get(0).velocity().direction() - kick.velocity().direction())
        .isEqualTo(0.05, within(1e-9));
    assertThat(biased.get(0).command()).isEqualTo(kick.command());
    assertThat(biased.get(1).velocity().norm() / biased.get(1).command().speed())
        .isEqualTo(1, within(0.06));
  }

  @Test
  void anOffsetIsRelativeToTheMeanOfAllCameras() {
    SimulatedRecording recording =
        Simulation.record(FLAT.withEffects("camera_offset:x_mm=21,y_mm=-6,camera=1"));
    double sum = 0;
    for (CameraTruth camera : recording.truth().cameras()) {
      sum += camera.errors().offsetX();
    }
    assertThat(sum).isEqualTo(0, within(1e-12));
    for (Residual r : SimulationTest.residuals(recording)) {
      assertThat(r.dx()).isEqualTo(r.camera() == 1 ? 0.021 : -0.007, within(3e-5));
      assertThat(r.dy()).isEqualTo(r.camera() == 1 ? -0.006 : 0.002, within(3e-5));
    }
  }

  @Test
  void aLateCameraReportsWhereTheBallWas() {
    List<VisionFrame> plain = framesOf(FLAT, 1);
    List<VisionFrame> late = framesOf(FLAT.withEffects("camera_time_offset:ms=4,camera=1"), 1);
    for (int i = 0; i < plain.size(); i += 50) {
      assertThat(late.get(i).captureTime() - plain.get(i).captureTime())
          .isEqualTo(0.004, within(1e-9));
      assertThat(late.get(i).balls()).isEqualTo(plain.get(i).balls());
      assertThat(late.get(i).sentTime()).isEqualTo(plain.get(i).sentTime());
    }
    assertThat(framesOf(FLAT.withEffects("camera_time_offset:ms=4,camera=1"), 0))
        .isEqualTo(framesOf(FLAT, 0));
  }

  @Test
  void aFastClockGains() {
    List<VisionFrame> plain = framesOf(FLAT, 2);
    List<VisionFrame> fast = framesOf(FLAT.withEffects("clock_skew:ppm=500,camera=2"), 2);
    int last = plain.size() - 1;
    double gained = fast.get(last).captureTime() - plain.get(last).captureTime();
    assertThat(gained).isEqualTo(500e-6 * plain.get(last).captureTime(), within(1e-6));
  }

  @Test
  void aPublishedCameraThatHangsTooHighMagnifies() {
    SimulatedRecording recording =
        Simulation.record(FLAT.withEffects("camera_pose_error:height_mm=50,camera=all"));
    CameraTruth camera = recording.truth().cameras().get(0);
    assertThat(
            camera.publishedCalibration().derivedWorldZ()
                - camera.trueCalibration().derivedWorldZ())
        .isEqualTo(0.05, within(1e-6));
    double outwards =
        SimulationTest.residuals(recording).stream()
            .mapToDouble(r -> Math.hypot(r.dx(), r.dy()))
            .max()
            .orElseThrow();
    // 50 mm of 5.3 m, at up to 3.5 m from the nadir.
    assertThat(outwards).isBetween(0.01, 0.05);
  }

  @Test
  void aTiltedCalibrationMovesTheGround() {
    SimulatedRecording recording =
        Simulation.record(FLAT.withEffects("camera_pose_error:tilt_mrad=3,axis=0,camera=all"));
    // The published camera turns about +x by a positive angle: it looks further to +y.
    ToDoubleFunction<Residual> dy = Residual::dy;
    assertThat(SimulationTest.residuals(recording).stream().mapToDouble(dy).min().orElseThrow())
        .isGreaterThan(0.003 * 5);
  }

  @Test
  void aShiftedCalibrationShiftsAll() {
    SimulatedRecording recording =
        Simulation.record(
            FLAT.withEffects("camera_pose_error:shift_x_mm=12,shift_y_mm=-8,camera=all"));
    for (Residual r : SimulationTest.residuals(recording)) {
      assertThat(r.dx()).isEqualTo(0.012, within(3e-5));
      assertThat(r.dy()).isEqualTo(-0.008, within(3e-5));
    }
  }

  @Test
  void tooHighABallPlanePullsTowardsTheCamera() {
    SimulatedRecording recording = Simulation.record(FLAT.withEffects("ball_height_error:mm=8.5"));
    assertThat(recording.truth().ballPlane()).isEqualTo(0.03, within(1e-12));
    double largest =
        SimulationTest.residuals(recording).stream()
            .mapToDouble(r -> Math.hypot(r.dx(), r.dy()))
            .max()
            .orElseThrow();
    assertThat(largest).isBetween(0.003, 0.0085);
  }

  @Test
  void aPublishedLensErrorGrowsWithTheCube() {
    SimulatedRecording recording =
        Simulation.record(FLAT.withEffects("lens_distortion_error:delta=0.01,camera=all"));
    double largest =
        SimulationTest.residuals(recording).stream()
            .mapToDouble(r -> Math.hypot(r.dx(), r.dy()))
            .max()
            .orElseThrow();
    assertThat(largest).isBetween(0.005, 0.05);
  }

  @Test
  void aRollingShutterSeesMovingBallsLater() {
    SimulatedRecording recording = Simulation.record(FLAT.withEffects("rolling_shutter:ms=10"));
    KickTruth kick =
        recording.truth().kicks().stream()
            .max(Comparator.comparingDouble(k -> k.velocity().norm()))
            .orElseThrow();
    double direction = kick.velocity().direction();
    List<Residual> residuals = SimulationTest.residuals(recording);
    double ahead =
        residuals.stream()
            .mapToDouble(r -> r.dx() * Math.cos(direction) + r.dy() * Math.sin(direction))
            .max()
            .orElseThrow();
    assertThat(ahead).isBetween(0.01, 0.07);
  }

  @Test
  void causesOutsideTheCatalogueActToo() {
    assertThat(SimulatedEffect.CAMERA_SHAKE.catalogued()).isFalse();
    assertThat(SimulatedEffect.AIR_DRAG.catalogued()).isTrue();
    assertThat(length(FLAT.withEffects("slip_dependent_friction:slope=0.2")))
        .isNotCloseTo(length(FLAT), within(5e-3));
    assertThat(SimulatedEffect.WIND.catalogued()).isTrue();
    assertThat(length(FLAT.withEffects("carpet_waves:amplitude=0.5,wavelength=3")))
        .isNotEqualTo(length(FLAT));
    double swing =
        SimulationTest.residuals(
                Simulation.record(FLAT.withEffects("camera_shake:amplitude_mm=10,camera=all")))
            .stream()
            .mapToDouble(r -> Math.abs(r.dx()))
            .max()
            .orElseThrow();
    assertThat(swing).isEqualTo(0.010, within(3e-4));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "unnamed_roll_square:slope=0.03",
        "unnamed_roll_bump:height=1",
        "unnamed_fading_friction:change=0.5",
        "unnamed_ring:change=2,inner=0,outer=9",
        "unnamed_once_per_turn:amplitude=3",
        "unnamed_side_force:rate=0.2",
        "unnamed_patches:change=5",
        "ball_changed:roll=0.5,slide=0.2,at=0",
      })
  void flatKicksFeelCausesWithoutAName(String effect) {
    assertThat(length(FLAT.withEffects(effect))).isLessThan(length(FLAT) - 0.005);
    assertThat(EffectSetting.parse(effect)).hasToString(effect);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "unnamed_restitution_place:change=0.2,direction=1.57",
        "unnamed_impact_speed:slope=0.05",
        "contact_impacts:reversed=-0.1,friction=0.35",
        "kick_spin:fraction=-0.3",
        "side_spin:fraction=0.3",
        "field_slope:percent=1",
        "wind:speed=3+air_drag:cd=0.45"
      })
  void chipsFeelThem(String effect) {
    KickTruth plain = Simulation.record(CHIP).truth().kicks().get(0);
    KickTruth changed =
        Simulation.record(CHIP.withEffects(effect.split("[+]"))).truth().kicks().get(0);
    assertThat(changed.velocity()).isEqualTo(plain.velocity());
    Vector3 a = plain.path().get(150);
    Vector3 b = changed.path().get(150);
    assertThat(Math.hypot(a.x() - b.x(), a.y() - b.y())).isGreaterThan(5e-3);
  }

  @Test
  void windDoesNothingWithoutDrag() {
    assertThat(Simulation.record(CHIP.withEffects("wind:speed=3")).packets())
        .isEqualTo(Simulation.record(CHIP).packets());
  }

  @Test
  void aKnockedCameraReportsAllShiftedFromThenOn() {
    SimulatedRecording plain = Simulation.record(FLAT);
    double half = 0.5 * plain.truth().duration();
    SimulatedRecording moved =
        Simulation.record(FLAT.withEffects("camera_moved:x_mm=9,y_mm=-4,camera=1,at=" + half));
    List<VisionFrame> before = frames(plain, 1);
    List<VisionFrame> after = frames(moved, 1);
    int shifted = 0;
    for (int i = 0; i < before.size(); i++) {
      boolean late = before.get(i).captureTime() > half + 0.01;
      if (before.get(i).balls().isEmpty() || Math.abs(before.get(i).captureTime() - half) < 0.01) {
        continue;
      }
      double dx = after.get(i).balls().get(0).x() - before.get(i).balls().get(0).x();
      double dy = after.get(i).balls().get(0).y() - before.get(i).balls().get(0).y();
      assertThat(dx).isEqualTo(late ? 0.009 : 0, within(3e-5));
      assertThat(dy).isEqualTo(late ? -0.004 : 0, within(3e-5));
      shifted += late ? 1 : 0;
    }
    assertThat(shifted).isGreaterThan(20);
    assertThat(frames(moved, 0)).isEqualTo(frames(plain, 0));
  }

  @Test
  void aLensErrorWithoutCameraIsThatOfAll() {
    assertThat(framesOf(FLAT.withEffects("lens_distortion_error:delta=0.01"), 3))
        .isEqualTo(framesOf(FLAT.withEffects("lens_distortion_error:delta=0.01,camera=all"), 3));
  }

  @Test
  void aShearOfTheLensShiftsAlongXOnly() {
    SimulatedRecording recording =
        Simulation.record(FLAT.withEffects("unnamed_lens_shear:mm=100,camera=all"));
    List<Residual> residuals = SimulationTest.residuals(recording);
    assertThat(residuals.stream().mapToDouble(r -> Math.abs(r.dx())).max().orElseThrow())
        .isBetween(2e-3, 0.05);
    assertThat(residuals.stream().mapToDouble(r -> Math.abs(r.dy())).max().orElseThrow())
        .isLessThan(3e-5);
  }

  @Test
  void robotEffectsChangeTheLimits() {
    SimulatedRecording recording =
        Simulation.record(
            FLAT.withEffects(
                "torque_limited:coefficient=0.5,team=yellow", "directional:coefficient=0.3"));
    recording
        .truth()
        .robots()
        .forEach(
            r -> {
              assertThat(r.limits().torqueLoss())
                  .isEqualTo(r.id().team().label().equals("yellow") ? 0.5 : 0);
              assertThat(r.limits().directionality()).isEqualTo(0.3);
            });
  }

  @Test
  void settingsPrintAsTheyAreRead() {
    String text = "worn_region:change=0.2,region=[0,6,-4.5,4.5]";
    assertThat(EffectSetting.parse(text)).hasToString(text);
    assertThat(EffectSetting.parse("air_drag:0.45").number("cd")).isEqualTo(0.45);
    assertThat(EffectSetting.parse("worn_region:change=0.2,region=0/6/-4.5/4.5").region())
        .isEqualTo(EffectSetting.parse(text).region());
    assertThatThrownBy(() -> EffectSetting.parse("air_drag:cd=1,cd=2"))
        .hasMessageContaining("given twice");
  }

  private static List<VisionFrame> framesOf(SimulationSettings settings, int camera) {
    return frames(Simulation.record(settings), camera);
  }

  private static List<VisionFrame> frames(SimulatedRecording recording, int camera) {
    return recording.frames().stream().filter(f -> f.cameraId() == camera).toList();
  }

  /** How far the first kick's ball gets in its first four seconds, or until it ends. */
  private static double length(SimulationSettings settings) {
    KickTruth kick = Simulation.record(settings).truth().kicks().get(0);
    Vector3 to = kick.path().get(Math.min(400, kick.path().size() - 1));
    return Math.hypot(to.x() - kick.position().x(), to.y() - kick.position().y());
  }

  private static double deviation(SimulationSettings settings, double direction) {
    KickTruth kick = Simulation.record(settings).truth().kicks().get(0);
    Vector3 to = kick.path().get(200);
    return Math.cos(direction) * (to.x() - kick.position().x())
        + Math.sin(direction) * (to.y() - kick.position().y());
  }

  private static double firstImpact(SimulationSettings settings) {
    return Simulation.record(settings).truth().kicks().get(0).events().get(0).time()
        - Simulation.record(settings).truth().kicks().get(0).time();
  }
}
