package fieldcal.diagnosis.model;

import fieldcal.ball.BallState;
import fieldcal.fit.CameraViews;
import fieldcal.fit.KickFit;
import fieldcal.fit.Whitening;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The noise of a moving ball, from how much each residual differs from its two neighbours in the same camera: second differences feel noise, not what a wrong model does slowly. Across the path they give the camera's noise,
 * along it they also feel the noise of the time stamps, which grows with speed.
 *
 * @param cameras with their noise
 * @param stampNoise standard deviation of time stamps, s
 */
public record MovingNoise(CameraViews cameras, double stampNoise) {
  /** Fewer differences leave a camera's noise as it was at rest. */
  private static final int FEWEST = 80;

  /** Ball faster than that shows the noise of time stamps, m/s. */
  private static final double FAST = 1.5;

  /** Longest time that three neighbours span, s: cameras of 50 Hz and more. */
  private static final double LONGEST_SPAN = 0.06;

  /** Largest difference between the two intervals, as a share: else a lost frame lies between. */
  private static final double REGULAR = 0.3;

  /** A second difference of independent noise has six times its variance. */
  private static final double SECOND_DIFFERENCE = 6;

  /** The median of squared standard normal numbers. */
  private static final double MEDIAN_OF_SQUARES = 0.4549;

  private record Samples(List<Double> across, List<double[]> along) {}

  /**
   * Measures.
   *
   * @param fits kicks, each with its own fit
   * @param kept which detections of each are the ball
   * @param views cameras with the noise of a resting ball
   * @return their noise on a moving ball; that at rest where too little was seen
   */
  public static MovingNoise of(List<KickFit> fits, List<boolean[]> kept, CameraViews views) {
    Map<Integer, Samples> samples = new HashMap<>();
    for (int k = 0; k < fits.size(); k++) {
      collect(fits.get(k), kept.get(k), views, samples);
    }
    Map<Integer, Double> scale = new HashMap<>();
    samples.forEach(
        (camera, s) -> {
          if (s.across.size() >= FEWEST) {
            scale.put(camera, Math.sqrt(median(s.across) / MEDIAN_OF_SQUARES));
          }
        });
    CameraViews scaled = views.map(v -> v.withNoise(v.noise() * scale.getOrDefault(v.id(), 1.0)));
    return new MovingNoise(scaled, stampNoise(samples, scale, views));
  }

  private static double stampNoise(
      Map<Integer, Samples> samples, Map<Integer, Double> scale, CameraViews views) {
    List<Double> excess = new ArrayList<>();
    samples.forEach(
        (camera, s) -> {
          double own = scale.getOrDefault(camera, 1.0);
          double noise = views.get(camera).noise();
          for (double[] a : s.along) {
            // Squared difference in variances of the camera's noise, and the squared noise per
            // speed.
            excess.add((a[0] / MEDIAN_OF_SQUARES - own * own) * noise * noise / (a[1] * a[1]));
          }
        });
    // The median of a chi-square variable is its mean times a constant, so the median excess is
    // that of time stamps.
    return excess.size() < FEWEST ? 0 : Math.sqrt(Math.max(0, median(excess)));
  }

  private static void collect(
      KickFit fit, boolean[] kept, CameraViews views, Map<Integer, Samples> samples) {
    Observations seen = fit.kick().observations();
    Whitening whitening = new Whitening();
    for (int id : seen.cameras()) {
      int a = -1;
      int b = -1;
      Samples s =
          samples.computeIfAbsent(id, c -> new Samples(new ArrayList<>(), new ArrayList<>()));
      for (int i = 0; i < seen.size(); i++) {
        if (!kept[i] || seen.camera(i) != id) {
          continue;
        }
        if (a >= 0 && isRegular(seen.time(a), seen.time(b), seen.time(i))) {
          whitening.at(views.get(id), seen.x(b), seen.y(b));
          add(fit, whitening, a, b, i, s);
        }
        a = b;
        b = i;
      }
    }
  }

  private static boolean isRegular(double t0, double t1, double t2) {
    return t2 - t0 < LONGEST_SPAN && t1 > t0 && Math.abs((t2 - t1) / (t1 - t0) - 1) < REGULAR;
  }

  private static void add(KickFit fit, Whitening whitening, int a, int b, int c, Samples to) {
    double dx = fit.residualX(a) - 2 * fit.residualX(b) + fit.residualX(c);
    double dy = fit.residualY(a) - 2 * fit.residualY(b) + fit.residualY(c);
    BallState state = fit.trajectory().stateAt(fit.kick().observations().time(b));
    double speed = state.groundSpeed();
    double ux = speed > 0 ? state.vx() / speed : 1;
    double uy = speed > 0 ? state.vy() / speed : 0;
    double perNoise = whitening.w11() * whitening.w22() / SECOND_DIFFERENCE;
    double along = dx * ux + dy * uy;
    double across = dy * ux - dx * uy;
    to.across.add(across * across * perNoise);
    if (speed > FAST) {
      to.along.add(new double[] {along * along * perNoise, speed});
    }
  }

  private static double median(List<Double> values) {
    double[] sorted = values.stream().mapToDouble(v -> v).toArray();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }
}
