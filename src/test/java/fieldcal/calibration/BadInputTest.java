package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.camera.ChangedCalibration;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitSettings;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderSettings;
import fieldcal.live.CameraHealth;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.BallDetection;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Recordings that are bad but not impossible: an answer, or a reason for each kick, never an exception. */
class BadInputTest {
  private static final long SEED = 20261122;

  private static SimulatedRecording mixed;
  private static double soundRoll;

  @BeforeAll
  static void simulate() {
    mixed =
        Simulation.record(
            SimulationSettings.DEFAULT.withSeed(SEED).withScenario(ScenarioKind.MIXED, 8));
    soundRoll = accRoll(calibrate(mixed, UnaryOperator.identity()));
  }

  private static VisionFrame with(VisionFrame f, List<BallDetection> balls) {
    return new VisionFrame(
        f.cameraId(),
        f.frameNumber(),
        f.captureTime(),
        f.sentTime(),
        f.cameraClockTime(),
        balls,
        f.robots());
  }

  private static UnaryOperator<VisionFrame> rounded(double step) {
    return f ->
        with(
            f,
            f.balls().stream()
                .map(
                    b ->
                        new BallDetection(
                            Math.round(b.x() / step) * step,
                            Math.round(b.y() / step) * step,
                            b.z(),
                            b.confidence(),
                            b.area(),
                            b.pixelX(),
                            b.pixelY()))
                .toList());
  }

  private static UnaryOperator<VisionFrame> without(Predicate<VisionFrame> blind) {
    return f -> blind.test(f) ? with(f, List.of()) : f;
  }

  private static List<Kick> kicks(
      SimulatedRecording recording, FieldGeometry geometry, UnaryOperator<VisionFrame> change) {
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder =
        new KickFinder(KickFinderSettings.defaults(), k -> kicks.add(k.withId(kicks.size() + 1)));
    Map<Integer, Camera> cameras = new HashMap<>();
    views(geometry).all().forEach(v -> v.camera().ifPresent(camera -> cameras.put(v.id(), camera)));
    finder.geometry(geometry, cameras);
    recording.frames().forEach(f -> finder.accept(change.apply(f)));
    finder.finish();
    return kicks;
  }

  private static CameraViews views(FieldGeometry geometry) {
    return CameraViews.of(
        geometry.cameras().stream()
            .map(c -> CameraView.of(c.id(), Optional.of(Camera.of(c))))
            .toList());
  }

  private static Calibration calibrate(
      SimulatedRecording recording, FieldGeometry geometry, List<Kick> kicks) {
    Calibration c =
        new Calibrator(FitSettings.defaults())
            .calibrate(
                new CalibrationProblem(
                    kicks,
                    recording.epoch(),
                    views(geometry),
                    FlatModel.typical(),
                    ChipModel.typical(),
                    Optional.empty(),
                    HandSelection.none()),
                kick -> {});
    assertThat(c.kicks()).hasSameSizeAs(kicks);
    for (CalibratedKick k : c.kicks()) {
      assertThat(k.selected() || !k.rejected().orElseThrow().isBlank()).isTrue();
      k.fit().failure().ifPresent(f -> assertThat(f).doesNotContain("broke off"));
    }
    return c;
  }

  private static Calibration calibrate(
      SimulatedRecording recording, UnaryOperator<VisionFrame> change) {
    FieldGeometry geometry = recording.geometry();
    return calibrate(recording, geometry, kicks(recording, geometry, change));
  }

  private static double accRoll(Calibration c) {
    return c.flat().get("accRoll").mean();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.001, 0.01, 0.03, 0.1})
  void coordinatesOnAGrid(double step) {
    Calibration c = calibrate(mixed, rounded(step));
    // A grid of 50 mm and more is too coarse for a promise.
    if (step < 0.05) {
      assertThat(accRoll(c)).isEqualTo(soundRoll, within(0.02 * Math.abs(soundRoll)));
    }
    c.cameras()
        .all()
        .forEach(v -> assertThat(v.noise()).isGreaterThan(0.99 * step / Math.sqrt(12)));
  }

  /** Its steps look like kicks; none of them may count. */
  @Test
  void coordinatesOnAGridThatIsTooCoarse() {
    assertThat(calibrate(mixed, rounded(0.2)).kicks()).noneMatch(CalibratedKick::selected);
  }

  @Test
  void aCameraThatSeesNoRestingBall() {
    List<Kick> all = kicks(mixed, mixed.geometry(), UnaryOperator.identity());
    Predicate<VisionFrame> blind =
        f ->
            f.cameraId() == 0
                && all.stream()
                    .anyMatch(
                        k -> f.captureTime() < k.time() + 0.1 && f.captureTime() > k.time() - 5);
    Calibration c = calibrate(mixed, without(blind));
    assertThat(c.cameras().all()).allMatch(v -> v.noise() > 0);
  }

  @Test
  void noCameraSeesARestingBall() {
    List<Kick> all = kicks(mixed, mixed.geometry(), UnaryOperator.identity());
    Predicate<VisionFrame> blind =
        f -> all.stream().anyMatch(k -> Math.abs(f.captureTime() - k.time() + 2) < 2.05);
    calibrate(mixed, without(blind));
  }

  @Test
  void oneKickOnly() {
    List<Kick> all = kicks(mixed, mixed.geometry(), UnaryOperator.identity());
    for (Kick kick : all) {
      calibrate(mixed, mixed.geometry(), List.of(kick));
    }
    calibrate(mixed, mixed.geometry(), List.of());
  }

  @Test
  void oneSpeedOnly() {
    for (ScenarioKind kind : List.of(ScenarioKind.FLAT, ScenarioKind.CHIP)) {
      SimulatedRecording same =
          Simulation.record(
              SimulationSettings.DEFAULT
                  .withSeed(SEED)
                  .withScenario(ScenarioSettings.of(kind, 5).withSpeeds(4, 4.001)));
      Calibration c = calibrate(same, UnaryOperator.identity());
      assertThat(c.kicks()).anyMatch(CalibratedKick::selected);
    }
  }

  private static FieldGeometry withFirstCamera(UnaryOperator<CameraCalibration> change) {
    List<CameraCalibration> cameras = new ArrayList<>(mixed.geometry().cameras());
    cameras.set(0, change.apply(cameras.get(0)));
    return mixed.geometry().withCameras(cameras);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.3, -0.5, -1, -3, -10})
  void aLensThatCannotBe(double distortion) {
    requireAnswers(
        withFirstCamera(c -> ChangedCalibration.withDistortion(c, distortion)),
        "does not see the places");
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e38, -1e38, 1e6, 200})
  void aCameraThatHangsInSpace(double x) {
    requireAnswers(
        withFirstCamera(c -> ChangedCalibration.withWorldX(c, x)), "is too far from the field");
  }

  private static void requireAnswers(FieldGeometry geometry, String fault) {
    Calibration c = calibrate(mixed, geometry, kicks(mixed, geometry, UnaryOperator.identity()));
    double sound = accRoll(calibrate(mixed, UnaryOperator.identity()));
    assertThat(accRoll(c)).isEqualTo(sound, within(0.02 * Math.abs(sound)));

    LiveMonitor monitor =
        new LiveMonitor(LiveSettings.defaults(), mixed.epoch(), LiveListener.NONE, Runnable::run);
    monitor.geometry(geometry);
    mixed.frames().forEach(monitor::accept);
    monitor.finish();
    assertThat(monitor.snapshot().listenerFailures()).isZero();
    assertThat(monitor.snapshot().ball().counts().dropped()).isZero();
    assertThat(monitor.snapshot().ball().counts().used()).isPositive();
    assertThat(monitor.snapshot().cameras()).isNotEmpty().allMatch(CameraHealth::calibrated);
    assertThat(monitor.snapshot().cameraFaults())
        .singleElement()
        .satisfies(
            f -> {
              assertThat(f.camera()).isEqualTo(geometry.cameras().get(0).id());
              assertThat(f.reason()).contains(fault);
            });
  }
}
