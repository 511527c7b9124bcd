package fieldcal.app.twin;

import fieldcal.app.statistics.Comparison;
import fieldcal.app.statistics.Statistic;
import fieldcal.app.wording.Amount;
import fieldcal.app.wording.EffectName;
import fieldcal.app.wording.VerdictText;
import fieldcal.diagnosis.Unexplained;
import fieldcal.effect.Effect;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** A comparison in words. */
final class TwinWords {
  /** How ids of the scatter of a chip's dampings begin. */
  private static final String SCATTER_OF_BOUNCES = "chip_scatter.damping";

  private TwinWords() {}

  static String sentence(Comparison c) {
    String words = c.statistic().words();
    String unit = c.statistic().unit().isEmpty() ? "" : " " + c.statistic().unit();
    boolean pairs = c.statistic().comparison() == Statistic.How.PAIRED;
    boolean bounces = c.statistic().id().startsWith(SCATTER_OF_BOUNCES) && c.second() < c.first();
    return String.format(
        Locale.ROOT,
        "%s%s: %s%s in the recording, %s%s in the twin%s.%s",
        words.substring(0, 1).toUpperCase(Locale.ROOT),
        words.substring(1),
        number(c.first()),
        unit,
        number(c.second()),
        unit,
        pairs ? "; the same kicks differ by " + number(c.difference()) + unit : "",
        bounces ? " Bounces differ from kick to kick; those of the twin all obey one model." : "");
  }

  /** A cause of the twin, for example "air drag (cd 0.50)"; with its scatter from kick to kick where it has one. */
  static String cause(Effect effect, double scatter) {
    String strength = EffectName.strength(effect, Map.of());
    String scattered = scatter > 0 ? ", scatter " + Amount.decimals(scatter, 2) : "";
    return EffectName.of(effect) + " (" + strength + scattered + ")";
  }

  /** What the diagnosis could not explain, and the twin therefore lacks; empty when nothing is left. */
  static Optional<String> unexplained(Unexplained rest) {
    return rest.significant()
        ? Optional.of(
            "The twin lacks what the diagnosis could not explain: " + VerdictText.rest(rest))
        : Optional.empty();
  }

  /** With four significant figures. */
  static String number(double value) {
    if (value == 0 || !Double.isFinite(value)) {
      return value == 0 ? "0" : "–";
    }
    int decimals = (int) Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(Math.abs(value)))));
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }
}
