package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Late and silent are not the same. */
class VisionDelayTest {
  private static final double TICK = 0.01;

  private final VisionDelay vision = new VisionDelay();

  @Test
  void beforeAnyFrameItIsSilent() {
    assertThat(vision.silent()).isInfinite();
    vision.update(1, Double.NEGATIVE_INFINITY, TICK);
    vision.update(1, Double.NaN, TICK);
    assertThat(vision.silent()).isInfinite();
    assertThat(vision.delay()).isZero();
  }

  @Test
  void lateFramesAreNoSilence() {
    for (int i = 0; i < 200; i++) {
      double time = i * TICK;
      // A frame every third tick.
      vision.update(time, (i - i % 3) * TICK - 0.2, TICK);
      assertThat(vision.silent()).isLessThan(0.021);
    }
    assertThat(vision.delay()).isCloseTo(0.2, within(1e-9));
    for (int i = 0; i < 50; i++) {
      vision.update(2 + i * TICK, 1.78, TICK);
    }
    assertThat(vision.silent()).isCloseTo(0.5, within(0.03));
    assertThat(vision.delay()).isCloseTo(0.2, within(0.01));
  }
}
