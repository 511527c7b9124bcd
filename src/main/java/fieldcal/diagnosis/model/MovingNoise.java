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
import java.util.stream.IntStream;

/**
 * The noise of a moving ball, from how much each residual differs from its two neighbours in the same camera: second differences feel noise, not what a wrong model does slowly. Across the path they give the camera's noise,
 * along it they also feel the noise of the time stamps, which grows with speed. A vision that smooths, or finds a ball in the picture before, makes successive errors alike: their differences are then less than those of detections that are farther apart.
 *
 * @param cameras with their noise
 * @param stampNoise standard deviation of time stamps, s
 * @param correlation of the errors of successive detections of a camera, from 0 = independent to below 1; later ones have none
 */
public record MovingNoise(CameraViews cameras, double stampNoise, double correlation) {
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

  /** Correlation of neighbours at which their second differences have no variance left. */
  private static final double LOST = 0.75;

  /** The median of squared standard normal numbers. */
  private static final double MEDIAN_OF_SQUARES = 0.4549;

  /** Detections between those of a second difference, for the correlation. */
  private static final int[] STRIDES = {2, 3};

  /** A second difference over so many detections of what a wrong model does slowly is as many times that of neighbours: it grows with the fourth power of the stride. */
  private static final double[] GROWTH = {16, 81};

  /** Less correlation than that is none: models that are wrong by centimetres make as much. */
  private static final double LEAST_CORRELATION = 0.15;

  /** Squared second differences across the path by stride, and along it of neighbours, with the speed. */
  private record Samples(List<Double> across, List<List<Double>> apart, List<double[]> along) {}

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
    double correlation = correlation(samples, scale);
    double whole = 1 / Math.sqrt(1 - correlation / LOST);
    CameraViews scaled =
        views.map(
            v ->
                v.withNoise(
                    v.noise() * (scale.containsKey(v.id()) ? whole * scale.get(v.id()) : 1)));
    return new MovingNoise(scaled, stampNoise(samples, scale, views), correlation);
  }

  /**
   * By how much the variance of a mean of successive detections of a camera is larger than if their errors were independent.
   *
   * @param count how many, 1 or more
   * @return 1 or more
   */
  public double inflation(int count) {
    return 1 + 2 * correlation * (count - 1) / count;
  }

  /** Second differences of neighbours have 6 − 8ρ variances, and of others 6. */
  private static double correlation(Map<Integer, Samples> samples, Map<Integer, Double> scale) {
    double[] ratio = new double[STRIDES.length];
    for (int s = 0; s < STRIDES.length; s++) {
      List<Double> all = new ArrayList<>();
      int stride = s;
      scale.forEach(
          (camera, own) ->
              samples.get(camera).apart.get(stride).forEach(v -> all.add(v / (own * own))));
      if (all.size() < FEWEST) {
        return 0;
      }
      ratio[s] = median(all) / MEDIAN_OF_SQUARES;
    }
    double slow = Math.max(0, (ratio[1] - ratio[0]) / (GROWTH[1] - GROWTH[0]));
    double noise = ratio[0] - GROWTH[0] * slow;
    double correlation = LOST * (1 - 1 / noise);
    return noise > 0 && correlation > LEAST_CORRELATION ? correlation : 0;
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
      int[] own =
          IntStream.range(0, seen.size()).filter(i -> kept[i] && seen.camera(i) == id).toArray();
      Samples s =
          samples.computeIfAbsent(
              id,
              c ->
                  new Samples(
                      new ArrayList<>(),
                      List.of(new ArrayList<>(), new ArrayList<>()),
                      new ArrayList<>()));
      for (int n = 1; n + 1 < own.length; n++) {
        whitening.at(views.get(id), seen.x(own[n]), seen.y(own[n]));
        if (isRegular(seen, own, n, 1)) {
          add(fit, whitening, own[n - 1], own[n], own[n + 1], s);
        }
        for (int k = 0; k < STRIDES.length; k++) {
          int stride = STRIDES[k];
          if (isRegular(seen, own, n, stride)) {
            double[] difference =
                difference(fit, whitening, own[n - stride], own[n], own[n + stride]);
            s.apart.get(k).add(difference[1]);
          }
        }
      }
    }
  }

  private static boolean isRegular(Observations seen, int[] own, int n, int stride) {
    if (n < stride || n + stride >= own.length) {
      return false;
    }
    double t1 = seen.time(own[n]);
    double before = t1 - seen.time(own[n - stride]);
    double after = seen.time(own[n + stride]) - t1;
    return before + after < stride * LONGEST_SPAN
        && before > 0
        && Math.abs(after / before - 1) < REGULAR;
  }

  private static void add(KickFit fit, Whitening whitening, int a, int b, int c, Samples to) {
    double[] difference = difference(fit, whitening, a, b, c);
    to.across.add(difference[1]);
    if (difference[2] > FAST) {
      to.along.add(new double[] {difference[0], difference[2]});
    }
  }

  /** Squared second difference along and across the path, in variances of the noise at rest, and the speed. */
  private static double[] difference(KickFit fit, Whitening whitening, int a, int b, int c) {
    double dx = fit.residualX(a) - 2 * fit.residualX(b) + fit.residualX(c);
    double dy = fit.residualY(a) - 2 * fit.residualY(b) + fit.residualY(c);
    BallState state = fit.trajectory().stateAt(fit.kick().observations().time(b));
    double speed = state.groundSpeed();
    double ux = speed > 0 ? state.vx() / speed : 1;
    double uy = speed > 0 ? state.vy() / speed : 0;
    double perNoise = whitening.w11() * whitening.w22() / SECOND_DIFFERENCE;
    double along = dx * ux + dy * uy;
    double across = dy * ux - dx * uy;
    return new double[] {along * along * perNoise, across * across * perNoise, speed};
  }

  private static double median(List<Double> values) {
    double[] sorted = values.stream().mapToDouble(v -> v).toArray();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }
}
