package fieldcal.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Offsets of cameras as free numbers without a gauge freedom: within each group of cameras that saw kicks in common the offsets' mean is zero by construction, or all kicks could move along with them. The numbers are
 * orthonormal contrasts (Helmert's), one fewer than the group has cameras, so that none of the cameras is special. Immutable.
 */
final class CameraContrasts {
  /** Of each camera, its share of each contrast. */
  private final double[][] share;

  private CameraContrasts(double[][] share) {
    this.share = share;
  }

  /**
   * Of cameras.
   *
   * @param cameras how many there are
   * @param seenTogether cameras that saw the same kick, one array a kick
   */
  static CameraContrasts of(int cameras, List<int[]> seenTogether) {
    int[] group = new int[cameras];
    Arrays.setAll(group, c -> c);
    for (int[] seen : seenTogether) {
      for (int s : seen) {
        int from = group[s];
        int to = group[seen[0]];
        for (int c = 0; c < cameras; c++) {
          group[c] = group[c] == from ? to : group[c];
        }
      }
    }
    List<double[]> contrasts = new ArrayList<>();
    for (int g = 0; g < cameras; g++) {
      List<Integer> before = new ArrayList<>();
      for (int c = 0; c < cameras; c++) {
        if (group[c] == g) {
          if (!before.isEmpty()) {
            contrasts.add(contrast(cameras, before, c));
          }
          before.add(c);
        }
      }
    }
    double[][] share = new double[cameras][contrasts.size()];
    for (int c = 0; c < cameras; c++) {
      for (int k = 0; k < contrasts.size(); k++) {
        share[c][k] = contrasts.get(k)[c];
      }
    }
    return new CameraContrasts(share);
  }

  /** A camera against the mean of those before it, of length 1. */
  private static double[] contrast(int cameras, List<Integer> before, int camera) {
    int n = before.size();
    double[] contrast = new double[cameras];
    before.forEach(c -> contrast[c] = 1 / Math.sqrt(n * (n + 1.0)));
    contrast[camera] = -n / Math.sqrt(n * (n + 1.0));
    return contrast;
  }

  /** How many contrasts there are for each axis. */
  int size() {
    return share.length == 0 ? 0 : share[0].length;
  }

  /** Whether a camera's offset is among what the contrasts can express; a camera that saw its kicks alone has none. */
  boolean determines(int camera) {
    return Arrays.stream(share[camera]).anyMatch(s -> s != 0);
  }

  /** A camera's offset along one axis; {@code values} has the contrasts of x, then y of each in turn, from {@code first} on. */
  double offset(double[] values, int first, int camera, int axis) {
    double sum = 0;
    for (int k = 0; k < size(); k++) {
      sum += share[camera][k] * values[first + 2 * k + axis];
    }
    return sum;
  }

  /** Standard error of that offset. */
  double error(double[][] covariance, int first, int camera, int axis) {
    double variance = 0;
    for (int k = 0; k < size(); k++) {
      for (int m = 0; m < size(); m++) {
        variance +=
            share[camera][k]
                * share[camera][m]
                * covariance[first + 2 * k + axis][first + 2 * m + axis];
      }
    }
    return Math.sqrt(variance);
  }
}
