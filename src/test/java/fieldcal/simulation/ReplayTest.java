package fieldcal.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.vision.BallDetection;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

/** Kicks that are made again start where and when they did, and obey the field's laws. */
class ReplayTest {
  private static final SimulationSettings CLEAN =
      SimulationSettings.DEFAULT
          .withNuisance(Nuisance.NONE)
          .withCameras(CameraSettings.DEFAULT.withCount(1).withNoise(0, 0));

  private static ReplayedKick kick(double rest, double time, double vx, double end, boolean held) {
    return new ReplayedKick(
        rest, time, -2, 1, vx, 0, 0, end, held, Double.MAX_VALUE, OptionalDouble.of(0));
  }

  private static List<VisionFrame> frames(List<ReplayedKick> kicks, Replay.Span... spans) {
    List<VisionFrame> frames = new ArrayList<>();
    new Replay(CLEAN, kicks, List.of(), List.of(spans))
        .run(packet -> packet.packet().frame().ifPresent(frames::add), share -> {});
    return frames;
  }

  private static double xAt(List<VisionFrame> frames, double time) {
    VisionFrame frame =
        frames.stream().filter(f -> f.captureTime() >= time).findFirst().orElseThrow();
    BallDetection ball = frame.balls().get(0);
    return ball.x();
  }

  @Test
  void theBallWaitsIsKickedAndIsHeld() {
    List<VisionFrame> frames = frames(List.of(kick(1, 2, 3, 3, true)), new Replay.Span(0, 5));
    assertThat(frames.stream().filter(f -> f.captureTime() < 1))
        .isNotEmpty()
        .allMatch(f -> f.balls().isEmpty());
    assertThat(xAt(frames, 1.5)).isCloseTo(-2, within(1e-3));
    VisionFrame later =
        frames.stream().filter(f -> f.captureTime() >= 2.5).findFirst().orElseThrow();
    double t = later.captureTime() - 2;
    double slideEnd = (1 - 0.65) * 3 / 3.1;
    double speed = 3 * 0.65;
    double rolled = t - slideEnd;
    double expected =
        3 * slideEnd - 1.55 * slideEnd * slideEnd + speed * rolled - 0.14 * rolled * rolled;
    assertThat(later.balls().get(0).x() + 2).isCloseTo(expected, within(2e-3));
    assertThat(xAt(frames, 4.5)).isCloseTo(xAt(frames, 3.05), within(1e-3));
  }

  @Test
  void aKickIsCutShortByTheNextOneAndSpansAreAllThatIsRecorded() {
    List<ReplayedKick> kicks = List.of(kick(0.5, 1, 3, 9, false), kick(2, 2.5, 1, 9, false));
    List<VisionFrame> frames = frames(kicks, new Replay.Span(0, 1.5), new Replay.Span(2, 3));
    assertThat(frames).noneMatch(f -> f.captureTime() > 1.5 && f.captureTime() < 1.95);
    assertThat(xAt(frames, 2.2)).isCloseTo(-2, within(1e-3));
  }

  @Test
  void timesMustBeInOrder() {
    assertThatIllegalArgumentException().isThrownBy(() -> kick(3, 2, 1, 4, false));
    assertThatIllegalArgumentException().isThrownBy(() -> kick(1, 2, 1, 1.5, false));
    assertThatIllegalArgumentException().isThrownBy(() -> kick(1, 2, Double.NaN, 4, false));
    assertThatIllegalArgumentException().isThrownBy(() -> new Replay.Span(2, 1));
  }
}
