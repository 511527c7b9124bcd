package fieldcal.calibration;

import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import java.util.List;

/**
 * By how much the bounces of each chip may differ from each other, estimated from how the chips differ. What makes one kick bounce differently from the others, as spin does, fades from bounce to bounce, so it changes by as much within the kick. A kick that bounces as the others do has equal bounces.
 */
final class BounceScatter {
  private static final String OTHER_HOPS = "dampingXyOtherHops";

  private BounceScatter() {}

  /**
   * Fits whose errors cover it.
   *
   * @param fits of all kicks
   * @param cameras with which they were made
   * @param decisions about them
   * @return the same fits in the same order; themselves where chips do not differ by more than their errors
   */
  static List<KickFit> covered(
      List<KickFit> fits, CameraViews cameras, Selection.Decisions decisions) {
    Average average =
        Selection.averages(Selection.select(fits, decisions), KickKind.CHIP).get(OTHER_HOPS);
    if (!(average.scatter() > 0)) {
      return fits;
    }
    return fits.stream()
        .map(
            f ->
                f.failure().isPresent() || f.kind() != KickKind.CHIP
                    ? f
                    : f.withUnevenBounces(cameras, of(f.estimate(OTHER_HOPS), average)))
        .toList();
  }

  /** Expected root mean square of a kick's true difference from the average, given its own value with its error and the average. */
  private static double of(Estimate kick, Average average) {
    double variance = average.scatter() * average.scatter();
    double error = average.standardError();
    double unknown = variance;
    double apart = 0;
    if (kick.usable()) {
      double own = kick.standardError() * kick.standardError();
      double share = variance / (variance + own);
      apart = share * (kick.value() - average.mean());
      unknown = share * own;
    }
    return Math.sqrt(apart * apart + unknown + error * error);
  }
}
