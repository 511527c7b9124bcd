package fieldcal.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.truth.EndReason;
import fieldcal.simulation.truth.KickKind;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whole recordings: determinism, the robots' doings, and what the cameras make of the truth. */
class SimulationTest {
  private static final SimulationSettings FLAT =
      SimulationSettings.DEFAULT.withScenario(ScenarioKind.FLAT, 4).withSeed(7);

  @Test
  void theSameSeedGivesTheSameBytes() {
    assertThat(bytes(FLAT)).isEqualTo(bytes(FLAT));
    assertThat(Simulation.record(FLAT).truth()).isEqualTo(Simulation.record(FLAT).truth());
  }

  @Test
  void anotherSeedGivesAnotherRecording() {
    assertThat(bytes(FLAT)).isNotEqualTo(bytes(FLAT.withSeed(8)));
  }

  @Test
  void framesInMemoryAreThoseOfTheWire() {
    SimulatedRecording recording = Simulation.record(FLAT);
    VisionEncoder encoder = new VisionEncoder(recording.epoch());
    VisionDecoder decoder = new VisionDecoder(recording.epoch());
    for (SimulatedPacket sent : recording.packets()) {
      VisionPacket read = decoder.decode(encoder.encode(sent.packet()));
      if (sent.packet().frame().isPresent()) {
        VisionFrame a = sent.packet().frame().get();
        VisionFrame b = read.frame().orElseThrow();
        assertThat(b.balls()).isEqualTo(a.balls());
        assertThat(b.robots()).isEqualTo(a.robots());
        // Unix time as a double is good to a quarter of a microsecond.
        assertThat(b.captureTime()).isEqualTo(a.captureTime(), within(5e-7));
      } else {
        assertThat(read.geometry().orElseThrow().cameras())
            .isEqualTo(recording.geometry().cameras());
      }
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = ScenarioKind.class,
      names = {"FLAT", "CHIP", "MIXED"})
  void allKicksAreMadeAsCommanded(ScenarioKind kind) {
    SimulatedRecording recording =
        Simulation.record(SimulationSettings.DEFAULT.withScenario(kind, 6).withSeed(3));
    List<KickTruth> kicks = recording.truth().commandedKicks();
    assertThat(kicks).hasSize(6);
    assertThat(kicks.stream().filter(k -> k.kind() == KickKind.CHIP).count())
        .isEqualTo(
            switch (kind) {
              case CHIP -> 6;
              case MIXED -> 3;
              default -> 0;
            });
    for (KickTruth kick : kicks) {
      assertThat(kick.velocity().norm()).isEqualTo(kick.command().speed(), within(0.4));
      assertThat(
              Math.IEEEremainder(
                  kick.velocity().direction() - kick.command().direction(), 2 * Math.PI))
          .isEqualTo(0, within(0.03));
      double ahead =
          Math.hypot(
              kick.position().x() - kick.robotPose().x(),
              kick.position().y() - kick.robotPose().y());
      assertThat(ahead).isBetween(0.09, 0.11);
      assertThat(kick.end()).isIn(EndReason.STOPPED, EndReason.LEFT_FIELD, EndReason.TOUCHED_ROBOT);
      assertThat(kick.path()).hasSizeGreaterThan((int) (kick.duration() / 0.01) - 1);
      assertThat(kick.duration()).isGreaterThan(0.5);
    }
  }

  @Test
  void theBallRestsInViewBeforeEveryKick() {
    SimulatedRecording recording = Simulation.record(FLAT.withScenario(ScenarioKind.MIXED, 8));
    for (KickTruth kick : recording.truth().commandedKicks()) {
      List<BallDetection> resting =
          recording.frames().stream()
              .filter(f -> f.captureTime() > kick.time() - 0.5 && f.captureTime() < kick.time())
              .flatMap(f -> f.balls().stream())
              .filter(
                  b -> Math.hypot(b.x() - kick.position().x(), b.y() - kick.position().y()) < 0.02)
              .toList();
      assertThat(resting).as("kick at %s", kick.time()).hasSizeGreaterThan(25);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 4, 6, 8})
  void goodCamerasReportTheTruth(int cameras) {
    SimulatedRecording recording =
        Simulation.record(
            FLAT.withCameras(CameraSettings.DEFAULT.withNoise(0, 0).withCount(cameras))
                .withNuisance(Nuisance.NONE));
    Map<Integer, Integer> seen = new HashMap<>();
    for (Residual r : residuals(recording)) {
      // 32-bit calibration and pixels leave micrometres.
      assertThat(Math.hypot(r.dx(), r.dy())).isLessThan(2e-5);
      seen.merge(r.camera(), 1, Integer::sum);
    }
    assertThat(seen.values().stream().mapToInt(Integer::intValue).sum()).isGreaterThan(700);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.1, 0, 0.15})
  void everyPlaceOfTheFieldIsSeen(double distortion) {
    SimulatedRecording recording =
        Simulation.record(
            FLAT.withCameras(CameraSettings.DEFAULT.withNoise(0, 0).withDistortion(distortion))
                .withNuisance(Nuisance.NONE));
    for (KickTruth kick : recording.truth().kicks()) {
      double from = kick.time();
      double to = kick.time() + kick.duration();
      long frames =
          recording.frames().stream()
              .filter(f -> f.captureTime() > from && f.captureTime() < to)
              .filter(f -> !f.balls().isEmpty())
              .count();
      assertThat(frames).isGreaterThan((long) (65 * (to - from)));
    }
  }

  @Test
  void noiseIsAsLargeAsAsked() {
    SimulatedRecording recording =
        Simulation.record(
            FLAT.withCameras(CameraSettings.DEFAULT.withNoise(0.002, 0.003))
                .withNuisance(Nuisance.NONE));
    double sum = 0;
    int n = 0;
    for (Residual r : residuals(recording)) {
      sum += r.dx() * r.dx() + r.dy() * r.dy();
      n += 2;
    }
    // Away from the nadir a pixel covers more ground: 0 to 25 % more here.
    assertThat(Math.sqrt(sum / n)).isBetween(0.002, 0.0025);
  }

  @Test
  void nuisanceLosesFramesAndAddsFalseBalls() {
    SimulatedRecording clean = Simulation.record(FLAT.withNuisance(Nuisance.NONE));
    Nuisance bad =
        new Nuisance(0.05, 0.001, 0.1, 0.05, 0.1, 0.2, 1e-3, 1e-4, 0.02, true, List.of());
    SimulatedRecording dirty = Simulation.record(FLAT.withNuisance(bad));
    assertThat(dirty.frames().size()).isLessThan((int) (0.95 * clean.frames().size()));
    assertThat(clean.frames().stream().mapToInt(f -> f.balls().size()).max().orElse(0))
        .isEqualTo(1);
    assertThat(dirty.frames().stream().mapToInt(f -> f.balls().size()).max().orElse(0))
        .isGreaterThan(1);
    long distinct =
        dirty.frames().stream()
            .map(f -> f.cameraId() * 1_000_000L + f.frameNumber())
            .distinct()
            .count();
    assertThat(distinct).isLessThan(dirty.frames().size());
  }

  @Test
  void anOutageSilencesOneCamera() {
    SimulatedRecording recording =
        Simulation.record(
            FLAT.withNuisance(Nuisance.NONE.withOutages(List.of(new Nuisance.Outage(2, 3, 5)))));
    for (int camera = 0; camera < 4; camera++) {
      int id = camera;
      long during =
          recording.frames().stream()
              .filter(f -> f.cameraId() == id && f.captureTime() > 3.1 && f.captureTime() < 7.9)
              .count();
      assertThat(during).isBetween(id == 2 ? 0L : 300L, id == 2 ? 0L : 400L);
    }
  }

  private static String bytes(SimulationSettings settings) {
    SimulatedRecording recording = Simulation.record(settings);
    VisionEncoder encoder = new VisionEncoder(recording.epoch());
    MessageDigest digest;
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
    recording.packets().forEach(p -> digest.update(encoder.encode(p.packet())));
    return HexFormat.of().formatHex(digest.digest());
  }

  record Residual(int camera, double dx, double dy) {}

  /** Detections minus the truth while a flat kick is under way; the truth linear between its points of 10 ms. */
  static List<Residual> residuals(SimulatedRecording recording) {
    List<Residual> result = new ArrayList<>();
    for (KickTruth kick : recording.truth().kicks()) {
      for (VisionFrame frame : recording.frames()) {
        double t = (frame.captureTime() - kick.time()) / kick.pathStep();
        int i = (int) Math.floor(t);
        if (t < 0 || i + 1 >= kick.path().size() - 1) {
          continue;
        }
        for (BallDetection b : frame.balls()) {
          double s = t - i;
          var from = kick.path().get(i);
          var to = kick.path().get(i + 1);
          double dx = b.x() - from.x() - s * (to.x() - from.x());
          double dy = b.y() - from.y() - s * (to.y() - from.y());
          // The chord lies beside the arc by up to a·h²/8 = 0.04 mm while the ball slides: skip
          // that part.
          boolean rolls = i * kick.pathStep() > 1;
          if (rolls && Math.hypot(dx, dy) < 0.1) {
            result.add(new Residual(frame.cameraId(), dx, dy));
          }
        }
      }
    }
    return result;
  }
}
