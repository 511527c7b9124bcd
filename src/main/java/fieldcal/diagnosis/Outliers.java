package fieldcal.diagnosis;

import fieldcal.fit.CameraViews;
import fieldcal.fit.KickFit;
import fieldcal.fit.Whitening;
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

  private Outliers() {}

  /** Which detections are the ball. */
  static boolean[] kept(KickFit fit, CameraViews views) {
    Observations seen = fit.kick().observations();
    boolean[] kept = new boolean[seen.size()];
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
        kept[i] = Math.hypot(rx, ry) < TOO_FAR && r1 * r1 + r2 * r2 < FAR * FAR * slack(fit, i);
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
