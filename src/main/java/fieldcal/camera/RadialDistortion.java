package fieldcal.camera;

/**
 * A lens that draws a point of undistorted radius ru at radius rd with {@code ru = rd·(1 + k·rd²)}, radii in focal lengths.
 *
 * <p>k &gt; 0 (barrel) squeezes the image's edge and reaches every ru. k &lt; 0 (pincushion) stretches it and reaches only up to the fold,
 * rd = 1/√(−3k), beyond which the formula turns back and no longer describes a lens. SSL-Vision's own way from the world to the image treats
 * k &lt; 0 as k = 0, though its way from the image to the world, which makes the positions it reports, applies k of either sign. Here
 * both ways apply it.
 */
final class RadialDistortion {

  private final double k;

  /** Distorted radius at which a lens with k < 0 folds, 1/√(3|k|); for k > 0 only a scale; infinite for k = 0. */
  private final double foldRadius;

  RadialDistortion(double k) {
    this.k = k;
    this.foldRadius = 1 / Math.sqrt(3 * Math.abs(k));
  }

  /** ru/rd at the squared distorted radius; NaN beyond the fold. */
  double undistortingFactor(double rdSquared) {
    if (k < 0 && rdSquared > foldRadius * foldRadius) {
      return Double.NaN;
    }
    return 1 + k * rdSquared;
  }

  /**
   * rd/ru at an undistorted radius; NaN beyond the fold. The cubic k·rd³ + rd = ru in closed form: with rd = 2·fold·sinh(a) (k &gt; 0) it becomes
   * sinh(3a) = 3/2·ru/fold, with rd = 2·fold·sin(a) (k &lt; 0) it becomes sin(3a) = 3/2·ru/fold.
   */
  double distortingFactor(double ru) {
    double s = 1.5 * ru / foldRadius;
    if (s < 1e-9) {
      return 1; // k·ru² < 2e-19: no lens at all, or the optical axis, where the quotient below is
      // 0/0
    }
    double rd = 2 * foldRadius * (k > 0 ? Math.sinh(asinh(s) / 3) : Math.sin(Math.asin(s) / 3));
    return rd / ru;
  }

  private static double asinh(double s) {
    return Math.log1p(s + s * s / (1 + Math.sqrt(1 + s * s)));
  }

  double coefficient() {
    return k;
  }
}
