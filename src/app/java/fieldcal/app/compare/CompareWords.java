package fieldcal.app.compare;

import fieldcal.app.compare.FieldComparison.Named;
import fieldcal.diagnosis.Unexplained;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** The result of a comparison in a sentence. */
final class CompareWords {
  /** A shorter difference of the pass is below what a robot's reach makes up for, m. */
  private static final double SMALL = 0.02;

  /** A share above that means that other differences act against this one. */
  private static final double MOST = 1.1;

  private CompareWords() {}

  static String verdict(
      double passReal, double passSim, List<Named> named, Map<Double, Double> errors) {
    if (named.isEmpty()) {
      return "These kicks show no difference between the ball on the field and in the simulator.";
    }
    double longer = passSim - passReal;
    if (!Double.isFinite(longer) || Math.abs(longer) < SMALL) {
      double error = errors.getOrDefault(Cost.SHARE_HORIZON, Double.NaN);
      String ahead =
          Double.isFinite(error)
              ? String.format(
                  Locale.ROOT,
                  "The predictions of an AI tuned on the simulator are off by %.0f mm after 1 s",
                  1000 * error)
              : "The ball behaves differently in the simulator";
      return ahead + part(named, Comparator.comparingDouble(Named::shareOfError), true) + ".";
    }
    return String.format(
            Locale.ROOT,
            "A pass at %.0f m/s rolls %.2f m %s on the field than in the simulator",
            Cost.PASS,
            Math.abs(longer),
            longer > 0 ? "less far" : "farther")
        + part(named, Comparator.comparingDouble(Named::shareOfPass), false)
        + ".";
  }

  /** A sentence, with a space before it, that a difference may be none; empty where both sides are explained or nothing differs. */
  static String doubt(List<Named> named, Unexplained field, Unexplained simulator) {
    if (named.isEmpty() || !field.significant() && !simulator.significant()) {
      return "";
    }
    boolean both = field.significant() && simulator.significant();
    String where = both ? "both sides" : field.significant() ? "the field" : "the simulator";
    double most =
        Math.max(
            field.significant() ? field.systematicMm() : 0,
            simulator.significant() ? simulator.systematicMm() : 0);
    return String.format(
        Locale.ROOT,
        " In the residuals of %s, %.2g mm have no known cause: a difference may come from that.",
        where,
        most);
  }

  private static String part(List<Named> named, Comparator<Named> by, boolean ofError) {
    Optional<Named> most =
        named.stream()
            .filter(n -> Double.isFinite(ofError ? n.shareOfError() : n.shareOfPass()))
            .max(by);
    return most.map(n -> part(n.words(), ofError ? n.shareOfError() : n.shareOfPass())).orElse("");
  }

  private static String part(String words, double share) {
    return share > MOST
        ? ". The largest cause is " + words + "; other differences act against it"
        : ". The largest cause is " + words + ": " + share(share) + " of it";
  }

  /** A share in words. */
  static String share(double share) {
    if (share > 0.9) {
      return "nearly all";
    }
    return String.format(Locale.ROOT, "%.0f %%", 100 * share);
  }
}
