package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Offsets of five cameras in three groups: 0, 2 and 4 are linked through 2, 1 stands with 3 … and a sixth alone. */
class CameraContrastsTest {
  private static final CameraContrasts CONTRASTS =
      CameraContrasts.of(
          6, List.of(new int[] {0, 2}, new int[] {1, 3}, new int[] {4, 2}, new int[] {5}));

  @Test
  void oneFewerThanEachGroupHasCameras() {
    assertThat(CONTRASTS.size()).isEqualTo(3);
    assertThat(CONTRASTS.determines(5)).isFalse();
    assertThat(CONTRASTS.determines(4)).isTrue();
  }

  @Test
  void theMeanOfEachGroupIsZeroAndLengthsAreKept() {
    double[] values = {9, 0.3, -0.7, 1.1, 0.2, -0.4, 0.5};
    for (int axis = 0; axis < 2; axis++) {
      double[] o = new double[6];
      double squares = 0;
      for (int c = 0; c < 6; c++) {
        o[c] = CONTRASTS.offset(values, 1, c, axis);
        squares += o[c] * o[c];
      }
      assertThat(o[0] + o[2] + o[4]).isEqualTo(0, within(1e-15));
      assertThat(o[1] + o[3]).isEqualTo(0, within(1e-15));
      assertThat(o[5]).isZero();
      double expected = 0;
      for (int k = 1 + axis; k < values.length; k += 2) {
        expected += values[k] * values[k];
      }
      assertThat(squares).isEqualTo(expected, within(1e-14));
    }
  }

  @Test
  void equallyKnownContrastsAreEquallyKnownOffsets() {
    double[][] covariance = new double[6][6];
    for (int k = 0; k < 6; k++) {
      covariance[k][k] = 4;
    }
    // Of three cameras each has 2/3 of the variance, of two 1/2.
    assertThat(CONTRASTS.error(covariance, 0, 0, 0)).isEqualTo(Math.sqrt(8.0 / 3), within(1e-12));
    assertThat(CONTRASTS.error(covariance, 0, 4, 1)).isEqualTo(Math.sqrt(8.0 / 3), within(1e-12));
    assertThat(CONTRASTS.error(covariance, 0, 3, 0)).isEqualTo(Math.sqrt(2), within(1e-12));
  }
}
