package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.Effect;
import java.util.Map;

/**
 * Spin from the kicker in words.
 *
 * @param flat mean spin of flat kicks, or of all where the kinds were not distinguished, in units of rolling spin
 * @param chips mean spin of chips
 * @param error standard error of either; NaN when unknown
 */
record KickerSpin(double flat, double chips, double error) {
  static final String ID = "kick_spin";

  static KickerSpin of(Effect effect, Map<String, Double> standardErrors) {
    double flat = effect.value("fraction");
    return new KickerSpin(
        flat, flat + effect.value("chips"), standardErrors.getOrDefault("fraction", Double.NaN));
  }

  private boolean isUnsure(double mean) {
    return Math.abs(mean) < 2 * error;
  }

  private boolean isApart() {
    return flat != chips;
  }

  /** Which spin it is, of flat kicks and of chips alike; "topspin/backspin" where it is both or may be either. */
  String sort() {
    boolean both = isApart() && !isUnsure(flat) && !isUnsure(chips) && flat * chips < 0;
    if (both || isUnsure(flat) && isUnsure(chips)) {
      return "topspin/backspin";
    }
    return sort(isUnsure(flat) ? chips : flat);
  }

  private static String sort(double mean) {
    return mean < 0 ? "backspin" : "topspin";
  }

  /** A sentence without its consequence. */
  String sentence() {
    if (!isApart()) {
      return isUnsure(flat)
          ? "The kickers give the ball topspin in some kicks and backspin in others."
          : text(
              "The kickers give the ball %s: %s %% of the spin of a rolling ball.",
              sort(flat), MotionText.percent(Math.abs(flat)));
    }
    if (isUnsure(chips) && isUnsure(flat)) {
      return text(
          "The kickers give the ball topspin in some kicks and backspin in others: on average"
              + " %s ± %s %% of the spin of a rolling ball in chips, %s ± %s %% in flat kicks.",
          MotionText.percent(chips),
          MotionText.percent(error),
          MotionText.percent(flat),
          MotionText.percent(error));
    }
    return text(
        "The kickers give chips %s and flat kicks %s; 100 %% is the spin of a rolling ball.",
        mean(chips), mean(flat));
  }

  private String mean(double mean) {
    return isUnsure(mean)
        ? text(
            "no spin that is certain (%s ± %s %%)",
            MotionText.percent(mean), MotionText.percent(error))
        : text("%s %% %s", MotionText.percent(Math.abs(mean)), sort(mean));
  }
}
