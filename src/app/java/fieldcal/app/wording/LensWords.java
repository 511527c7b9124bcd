package fieldcal.app.wording;

import java.util.Locale;

/** How a lens that cannot be the one that took the pictures is named. */
public final class LensWords {
  private LensWords() {}

  /**
   * For example "its published lens (distortion −0.5) does not see 37 % of the places where it reports balls".
   *
   * @param distortion as published
   * @param unseen share of the camera's detections that the lens does not see, 0 … 1
   * @return a clause
   */
  public static String unseen(double distortion, double unseen) {
    return String.format(
        Locale.ROOT,
        "its published lens (distortion %s) does not see %.0f %% of the places where it reports"
            + " balls",
        Amount.minus(String.format(Locale.ROOT, "%.4g", distortion)),
        100 * unseen);
  }
}
