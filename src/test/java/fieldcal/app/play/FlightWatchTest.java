package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.List;
import org.junit.jupiter.api.Test;

/** When a ball that nobody sees flies out of the images. */
class FlightWatchTest {
  private final FlightWatch watch = new FlightWatch();

  private void frames(double from, double to, List<BallDetection> balls, double robotX) {
    for (double t = from; t < to; t += 0.01) {
      List<RobotDetection> robots =
          List.of(new RobotDetection(new RobotId(Team.YELLOW, 1), robotX, 0, 0, 1, Double.NaN));
      watch.accept(new VisionFrame(0, 1, t, t, Double.NaN, balls, robots));
    }
  }

  private static List<BallDetection> ball(double x) {
    return List.of(new BallDetection(x, 0, Double.NaN, 1, 0, 0, 0));
  }

  @Test
  void aBallThatNoCameraSeesAlthoughNoRobotHidesItIsOut() {
    frames(0, 1, ball(0), 3);
    frames(1, 1.4, List.of(), 3);
    frames(1.4, 2, ball(2), 3);
    FlightWatch.Gap gap = watch.between(0.5, 1.5).orElseThrow();
    assertThat(gap.from()).isCloseTo(0.99, within(0.011));
    assertThat(gap.to()).isCloseTo(1.39, within(0.021));
    assertThat(watch.between(1.2, 3)).isEmpty();
  }

  @Test
  void aBallThatDoesNotComeBackIsOut() {
    frames(0, 1, ball(0), 3);
    frames(1, 1.4, List.of(), 3);
    assertThat(watch.between(0.5, 1.5)).isPresent();
  }

  @Test
  void aBallBesideARobotMayBeHidden() {
    frames(0, 1, ball(0), 0.2);
    frames(1, 1.4, List.of(), 0.2);
    frames(1.4, 2, ball(0), 3);
    assertThat(watch.between(0.5, 1.5)).isEmpty();
  }

  @Test
  void aSilentVisionSeesNothing() {
    frames(0, 1, ball(0), 3);
    frames(1.5, 2, List.of(), 3);
    frames(2, 3, ball(2), 3);
    assertThat(watch.between(0, 3)).isEmpty();
  }

  @Test
  void twoLostFramesAreNothing() {
    frames(0, 1, ball(0), 3);
    frames(1, 1.03, List.of(), 3);
    frames(1.03, 2, ball(0), 3);
    assertThat(watch.between(0, 3)).isEmpty();
  }
}
