package fieldcal.fit;

import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Measures each camera's noise on the ball that rests before a kick: there every deviation from the mean is noise.
 *
 * <p>The scale is the median of the squared whitened deviations, so that a few false detections do not matter.
 */
public final class CameraNoise {
  /** Fewer resting detections per kick say little, since their own mean is taken off. */
  private static final int FEWEST_PER_KICK = 8;

  /** Fewer in all leave the noise 10 % uncertain. */
  private static final int FEWEST = 50;

  private CameraNoise() {}

  /**
   * Noise per axis, straight below each camera.
   *
   * @param kicks any kind; those that did not begin at rest are passed over
   * @param views the cameras; their own noise is not used
   * @return m, by camera id; cameras that saw too little at rest are missing
   */
  public static Map<Integer, Double> atRest(List<Kick> kicks, CameraViews views) {
    CameraViews unit = views.map(v -> v.withNoise(1));
    Map<Integer, List<Double>> squares = new TreeMap<>();
    for (Kick kick : kicks) {
      if (kick.fromRest()) {
        Observations rest =
            kick.observations().between(Double.NEGATIVE_INFINITY, kick.time() - 0.02);
        for (int camera : rest.cameras()) {
          collect(rest, camera, unit, squares.computeIfAbsent(camera, c -> new ArrayList<>()));
        }
      }
    }
    Map<Integer, Double> noise = new TreeMap<>();
    squares.forEach(
        (camera, values) -> {
          if (values.size() >= FEWEST) {
            double[] squared = values.stream().mapToDouble(v -> v).toArray();
            noise.put(camera, Math.max(1e-5, RobustScale.ofSquaredDistances(squared)));
          }
        });
    return noise;
  }

  private static void collect(
      Observations rest, int camera, CameraViews unit, List<Double> squares) {
    int n = 0;
    double[] x = new double[rest.size()];
    double[] y = new double[rest.size()];
    FlightData data = FlightData.of(rest, unit);
    int[] index = new int[rest.size()];
    for (int i = 0; i < rest.size(); i++) {
      if (rest.camera(i) == camera) {
        x[n] = data.x[i];
        y[n] = data.y[i];
        index[n++] = i;
      }
    }
    if (n < FEWEST_PER_KICK) {
      return;
    }
    double mx = median(x, n);
    double my = median(y, n);
    // About the sample's own centre the deviations come out too small by (n − 1)/n.
    double correction = n / (n - 1.0);
    for (int k = 0; k < n; k++) {
      int i = index[k];
      double r1 = data.w11[i] * (x[k] - mx);
      double r2 = data.w21[i] * (x[k] - mx) + data.w22[i] * (y[k] - my);
      squares.add((r1 * r1 + r2 * r2) * correction);
    }
  }

  private static double median(double[] values, int n) {
    double[] sorted = Arrays.copyOf(values, n);
    Arrays.sort(sorted);
    return 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
  }
}
