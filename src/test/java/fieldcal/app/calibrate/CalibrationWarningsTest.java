package fieldcal.app.calibrate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class CalibrationWarningsTest {
  @Test
  void camerasThatNoKickLinksAreNamed() {
    assertThat(
            CalibrationWarnings.uncompared(
                List.of(new int[] {2}, new int[] {0, 1}, new int[] {1}, new int[] {2, 3})))
        .hasValueSatisfying(text -> assertThat(text).contains("(0 and 1; 2 and 3)"));
  }

  @Test
  void linksGoOnFromKickToKick() {
    List<int[]> kicks = List.of(new int[] {0, 1}, new int[] {2, 3}, new int[] {3, 0});
    assertThat(CalibrationWarnings.uncompared(kicks)).isEmpty();
    assertThat(CalibrationWarnings.uncompared(List.of())).isEmpty();
  }
}
