package fieldcal.app.cli;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationWarnings;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.calibrate.ResultFiles;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.PublishWords;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.fit.CameraNoise;
import fieldcal.fit.Estimate;
import fieldcal.fit.JointFit;
import fieldcal.kick.KickKind;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Prints a calibration for the operator's terminal. */
final class CalibrationText {
  private static final String LEGEND =
      "n: kicks whose value is in the mean. A kick is used if at least one of its values is in a"
          + " mean. The joint fit also uses kicks whose values are excluded.";

  private final PrintWriter out;

  CalibrationText(PrintWriter out) {
    this.out = out;
  }

  void print(CalibrationOutcome outcome, Path directory) {
    verdict(PublishWords.of(outcome.verdict()));
    details(outcome, directory);
  }

  /** All that stands below the verdict. */
  void details(CalibrationOutcome outcome, Path directory) {
    Calibration calibration = outcome.calibration();
    boolean shown = false;
    for (KickKind kind : KickKind.values()) {
      if (outcome.shows(kind)) {
        model(outcome, kind);
        shown = true;
      }
    }
    if (shown) {
      String one =
          calibration
              .joint()
              .map(
                  j ->
                      String.format(
                          Locale.ROOT,
                          " One model for all kicks leaves %.2f mm rms per axis.",
                          j.oneModel().rmsMm()))
              .orElse("");
      new WrappedText(out).print("", "", LEGEND + one);
      line("");
    }
    cameras(outcome);
    List<String> warnings = new CalibrationWarnings(outcome).list();
    if (!warnings.isEmpty()) {
      line("%nAlso:");
      warnings.forEach(w -> wrapped("  ", w));
    }
    rejected(calibration);
    if (!outcome.data().problems().isEmpty()) {
      line("%nIn the data:");
      for (DataProblem p : DataProblem.folded(outcome.data().problems())) {
        wrapped("  ", p.toString());
      }
    }
    line("%nseed %d", calibration.seed());
    if (directory != null) {
      line("report: %s", directory.resolve("report.html"));
    }
    ResultFiles.DIAGNOSIS
        .ofOthers(directory, MadeFrom.of(outcome))
        .ifPresent(others -> wrapped("", others));
    out.flush();
  }

  /** The decision in the first line, then why, then what to do. */
  void verdict(PublishWords words) {
    new WrappedText(out).print("", "", words.headline());
    words.reasons().forEach(reason -> wrapped("  ! ", reason));
    words.notes().forEach(note -> wrapped("  - ", note));
    words.toDo().stream().skip(1).forEach(next -> wrapped("  > ", next));
    line("");
  }

  /** The lines that follow the first are indented by four columns, so that each item is seen to begin. */
  private void wrapped(String first, String text) {
    new WrappedText(out).print(first, "    ", text);
  }

  private void line(String format, Object... args) {
    out.println(String.format(Locale.ROOT, format, args));
  }

  private void model(CalibrationOutcome outcome, KickKind kind) {
    Calibration calibration = outcome.calibration();
    boolean flat = kind == KickKind.FLAT;
    List<CalibratedKick> kicks = calibration.kicks(kind);
    long used = kicks.stream().filter(CalibratedKick::selected).count();
    new WrappedText(out)
        .print(
            "",
            "    ",
            String.format(
                    Locale.ROOT,
                    "%s model: %d of %d %s used.",
                    flat ? "Flat" : "Chip",
                    used,
                    kicks.size(),
                    kicks.size() == 1 ? "kick" : "kicks")
                + calibration.joint().map(j -> residuals(j, kind)).orElse(""));
    line("  %-22s %-23s %3s  %-23s %s", "", "mean", "n", "joint fit", "published");
    List<Parameter> names =
        flat ? FlatModel.typical().parameters() : ChipModel.typical().parameters().subList(0, 3);
    Map<String, Average> averages = flat ? calibration.flat() : calibration.chip();
    List<Parameter> published =
        flat
            ? outcome.initial().flat().map(FlatModel::parameters).orElse(List.of())
            : outcome.initial().chip().map(ChipModel::parameters).orElse(List.of());
    for (Parameter p : names) {
      Average a = averages.get(p.name());
      String mean = a.n() == 0 ? "undetermined" : withError(a.mean(), a.standardError());
      String together =
          calibration
              .joint(kind, p.name())
              .filter(Estimate::usable)
              .map(e -> withError(e.value(), e.standardError()))
              .orElse("undetermined");
      line(
          "  %-22s %-23s %3d  %-23s %s",
          ParameterWords.inFiles(p.name()) + (p.unit().isEmpty() ? "" : ", " + p.unit()),
          mean,
          a.n(),
          together,
          compared(published, p.name(), a));
    }
    line("");
  }

  private static String residuals(JointFit joint, KickKind kind) {
    double rms = kind == KickKind.FLAT ? joint.rmsFlatMm() : joint.rmsChipMm();
    return Double.isNaN(rms)
        ? ""
        : String.format(
            Locale.ROOT,
            " Joint fit: %.2f mm rms per axis, with values of its own for each kick.",
            rms);
  }

  /** With as many decimals as show two digits of the error, at least four. An error that is not known is no error of zero. */
  static String withError(double value, double error) {
    if (!(error > 0)) {
      return Amount.minus(String.format(Locale.ROOT, "%9.4f, error unknown", value));
    }
    int decimals = Math.min(7, Math.max(4, 1 - (int) Math.floor(Math.log10(error))));
    return Amount.minus(
        String.format(Locale.ROOT, "%9." + decimals + "f ± %." + decimals + "f", value, error));
  }

  private static String compared(List<Parameter> published, String name, Average a) {
    return published.stream()
        .filter(p -> p.name().equals(name))
        .map(
            p ->
                a.n() == 0
                    ? String.format(Locale.ROOT, "%.4f", p.value())
                    : String.format(
                        Locale.ROOT,
                        "%.4f (%+.1f %%)",
                        p.value(),
                        100 * (a.mean() / p.value() - 1)))
        .map(Amount::minus)
        .findFirst()
        .orElse("-");
  }

  private void cameras(CalibrationOutcome outcome) {
    Calibration calibration = outcome.calibration();
    Map<Integer, JointFit.Offset> offsets =
        calibration.joint().map(JointFit::offsets).orElse(Map.of());
    calibration
        .cameras()
        .all()
        .forEach(
            view -> {
              if (!outcome.sawKicks(view.id())) {
                line("camera %d: saw no kick", view.id());
                return;
              }
              JointFit.Offset o = offsets.get(view.id());
              boolean known = o != null && Double.isFinite(o.errorX());
              new WrappedText(out)
                  .print(
                      "",
                      "    ",
                      String.format(
                          Locale.ROOT,
                          "camera %d: noise %.2f mm%s%s%s",
                          view.id(),
                          1000 * view.noise(),
                          view.noise() > CameraNoise.FLOOR ? "" : " (the least that is assumed)",
                          known
                              ? Amount.minus(
                                  String.format(
                                      Locale.ROOT,
                                      ", offset x %+.2f ± %.2f mm, y %+.2f ± %.2f mm (taken out)",
                                      hundredths(1000 * o.x()),
                                      1000 * o.errorX(),
                                      hundredths(1000 * o.y()),
                                      1000 * o.errorY()))
                              : "",
                          view.camera()
                              .map(
                                  c -> c.hasPixels() ? "" : "; only its published position is used")
                              .orElse("; no geometry")));
            });
  }

  /** The file of another recording would go unnoticed: the command is only stored beside its kick. */
  void commands(CalibrationOutcome outcome, Path file) {
    if (!outcome.data().kicks().isEmpty()
        && outcome.data().kicks().stream().allMatch(k -> outcome.command(k).isEmpty())) {
      line(
          "%nNone of the %d commands in %s belongs to a kick of these recordings. Is it the file of"
              + " another recording, or do the clocks differ?",
          outcome.commands().size(), file);
      out.flush();
    }
  }

  /** No negative zero. */
  private static double hundredths(double value) {
    return Math.rint(100 * value) / 100 + 0.0;
  }

  private void rejected(Calibration calibration) {
    List<CalibratedKick> out = calibration.kicks().stream().filter(k -> !k.selected()).toList();
    if (!out.isEmpty()) {
      line("%nKicks not used:");
      out.forEach(
          k ->
              wrapped(
                  "  ",
                  String.format(
                      Locale.ROOT,
                      "%d (%s): %s",
                      k.fit().kick().id(),
                      k.fit().kind().id(),
                      k.rejected().map(ParameterWords::spelledOut).orElse(""))));
    }
  }
}
