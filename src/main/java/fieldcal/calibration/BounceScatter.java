package fieldcal.calibration;

import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import java.util.List;

/**
 * By how much the bounces of each chip may differ from each other, from how the chips differ: what makes one kick bounce differently from the others, as spin does, fades from bounce to bounce, and so differs by as much within the kick. A kick that bounces as the
 * others do has even bounces.
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

  /** Root mean square of what a kick differs from the average by, given its own value, which has an error, and that of the average. */
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
