package fieldcal.app.report;

import fieldcal.app.report.CalibrationReport.Kick;
import fieldcal.app.report.CalibrationReport.Kind;
import fieldcal.app.report.CalibrationReport.Model;
import fieldcal.app.report.CalibrationReport.ModelParameter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Collectors;

/**
 * The calibration in words: what came out, how it compares with the published model, and what to do next.
 *
 * @param advice what the operator should do
 * @param title the page's title, a few words
 * @param lines one sentence per model
 */
public record Verdict(Advice advice, String title, List<String> lines) {
  /** A mean is called uncertain when its standard error exceeds this part of it; chosen, half of what the monitor warns at. */
  static final double UNCERTAIN_PERCENT = 10;

  /** Fewer kicks have no standard deviation worth selecting by. */
  static final int FEW_KICKS = 5;

  /** Average and joint fit that many standard errors apart are torn. */
  static final double TORN_SIGMAS = 3;

  /** Smaller differences between average and joint fit do not matter; chosen, a third of what makes a difference to the published model. */
  static final double TORN_PERCENT = 1;

  /** Copies the list. */
  public Verdict {
    Objects.requireNonNull(advice, "advice");
    Objects.requireNonNull(title, "title");
    lines = List.copyOf(lines);
  }

  /** What to do with the result. */
  public enum Advice {
    /** It is good and differs from what is published, or nothing is published. */
    PUBLISH,
    /** It is good and the same as what is published. */
    KEEP,
    /** The average and the joint fit disagree: the model does not hold for all kicks. */
    CHECK,
    /** Too few or too different kicks. */
    RECORD_MORE,
    /** Nothing to calibrate from. */
    NO_KICKS
  }

  /**
   * Judges a calibration.
   *
   * @param report the calibration
   * @return the verdict, with the gravest advice of its models
   */
  public static Verdict of(CalibrationReport report) {
    if (report.kicks().isEmpty()) {
      return new Verdict(
          Advice.NO_KICKS,
          "Ball calibration: no kick found",
          List.of(
              "No kick found in "
                  + sources(report)
                  + ": is there a ball in view, and is it kicked from rest?"));
    }
    List<String> lines = new ArrayList<>();
    Advice advice = report.models().isEmpty() ? Advice.RECORD_MORE : Advice.KEEP;
    for (Model model : report.models()) {
      Advice one = advice(model);
      lines.add(sentence(report, model, one));
      advice = graver(advice, one);
    }
    if (lines.isEmpty()) {
      lines.add(
          "None of the kicks found ("
              + report.kicks().size()
              + ") could be used: the table of kicks gives the reasons.");
    }
    return new Verdict(advice, "Ball calibration: " + sources(report), lines);
  }

  private static Advice graver(Advice a, Advice b) {
    List<Advice> order =
        List.of(Advice.KEEP, Advice.PUBLISH, Advice.CHECK, Advice.RECORD_MORE, Advice.NO_KICKS);
    return order.get(Math.max(order.indexOf(a), order.indexOf(b)));
  }

  private static Advice advice(Model model) {
    List<ModelParameter> estimated = estimated(model);
    boolean uncertain = estimated.stream().anyMatch(Verdict::isUncertain) || estimated.isEmpty();
    boolean compared = estimated.stream().allMatch(p -> Double.isFinite(p.differencePercent()));
    boolean differs = estimated.stream().anyMatch(ModelParameter::differs);
    if (uncertain) {
      return Advice.RECORD_MORE;
    }
    if (estimated.stream().anyMatch(Verdict::isTorn)) {
      return Advice.CHECK;
    }
    return differs || !compared ? Advice.PUBLISH : Advice.KEEP;
  }

  /** Parameters that are fixed have no kicks of their own and say nothing new. */
  private static List<ModelParameter> estimated(Model model) {
    return model.parameters().stream().filter(p -> p.note().isEmpty() || p.n() > 0).toList();
  }

  private static boolean isUncertain(ModelParameter p) {
    double percent = Math.abs(p.standardError() / p.mean()) * 100;
    return p.n() < FEW_KICKS || !(percent <= UNCERTAIN_PERCENT);
  }

  /** Average and joint fit weigh kicks differently; where the model holds for all of them, they agree within their errors. */
  private static boolean isTorn(ModelParameter p) {
    double apart = Math.abs(p.mean() - p.joint());
    boolean significant =
        apart > TORN_SIGMAS * Math.hypot(p.standardError(), p.jointStandardError());
    return significant && apart > TORN_PERCENT / 100 * Math.abs(p.mean());
  }

  private static String sentence(CalibrationReport report, Model model, Advice advice) {
    List<Kick> kicks = report.kicks().stream().filter(k -> k.kind() == model.kind()).toList();
    long selected = kicks.stream().filter(Kick::selected).count();
    String values = estimated(model).stream().map(Verdict::value).collect(Collectors.joining(", "));
    return String.format(
        Locale.ROOT,
        "%s model from %d of %d %s: %s; %s.",
        model.kind() == Kind.FLAT ? "Flat" : "Chip",
        selected,
        kicks.size(),
        kicks.size() == 1 ? "kick" : "kicks",
        values.isEmpty() ? "no parameter determined" : values,
        comparison(model, advice));
  }

  private static String comparison(Model model, Advice advice) {
    List<ModelParameter> estimated = estimated(model);
    String differing =
        estimated.stream()
            .filter(ModelParameter::differs)
            .map(p -> p.name() + " " + percent(p.differencePercent()))
            .collect(Collectors.joining(", "));
    boolean nothingPublished = estimated.stream().allMatch(p -> Double.isNaN(p.published()));
    String comparison =
        estimated.stream().anyMatch(p -> Double.isNaN(p.mean()))
            ? "not everything is determined"
            : nothingPublished
                ? "nothing is published to compare with"
                : differing.isEmpty()
                    ? "agrees with the published model"
                    : "differs from the published model: " + differing;
    return comparison
        + switch (advice) {
          case PUBLISH -> " — publish it";
          case KEEP -> " — nothing to do";
          case CHECK ->
              " — but the mean and the joint fit disagree in "
                  + estimated.stream()
                      .filter(Verdict::isTorn)
                      .map(ModelParameter::name)
                      .collect(Collectors.joining(", "))
                  + ": the model does not hold for all kicks. Look at their residuals, or run"
                  + " diagnose, before you publish";
          case RECORD_MORE -> " — " + uncertainty(estimated);
          case NO_KICKS -> "";
        };
  }

  private static String uncertainty(List<ModelParameter> estimated) {
    String names =
        estimated.stream()
            .filter(Verdict::isUncertain)
            .map(ModelParameter::name)
            .collect(Collectors.joining(", "));
    return names.isEmpty()
        ? "record more kicks"
        : "too uncertain in " + names + ": record more kicks";
  }

  private static String value(ModelParameter p) {
    if (Double.isNaN(p.mean())) {
      return p.name() + " undetermined";
    }
    String unit = p.unit().isEmpty() ? "" : " " + p.unit();
    int decimals = decimals(p.standardError());
    String mean = String.format(Locale.ROOT, "%." + decimals + "f", p.mean()).replace('-', '−');
    return p.standardError() >= 0
        ? String.format(
            Locale.ROOT, "%s %s ± %." + decimals + "f%s", p.name(), mean, p.standardError(), unit)
        : p.name() + " " + mean + unit;
  }

  /** Decimals that show an error with two digits when it begins with 1 to 3, else with one. */
  private static int decimals(double error) {
    if (!(error > 0)) {
      return 3;
    }
    int places = (int) -Math.floor(Math.log10(error));
    return Math.max(0, Math.min(5, error * Math.pow(10, places) < 3.55 ? places + 1 : places));
  }

  private static String percent(double value) {
    return String.format(Locale.ROOT, "%+.0f %%", value).replace('-', '−');
  }

  private static String sources(CalibrationReport report) {
    return report.provenance().sources().isEmpty()
        ? "the recording"
        : String.join(", ", report.provenance().sources());
  }
}
