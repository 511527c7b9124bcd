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
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * The noise of a moving ball, from how much each residual differs from its two neighbours in the same camera: second differences show noise, and not the slow error of a wrong model. Across the path they give the camera's noise;
 * along it they also show the noise of the time stamps, which grows with speed. A vision that smooths, or starts from the picture before, makes successive errors alike: their differences are then smaller than those of detections that are farther apart.
 *
 * @param cameras with their noise
 * @param stampNoise standard deviation of time stamps, s
 * @param correlation of the errors of successive detections of a camera, from 0 = independent to below 1
 * @param decay of the correlation with each detection that lies between, from 0 = only neighbours are alike to below 1, as in an ARMA(1,1) process (Box and Jenkins 1970)
 */
public record MovingNoise(
    CameraViews cameras, double stampNoise, double correlation, double decay) {
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

  /** Detections from one to the next of a second difference, for the correlation: the far ones have next to none. */
  private static final int[] STRIDES = {1, 2, 3, 4, 5};

  /** The second difference of the slow error of a wrong model grows with the square of the stride, and its square with this power. */
  private static final int SLOW_POWER = 4;

  /** Decays of the correlation that are tried. */
  private static final double[] DECAYS = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};

  /** If each error keeps a part of the one before, the correlation decays with its own powers; in a moving average it ends. A decay that is slower by more than a step of the decays comes from a wrong model and not from noise. */
  private static final double SLOWER = 0.1;

  /** Largest relative misfit of the strides to the best decay, as the root of the sum of squares. Their medians are known to 2 % each, which makes half of it (at most 0.05 in recordings with correlated noise). A camera that vibrates at 7 to 13 Hz with a fifth of the variance leaves 0.15 and more. */
  private static final double MISFIT = 0.1;

  /** Column of what a wrong model does slowly. */
  private static final int SLOW = 2;

  /** A smaller correlation counts as none: models that are wrong by centimetres make as much. */
  private static final double LEAST_CORRELATION = 0.15;

  /** Squared second differences across the path by stride, and along it of neighbours, with the speed. */
  private record Samples(List<List<Double>> across, List<double[]> along) {
    static Samples none() {
      List<List<Double>> across = new ArrayList<>();
      for (int k = 0; k < STRIDES.length; k++) {
        across.add(new ArrayList<>());
      }
      return new Samples(across, new ArrayList<>());
    }

    List<Double> ofNeighbours() {
      return across.get(0);
    }
  }

  /**
   * How errors of successive detections are alike.
   *
   * @param variance of an error, in a sixth of the variance of a second difference of neighbours: 1 where they are independent
   * @param correlation of neighbours
   * @param decay with each detection between
   */
  private record Likeness(double variance, double correlation, double decay) {
    static final Likeness NONE = new Likeness(1, 0, 0);
  }

  /**
   * Measures.
   *
   * @param fits kicks, each with its own fit
   * @param kept which detections of each are the ball
   * @param views cameras with the noise of a resting ball
   * @return their noise on a moving ball; where too little was seen, that of a resting ball
   */
  public static MovingNoise of(List<KickFit> fits, List<boolean[]> kept, CameraViews views) {
    Map<Integer, Samples> samples = new HashMap<>();
    for (int k = 0; k < fits.size(); k++) {
      collect(fits.get(k), kept.get(k), views, samples);
    }
    Map<Integer, Double> scale = new HashMap<>();
    samples.forEach(
        (camera, s) -> {
          if (s.ofNeighbours().size() >= FEWEST) {
            scale.put(camera, Math.sqrt(median(s.ofNeighbours()) / MEDIAN_OF_SQUARES));
          }
        });
    Likeness alike = likeness(samples, scale);
    double whole = Math.sqrt(alike.variance);
    CameraViews scaled =
        views.map(
            v ->
                v.withNoise(
                    v.noise() * (scale.containsKey(v.id()) ? whole * scale.get(v.id()) : 1)));
    return new MovingNoise(
        scaled, stampNoise(samples, scale, views), alike.correlation, alike.decay);
  }

  /**
   * By how much the variance of a mean of successive detections of a camera is larger than if their errors were independent.
   *
   * @param count how many, 1 or more
   * @return 1 or more
   */
  public double inflation(int count) {
    double inflation = 1;
    double alike = correlation;
    for (int apart = 1; apart < count; apart++) {
      inflation += 2 * alike * (count - apart) / count;
      alike *= decay;
    }
    return inflation;
  }

  /** Second differences over a stride s have 6 − 8 ρ(s) + 2 ρ(2s) variances of the noise, and what a wrong model does slowly; least squares of all strides, for each decay. */
  private static Likeness likeness(Map<Integer, Samples> samples, Map<Integer, Double> scale) {
    double[] seen = new double[STRIDES.length];
    for (int s = 0; s < STRIDES.length; s++) {
      List<Double> all = new ArrayList<>();
      int stride = s;
      scale.forEach(
          (camera, own) ->
              samples.get(camera).across.get(stride).forEach(v -> all.add(v / (own * own))));
      if (all.size() < FEWEST) {
        return Likeness.NONE;
      }
      seen[s] = median(all) / MEDIAN_OF_SQUARES;
    }
    Likeness best = Likeness.NONE;
    double least = Double.POSITIVE_INFINITY;
    for (double decay : DECAYS) {
      RealMatrix slow = columns(seen, decay, true);
      RealVector ones = new ArrayRealVector(seen.length, 1);
      RealVector fitted = solved(slow, ones);
      if (fitted.getEntry(SLOW) < 0) {
        slow = columns(seen, decay, false);
        fitted = solved(slow, ones);
      }
      double left = slow.operate(fitted).subtract(ones).getNorm();
      double correlation = fitted.getEntry(1) / fitted.getEntry(0);
      if (left < least && decay <= Math.max(0, correlation + SLOWER)) {
        least = left;
        best = new Likeness(fitted.getEntry(0), correlation, decay);
      }
    }
    boolean sound = best.variance > 0 && best.correlation > LEAST_CORRELATION && least < MISFIT;
    return sound ? best : Likeness.NONE;
  }

  private static RealVector solved(RealMatrix columns, RealVector right) {
    return new QRDecomposition(columns).getSolver().solve(right);
  }

  /** What each stride's second difference has of the variance, of the covariance of neighbours, and of what is slow; each row divided by what was seen, because the errors grow in proportion to it. */
  private static RealMatrix columns(double[] seen, double decay, boolean slow) {
    RealMatrix columns = new Array2DRowRealMatrix(seen.length, slow ? 3 : 2);
    for (int s = 0; s < seen.length; s++) {
      int stride = STRIDES[s];
      double near = Math.pow(decay, stride - 1);
      double far = Math.pow(decay, 2 * stride - 1);
      columns.setEntry(s, 0, 1 / seen[s]);
      columns.setEntry(s, 1, (-8 * near + 2 * far) / SECOND_DIFFERENCE / seen[s]);
      if (slow) {
        columns.setEntry(s, SLOW, Math.pow(stride, SLOW_POWER) / seen[s]);
      }
    }
    return columns;
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
      Samples s = samples.computeIfAbsent(id, c -> Samples.none());
      for (int n = 1; n + 1 < own.length; n++) {
        whitening.at(views.get(id), seen.x(own[n]), seen.y(own[n]));
        for (int k = 0; k < STRIDES.length; k++) {
          int stride = STRIDES[k];
          if (isRegular(seen, own, n, stride)) {
            double[] difference =
                difference(fit, whitening, own[n - stride], own[n], own[n + stride]);
            s.across.get(k).add(difference[1]);
            if (stride == 1 && difference[2] > FAST) {
              s.along.add(new double[] {difference[0], difference[2]});
            }
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
