package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.effect.measurement.BallHeightError;
import fieldcal.effect.measurement.CameraMoved;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.measurement.CameraPositionError;
import fieldcal.effect.measurement.CameraTimeOffset;
import fieldcal.effect.measurement.ClockSkew;
import fieldcal.effect.measurement.LensDistortionError;
import fieldcal.effect.measurement.RollingShutter;
import java.util.List;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;

/** The contract for every effect on what cameras report, and what they do where something of a camera is not known. */
class MeasurementEffectsTest {
  private static final ChipTrajectory PATH =
      ChipTrajectory.fromKick(ChipModel.typical(), 100, -1, -0.5, 2, 1, 3);

  /** Two cameras that look straight down from 5 m. */
  private static List<ObservedCamera> cameras() {
    return List.of(camera(0, -2), camera(1, 2));
  }

  static ObservedCamera camera(int id, double x) {
    // Turned by 180° about x: t = −R·C with C = (x, 0, 5).
    CameraCalibration c =
        new CameraCalibration(id, 1800, 1224, 1024, 0.1, 1, 0, 0, 0, -x, 0, 5, x, 0, 5, 2448, 2048);
    return ObservedCamera.of(c, Camera.of(c), 2);
  }

  abstract static class ReportsOfEffect extends EffectContract {
    private final Effect effect;

    ReportsOfEffect(Effect effect) {
      this.effect = effect;
    }

    @Override
    Effect effect() {
      return effect;
    }

    @Override
    double[] predict(Effect with) {
      List<MeasurementEffect> list = with == null ? List.of() : List.of((MeasurementEffect) with);
      MeasurementEffects effects = MeasurementEffects.of(cameras(), list);
      double[] result = new double[160];
      double[] ball = new double[3];
      double[] ground = new double[2];
      for (int i = 0; i < 80; i++) {
        int id = i % 2;
        double stamp = 100.05 + 0.0203 * i;
        PATH.positionAt(effects.ballTime(id, stamp, 10 + 20 * i, Double.NaN), ball);
        effects.report(id, stamp, ball, ground);
        result[2 * i] = ground[0];
        result[2 * i + 1] = ground[1];
      }
      return result;
    }

    @Test
    void reportsAllSightingsAtOnceAsOneByOne() {
      ExtendedTrajectory path = chip(2);
      double[] atOnce = new double[160];
      MeasurementEffects effects =
          MeasurementEffects.of(cameras(), List.of((MeasurementEffect) effect));
      Sightings seen = sightings();
      effects.report(seen, path, 0, atOnce);
      double last = Double.NEGATIVE_INFINITY;
      for (int i = 0; i < 80; i++) {
        last =
            Math.max(
                last,
                effects.ballTime(seen.camera[i], seen.stamp[i], seen.pixelRow[i], Double.NaN));
      }
      assertThat(effects.lastBallTime(seen, 0)).isEqualTo(last);
      assertThat(atOnce).containsExactly(predict(effect), within(1e-9));

      MeasurementEffects none = MeasurementEffects.of(cameras(), List.of());
      MeasurementEffects under = none.under(List.of((MeasurementEffect) effect));
      double[] beside = new double[160];
      new Reports(none, seen, path, 0).under(under, beside);
      assertThat(beside).containsExactly(atOnce);
      assertThat(under.under(List.of((MeasurementEffect) effect))).isSameAs(under);
    }

    @Test
    void pathsCloseByAreReportedToFirstOrder() {
      MeasurementEffects effects =
          MeasurementEffects.of(cameras(), List.of((MeasurementEffect) effect));
      Sightings seen = sightings();
      double[] plain = new double[160];
      double[] moved = new double[160];
      double[] firstOrder = new double[160];
      Reports reports = new Reports(effects, seen, chip(2), 0);
      reports.copyTo(plain);
      effects.report(seen, chip(2.0001), 0, moved);
      reports.near(chip(2.0001), firstOrder);
      for (int i = 0; i < 160; i++) {
        double change = Math.max(1e-5, Math.abs(moved[i] - plain[i]));
        assertThat(firstOrder[i]).isCloseTo(moved[i], within(2e-4 * change));
      }
    }

    /** Two cameras in turn, at times and in rows that all effects ask for. */
    private static Sightings sightings() {
      int[] cameras = new int[80];
      double[] stamps = new double[80];
      double[] rows = new double[80];
      for (int i = 0; i < 80; i++) {
        cameras[i] = i % 2;
        stamps[i] = 100.05 + 0.0203 * i;
        rows[i] = 10 + 20 * i;
      }
      return new Sightings(cameras, stamps, rows);
    }

    private static ExtendedTrajectory chip(double vx) {
      return ExtendedTrajectory.chip(
          ChipModel.typical(),
          FlatModel.typical(),
          MotionEffects.of(List.of()),
          0,
          100,
          -1,
          -0.5,
          vx,
          1,
          3);
    }
  }

  @Nested
  class CameraOffsetTest extends ReportsOfEffect {
    CameraOffsetTest() {
      super(new CameraOffset(20, -10, 1));
    }
  }

  @Nested
  class CameraTimeOffsetTest extends ReportsOfEffect {
    CameraTimeOffsetTest() {
      super(new CameraTimeOffset(4, 1));
    }
  }

  @Nested
  class CameraPoseErrorTest extends ReportsOfEffect {
    CameraPoseErrorTest() {
      super(new CameraPoseError(3, 1, 50, 10, -20, 1));
    }
  }

  @Nested
  class CameraPositionErrorTest extends ReportsOfEffect {
    CameraPositionErrorTest() {
      super(new CameraPositionError(80, -60, 100, 1));
    }
  }

  @Nested
  class LensDistortionErrorTest extends ReportsOfEffect {
    LensDistortionErrorTest() {
      super(new LensDistortionError(0.01, 1));
    }
  }

  @Nested
  class LensDistortionErrorOfAllTest extends ReportsOfEffect {
    LensDistortionErrorOfAllTest() {
      super(new LensDistortionError(0.01, LensDistortionError.ALL_CAMERAS));
    }
  }

  @Nested
  class CameraMovedTest extends ReportsOfEffect {
    CameraMovedTest() {
      super(new CameraMoved(12, -7, 100.8, 1));
    }
  }

  @Nested
  class BallHeightErrorTest extends ReportsOfEffect {
    BallHeightErrorTest() {
      super(new BallHeightError(8.5));
    }
  }

  @Nested
  class ClockSkewTest extends ReportsOfEffect {
    ClockSkewTest() {
      super(new ClockSkew(100, 1));
    }
  }

  @Nested
  class RollingShutterTest extends ReportsOfEffect {
    RollingShutterTest() {
      super(new RollingShutter(8));
    }
  }

  @Test
  void whatIsNotKnownIsNotApplied() {
    Camera hanging = Camera.ofPosition(1, 2, 0, 5);
    ObservedCamera position =
        new ObservedCamera(
            1,
            2,
            java.util.Optional.of(hanging),
            Double.NaN,
            Double.NaN,
            Double.NaN,
            Double.NaN,
            0);
    ObservedCamera nothing = ObservedCamera.unknown(1, 2);
    assertThat(new LensDistortionError(0.01, 1).isApplicable(position)).isFalse();
    assertThat(new RollingShutter(5).isApplicable(position)).isFalse();
    assertThat(new CameraPoseError(1, 0, 0, 0, 0, 1).isApplicable(position)).isTrue();
    assertThat(new CameraPoseError(1, 0, 0, 0, 0, 1).isApplicable(nothing)).isFalse();
    assertThat(new BallHeightError(5).isApplicable(nothing)).isFalse();
    double[] ground = new double[2];
    MeasurementEffects.of(
            List.of(nothing), List.of(new BallHeightError(5), new CameraOffset(10, 0, 1)))
        .report(1, new double[] {1, 2, 0.5}, ground);
    assertThat(ground).containsExactly(1.01, 2);
  }

  @Test
  void everyEffectOfTheTableIsInTheCatalogue() {
    assertThat(EffectCatalogue.all().stream().map(Effect::id))
        .doesNotHaveDuplicates()
        .containsExactlyInAnyOrderElementsOf(EffectContract.ids());
    assertThat(EffectCatalogue.motion()).hasSize(16);
    assertThat(EffectCatalogue.measurement()).hasSize(9);
  }

  @Test
  void aKnockedCameraReportsShiftedFromThenOn() {
    MeasurementEffects effects =
        MeasurementEffects.of(cameras(), List.of(new CameraMoved(12, -7, 100, 1)));
    double[] ball = {1, 2, 0};
    double[] ground = new double[2];
    effects.report(1, 99.9, ball, ground);
    assertThat(ground).containsExactly(new double[] {1, 2}, within(1e-12));
    effects.report(0, 100, ball, ground);
    assertThat(ground).containsExactly(new double[] {1, 2}, within(1e-12));
    effects.report(1, 100, ball, ground);
    assertThat(ground).containsExactly(new double[] {1.012, 1.993}, within(1e-12));
    effects.report(1, ball, ground);
    assertThat(ground).containsExactly(new double[] {1.012, 1.993}, within(1e-12));
  }

  @Test
  void aDistortionOfAllCamerasIsOneOfEach() {
    MeasurementEffects all =
        MeasurementEffects.of(cameras(), List.of(new LensDistortionError(0.01, -1)));
    MeasurementEffects each =
        MeasurementEffects.of(
            cameras(), List.of(new LensDistortionError(0.01, 0), new LensDistortionError(0.01, 1)));
    double[] a = new double[2];
    double[] b = new double[2];
    for (int id = 0; id < 2; id++) {
      all.report(id, new double[] {1, 2, 0}, a);
      each.report(id, new double[] {1, 2, 0}, b);
      assertThat(a).isEqualTo(b).isNotEqualTo(new double[] {1, 2});
    }
  }

  @Test
  void refusesSightingsOfDifferentLengths() {
    assertThatThrownBy(() -> new Sightings(new int[2], new double[2], new double[3]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("2 cameras, 2 stamps, 3 rows");
  }
}
