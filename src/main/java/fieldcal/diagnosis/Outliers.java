package fieldcal.diagnosis;

import fieldcal.fit.CameraViews;
import fieldcal.fit.KickFit;
import fieldcal.fit.Whitening;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.Arrays;

/**
 * Tells detections of something else than the ball from what a wrong model makes of good ones: the first stand out from the detections of the same camera just before and after, the
 * second are all off alike.
 */
final class Outliers {
  /** How many detections of the same camera before and after are compared. */
  private static final int NEIGHBOURS = 5;

  /** Distance from the neighbours' median at which a detection is none of the ball, in standard deviations; Gaussian noise reaches it once in 25,000 detections. */
  private static final double FAR = 4.9;

  /** Beyond that distance from the path, m, nothing is the ball: no effect moves it so far from where the kick's own fit has it. */
  private static final double TOO_FAR = 0.25;

  /** A kick's time, as found without a model, is known to that, s. */
  private static final double UNSURE = 0.1;

  /** Resting detections from which on they tell where the ball lay. */
  private static final int LEAST_REST = 5;

  private Outliers() {}

  /**
   * Where the ball lay before the kick: the median of what the cameras saw, which no model of its flight can get wrong.
   *
   * @return x and y, m; null when it did not rest, or was seen too rarely
   */
  static double[] rest(Kick kick) {
    Observations seen = kick.observations();
    int n = 0;
    while (n < seen.size() && seen.time(n) < kick.time() - UNSURE) {
      n++;
    }
    if (!kick.fromRest() || n < LEAST_REST) {
      return null;
    }
    double[] x = new double[n];
    double[] y = new double[n];
    for (int i = 0; i < n; i++) {
      x[i] = seen.x(i);
      y[i] = seen.y(i);
    }
    Arrays.sort(x);
    Arrays.sort(y);
    return new double[] {x[n / 2], y[n / 2]};
  }

  /** Which detections are the ball. */
  static boolean[] kept(KickFit fit, CameraViews views) {
    Observations seen = fit.kick().observations();
    boolean[] kept = new boolean[seen.size()];
    double[] rest = rest(fit.kick());
    double restEnds = rest == null ? Double.NEGATIVE_INFINITY : fit.kick().time() - UNSURE;
    Whitening whitening = new Whitening();
    for (int id : seen.cameras()) {
      int[] of = indices(seen, id);
      for (int k = 0; k < of.length; k++) {
        int i = of[k];
        whitening.at(views.get(id), seen.x(i), seen.y(i));
        double rx = fit.residualX(i);
        double ry = fit.residualY(i);
        double dx = rx - median(fit, of, k, true);
        double dy = ry - median(fit, of, k, false);
        double r1 = whitening.w11() * dx;
        double r2 = whitening.w21() * dx + whitening.w22() * dy;
        boolean near =
            seen.time(i) < restEnds
                ? Math.hypot(seen.x(i) - rest[0], seen.y(i) - rest[1]) < TOO_FAR
                : Math.hypot(rx, ry) < TOO_FAR;
        kept[i] = near && r1 * r1 + r2 * r2 < FAR * FAR * slack(fit, i);
      }
    }
    return kept;
  }

  /** What the kick's own fit kept may deviate somewhat more: where a ball bounces, neighbours differ. */
  private static double slack(KickFit fit, int i) {
    return fit.used(i) ? 1.5 : 1;
  }

  private static int[] indices(Observations seen, int camera) {
    int[] of = new int[seen.size()];
    int n = 0;
    for (int i = 0; i < of.length; i++) {
      if (seen.camera(i) == camera) {
        of[n++] = i;
      }
    }
    return Arrays.copyOf(of, n);
  }

  private static double median(KickFit fit, int[] of, int k, boolean x) {
    int from = Math.max(0, k - NEIGHBOURS);
    int to = Math.min(of.length, k + NEIGHBOURS + 1);
    double[] values = new double[to - from];
    for (int j = from; j < to; j++) {
      values[j - from] = x ? fit.residualX(of[j]) : fit.residualY(of[j]);
    }
    Arrays.sort(values);
    return values[values.length / 2];
  }
}
