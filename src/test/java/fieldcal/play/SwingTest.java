package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SwingTest {
  private final Swing swing = new Swing();

  /** As a robot did that a foreign simulator's vision showed 0.5 s late: both ways by 80°, every 2.3 s. */
  @Test
  void whoTurnsPastItsTargetAgainAndAgainSwings() {
    for (int i = 0; i < 1000; i++) {
      swing.look(1.4 * Math.cos(2 * Math.PI * i / 230));
    }
    assertThat(swing.swings()).isTrue();
  }

  @Test
  void whoComesFromAnotherDirectionAndSettlesDoesNot() {
    for (int i = 0; i < 1000; i++) {
      swing.look(3 * Math.exp(-0.006 * i) * Math.cos(2 * Math.PI * i / 230));
    }
    assertThat(swing.swings()).isFalse();
  }
}
