package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class ParameterTest {
  private static final Parameter ACC_ROLL =
      new Parameter("accRoll", "m/s²", -0.28, 0.1, -2, -0.02, true, "a test");

  @Test
  void changesByCopy() {
    assertThat(ACC_ROLL.withValue(-0.5).value()).isEqualTo(-0.5);
    assertThat(ACC_ROLL.withValue(-0.5).withValue(-0.28)).isEqualTo(ACC_ROLL);
    assertThat(ACC_ROLL.fixed().estimated()).isFalse();
    assertThat(ACC_ROLL.fixed().free()).isEqualTo(ACC_ROLL);
    assertThat(ACC_ROLL.withBounds(-1, 0).max()).isZero();
  }

  @Test
  void boundsLimitAnEstimateNotAPublishedValue() {
    Parameter published = ACC_ROLL.withValue(-3);
    assertThat(published.isWithinBounds()).isFalse();
    assertThat(published.clamp(published.value())).isEqualTo(-2);
    assertThat(published.clamp(0)).isEqualTo(-0.02);
    assertThat(published.clamp(-1)).isEqualTo(-1);
    assertThat(ACC_ROLL.withValue(-2).isWithinBounds()).isTrue();
    assertThatThrownBy(() -> published.clamp(Double.NaN)).hasMessageContaining("NaN");
  }

  @Test
  void refusesNumbersThatAreNone() {
    assertThatThrownBy(() -> ACC_ROLL.withValue(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("accRoll")
        .hasMessageContaining("NaN");
    assertThatThrownBy(() -> ACC_ROLL.withBounds(1, 1)).hasMessageContaining("1.0");
    assertThatThrownBy(() -> ACC_ROLL.withBounds(Double.NaN, 1)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> new Parameter("a", "", 1, 0, 0, 2, true, ""))
        .hasMessageContaining("scale");
  }
}
