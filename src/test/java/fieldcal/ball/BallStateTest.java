package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class BallStateTest {
  @Test
  void groundSpeedIgnoresHeight() {
    assertThat(new BallState(0, 0, 1, 3, -4, 12).groundSpeed()).isEqualTo(5.0);
  }
}
