package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Quality;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The first sentences of a diagnosis: how wrong kicks are predicted, before and after. They promise no more than the table of predictions holds: what was found may follow whole kicks much better and hardly help to predict them.
 */
final class Headline {
  /** How far ahead a kick is predicted, s. */
  private static final double AHEAD = 1;

  /** Predictions that gain less than this share are hardly better; chosen. */
  private static final double LEAST_GAIN = 0.1;

  /** A prediction that errs by a fiftieth more or less is as good; the diagnosis uses the same. */
  static final double AS_GOOD = 0.02;

  /** From that error on it is said in cm, unless two would look the same. */
  private static final double CENTIMETRES_FROM_MM = 100;

  /** A recording is one of chips, or of passes, if at most that share of its kicks is of the other kind: a low chip may be taken for a flat kick. */
  private static final double STRAYS = 0.1;

  private Headline() {}

  static String of(Diagnosis d) {
    boolean found = !d.causes().isEmpty() || !d.learned().isEmpty();
    Optional<Double> horizon = horizon(d);
    if (horizon.isEmpty()) {
      return missed(d, found);
    }
    double before = d.base().typicalErrorMm().get(horizon.get());
    double after = d.extended().typicalErrorMm().get(horizon.get());
    boolean cm =
        found
            ? Math.max(before, after) >= CENTIMETRES_FROM_MM
                && !length(before, true).equals(length(after, true))
            : before >= CENTIMETRES_FROM_MM;
    String unit = cm ? " cm" : " mm";
    String wrong =
        sentence(
            text(
                "%sthe calibrated model is off by %s after %s s",
                kicks(d), length(before, cm) + unit, VerdictText.seconds(horizon.get())));
    if (!found) {
      return wrong + ".";
    }
    String both = wrong + ", the extended model by " + length(after, cm) + unit;
    return after < (1 - LEAST_GAIN) * before
        ? both + "."
        : both + compared(before, after) + ". " + followed(d);
  }

  /**
   * Whether the first line says that what was found makes the prediction hardly better, no better or worse.
   *
   * @param d the diagnosis
   * @return false also where no kick is long enough to be predicted
   */
  static boolean doubts(Diagnosis d) {
    return horizon(d)
        .filter(
            h ->
                d.extended().typicalErrorMm().get(h)
                    >= (1 - LEAST_GAIN) * d.base().typicalErrorMm().get(h))
        .isPresent();
  }

  /** Why the second number is no gain. */
  private static String compared(double before, double after) {
    if (after < (1 - AS_GOOD) * before) {
      return ", hardly better";
    }
    return after > (1 + AS_GOOD) * before ? ", worse" : ", no better";
  }

  private static String length(double mm, boolean cm) {
    double value = cm ? mm / 10 : mm;
    return Amount.decimals(value, value < 5 ? 1 : 0);
  }

  /** What is gained on whole kicks where their prediction gains little. */
  private static String followed(Diagnosis d) {
    return text(
        held(d)
            ? "Whole held-out kicks are followed to %s mm instead of %s mm."
            : "Whole kicks are followed to %s mm instead of %s mm.",
        VerdictText.mm(residual(d, d.extended())),
        VerdictText.mm(residual(d, d.base())));
  }

  /** Where no kick is long enough to be predicted. */
  private static String missed(Diagnosis d, boolean found) {
    String model =
        text(
            held(d)
                ? "The calibrated model misses held-out kicks by %s mm"
                : "The calibrated model misses the kicks by %s mm",
            VerdictText.mm(residual(d, d.base())));
    return found
        ? text("%s, the extended model by %s mm.", model, VerdictText.mm(residual(d, d.extended())))
        : model + ".";
  }

  private static boolean held(Diagnosis d) {
    return !Double.isNaN(d.base().holdoutRmsMm());
  }

  private static double residual(Diagnosis d, Quality of) {
    return held(d) ? of.holdoutRmsMm() : of.rmsMm();
  }

  private static String sentence(String text) {
    return Character.toUpperCase(text.charAt(0)) + text.substring(1);
  }

  /** Of which kicks the first sentence is, where nearly all are alike. */
  private static String kicks(Diagnosis d) {
    double chips = d.kicks().stream().filter(k -> k.kind() == KickKind.CHIP).count();
    double share = d.kicks().isEmpty() ? 0 : chips / d.kicks().size();
    if (share >= 1 - STRAYS) {
      return "For chips, ";
    }
    return share <= STRAYS ? "For passes, " : "";
  }

  /** A second where there is one, else the longest. */
  private static Optional<Double> horizon(Diagnosis d) {
    Map<Double, Double> before = d.base().typicalErrorMm();
    Map<Double, Double> after = d.extended().typicalErrorMm();
    List<Double> all =
        before.keySet().stream()
            .filter(h -> VerdictText.isKnown(before.get(h)) && VerdictText.isKnown(after.get(h)))
            .toList();
    return all.contains(AHEAD) ? Optional.of(AHEAD) : all.stream().reduce((a, b) -> b);
  }
}
