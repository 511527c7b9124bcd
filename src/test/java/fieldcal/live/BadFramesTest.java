package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.movement.PlayPhase;
import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Frames as no camera should send them, between good ones: nothing throws, and the good ones still count. */
class BadFramesTest {
  private static final double[] ODD = {
    Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300, -1e300, 0, -0.0, 1e-300
  };

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void nothingThrows(long seed) {
    Random random = new Random(seed);
    SimulatedMatch match = SimulatedMatch.play(8, 0.5, -0.28);
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withLimitsInterval(5),
            match.recording().epoch(),
            LiveListener.NONE,
            Runnable::run);
    monitor.geometry(match.recording().geometry());
    int good = 0;
    for (VisionFrame frame : match.recording().frames()) {
      if (random.nextInt(20) == 0) {
        monitor.accept(spoiled(frame, random));
      }
      if (random.nextInt(500) == 0) {
        monitor.phase(PlayPhase.values()[random.nextInt(PlayPhase.values().length)]);
      }
      monitor.accept(frame);
      good++;
    }
    monitor.phase(PlayPhase.RUNNING);
    monitor.finish();
    LiveSnapshot last = monitor.snapshot();
    assertThat(last.frames()).as("seed %d", seed).isGreaterThan((long) (0.95 * good));
    assertThat(last.ball().counts().found()).as("seed %d", seed).isPositive();
    assertThat(last.cameras().size()).isLessThan(20);
  }

  private static VisionFrame spoiled(VisionFrame f, Random random) {
    List<BallDetection> balls = new ArrayList<>(f.balls());
    balls.replaceAll(
        b ->
            new BallDetection(
                odd(b.x(), random),
                odd(b.y(), random),
                b.z(),
                b.confidence(),
                b.area(),
                odd(b.pixelX(), random),
                b.pixelY()));
    List<RobotDetection> robots = new ArrayList<>(f.robots());
    robots.replaceAll(
        r ->
            new RobotDetection(
                r.id(),
                odd(r.x(), random),
                odd(r.y(), random),
                odd(r.orientation(), random),
                r.confidence(),
                r.height()));
    double time = random.nextBoolean() ? f.captureTime() : odd(f.captureTime(), random);
    int camera = random.nextInt(3) == 0 ? random.nextInt(8) : f.cameraId();
    return new VisionFrame(camera, -1, time, time, time, balls, robots);
  }

  private static double odd(double value, Random random) {
    return random.nextInt(3) == 0 ? ODD[random.nextInt(ODD.length)] : value;
  }
}
