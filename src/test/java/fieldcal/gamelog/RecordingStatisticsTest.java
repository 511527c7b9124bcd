package fieldcal.gamelog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecordingStatisticsTest {
  private static final Path DATA =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  private final RecordingStatistics statistics = new RecordingStatistics();
  private final SplittableRandom random = new SplittableRandom(11);

  @Test
  void tellsRateJitterLossAndGaps() {
    int number = 0;
    for (int i = 0; i < 4000; i++) {
      number += 2; // both cameras count with one counter
      if (i % 50 == 7) {
        continue;
      }
      double time = i / 73.0 + (i >= 2000 ? 5 : 0) + 0.0004 * random.nextGaussian();
      statistics.onFrame(frame(1, number, time, List.of()), time + 0.012);
    }

    CameraStatistics camera = statistics.cameras().get(0);
    assertThat(camera.id()).isEqualTo(1);
    assertThat(camera.frames()).isEqualTo(3920);
    assertThat(camera.rate()).isCloseTo(73, within(0.05));
    assertThat(camera.jitter()).isCloseTo(0.0004, within(0.00003));
    assertThat(camera.lostFrames()).isEqualTo(80);
    assertThat(camera.loss()).isCloseTo(0.02, within(1e-9));
    assertThat(camera.gaps()).isEqualTo(1);
    assertThat(camera.longestGap()).isCloseTo(5.014, within(0.002));
    assertThat(camera.latency()).isCloseTo(0.012, within(0.0002));
  }

  @Test
  void measuresTheNoiseOfRestingBallsOnly() {
    double noise = 0.0015;
    for (int i = 0; i < 30_000; i++) {
      double time = i / 73.0;
      // Rests for four seconds of six, rolls in between; a false ball flickers.
      double phase = time % 6;
      double x = phase < 4 ? 1 : 1 + (phase - 4);
      List<BallDetection> balls = new ArrayList<>();
      if (random.nextInt(20) > 0) {
        balls.add(ball(x + noise * random.nextGaussian(), 2 + noise * random.nextGaussian()));
      }
      if (random.nextInt(30) == 0) {
        balls.add(ball(random.nextDouble(-4, 4), 0));
      }
      statistics.onFrame(frame(0, i, time, balls), time);
    }

    CameraStatistics camera = statistics.cameras().get(0);
    assertThat(camera.restingBlocks()).isGreaterThan(300);
    assertThat(camera.ballNoise()).isCloseTo(noise, within(0.03 * noise));
  }

  @Test
  void aBallThatNeverRestsTellsNoNoise() {
    for (int i = 0; i < 3000; i++) {
      double x = 0.3 * i / 73.0 % 6;
      statistics.onFrame(
          frame(0, i, i / 73.0, List.of(ball(x + 0.001 * random.nextGaussian(), 0))), i / 73.0);
    }

    assertThat(statistics.cameras().get(0).restingBlocks()).isZero();
    assertThat(statistics.cameras().get(0).ballNoise()).isNaN();
  }

  @Test
  void nothingSeenIsNothingTold() {
    assertThat(statistics.cameras()).isEmpty();
    assertThat(statistics.referee()).isEmpty();
  }

  /** Expected: the recordings' own descriptions (test-data/README.md) and, for the worlds, the truth files. */
  @ParameterizedTest
  @CsvSource({
    "erforce-flat.log.gz, 2, 66.7, 22998, 0.0003, 0.004",
    "erforce-chip.log.gz, 2, 66.7, 19400, 0.0003, 0.004",
    "world-null-flat.log.gz, 4, 73, 43073, 0.0015, 0.0026",
    "world-null-chip.log.gz, 4, 73, 37466, 0.0015, 0.0026"
  })
  void readsTheRecordings(
      String name, int cameras, double rate, long messages, double minNoise, double maxNoise)
      throws IOException {
    try (RecordingReader recording = RecordingReader.open(DATA.resolve(name))) {
      RecordingSummary summary = recording.read(statistics);

      assertThat(summary.messages()).containsEntry(MessageType.SSL_VISION_2014, messages);
      assertThat(summary.geometry().orElseThrow().cameras()).hasSize(cameras);
      assertThat(summary.problems().count(LogProblem.DUPLICATE_FRAME)).isZero();
      assertThat(summary.problems().count(LogProblem.GARBAGE)).isZero();
      assertThat(statistics.cameras())
          .hasSize(cameras)
          .allSatisfy(
              camera -> {
                assertThat(camera.rate()).isCloseTo(rate, within(3.0));
                assertThat(camera.ballNoise()).isBetween(minNoise, maxNoise);
              });
    }
  }

  private static BallDetection ball(double x, double y) {
    return new BallDetection(x, y, Double.NaN, 1, 90, 100, 100);
  }

  private static VisionFrame frame(int camera, int number, double time, List<BallDetection> balls) {
    return new VisionFrame(camera, number, time, time + 0.005, Double.NaN, balls, List.of());
  }
}
