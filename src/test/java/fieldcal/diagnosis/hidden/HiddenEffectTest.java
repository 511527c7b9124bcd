package fieldcal.diagnosis.hidden;

import org.junit.jupiter.api.Test;

/** Placeholder. */
class HiddenEffectTest {
  @Test
  void placeholder() {}
}
