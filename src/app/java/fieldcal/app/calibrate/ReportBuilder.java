package fieldcal.app.calibrate;

import fieldcal.app.recording.CameraStream;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.report.CalibrationReport;
import fieldcal.app.report.Field;
import fieldcal.app.report.Problem;
import fieldcal.app.report.Provenance;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.PublishWords;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.fit.CameraView;
import fieldcal.fit.Estimate;
import fieldcal.fit.JointFit;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Turns a calibration into what the report shows. Immutable. */
public final class ReportBuilder {
  private static final String ROLL = ParameterWords.of("accRoll");

  private final CalibrationOutcome outcome;
  private final Calibration calibration;

  /**
   * A builder for one calibration.
   *
   * @param outcome what to show
   */
  public ReportBuilder(CalibrationOutcome outcome) {
    this.outcome = outcome;
    calibration = outcome.calibration();
  }

  /**
   * Everything.
   *
   * @return what the report shows
   */
  public CalibrationReport build() {
    return build(new KickReportBuilder(outcome)::kick);
  }

  /**
   * Everything but what was seen of each kick: a tenth of a percent of {@link #build}, for a page that asks for the kicks it shows.
   *
   * @return what the report shows, kicks without observations and events, and with a few points of the path alone
   */
  public CalibrationReport overview() {
    return build(new KickReportBuilder(outcome)::outline);
  }

  /**
   * All of one kick.
   *
   * @param id its running number
   * @return empty when there is no such kick
   */
  public Optional<CalibrationReport.Kick> kick(int id) {
    return calibration.kicks().stream()
        .filter(k -> k.fit().kick().id() == id)
        .findFirst()
        .map(new KickReportBuilder(outcome)::kick);
  }

  private CalibrationReport build(Function<CalibratedKick, CalibrationReport.Kick> kicks) {
    List<CalibrationReport.Model> models = new ArrayList<>();
    if (outcome.shows(KickKind.FLAT)) {
      models.add(model(KickKind.FLAT));
    }
    if (outcome.shows(KickKind.CHIP)) {
      models.add(model(KickKind.CHIP));
    }
    return new CalibrationReport(
        Provenance.of(
            outcome.logs().stream().map(Object::toString).toList(),
            outcome.data(),
            calibration.seed()),
        models,
        calibration.cameras().all().stream().map(this::camera).toList(),
        outcome.data().geometry().map(Field::of),
        calibration.kicks().stream().map(kicks).toList(),
        PublishWords.of(outcome.verdict()),
        new CalibrationWarnings(outcome).list(),
        DataProblem.folded(outcome.data().problems()).stream().map(Problem::of).toList());
  }

  private CalibrationReport.Model model(KickKind kind) {
    boolean flat = kind == KickKind.FLAT;
    Map<String, Average> averages = flat ? calibration.flat() : calibration.chip();
    List<Parameter> names =
        flat ? FlatModel.typical().parameters() : ChipModel.typical().parameters().subList(0, 3);
    List<CalibrationReport.ModelParameter> parameters = new ArrayList<>();
    for (Parameter p : names) {
      Average a = averages.get(p.name());
      Optional<Estimate> joint = calibration.joint(kind, p.name());
      parameters.add(
          new CalibrationReport.ModelParameter(
              p.name(),
              p.unit(),
              a.mean(),
              a.standardError(),
              a.n(),
              a.scatter(),
              joint.filter(Estimate::usable).map(Estimate::value).orElse(Double.NaN),
              joint.filter(Estimate::usable).map(Estimate::standardError).orElse(Double.NaN),
              published(kind, p.name()),
              ""));
    }
    double rms =
        calibration.joint().map(j -> flat ? j.rmsFlatMm() : j.rmsChipMm()).orElse(Double.NaN);
    return new CalibrationReport.Model(
        flat ? CalibrationReport.Kind.FLAT : CalibrationReport.Kind.CHIP,
        parameters,
        rms,
        flat ? "" : rollNote());
  }

  private String rollNote() {
    Optional<Estimate> roll = calibration.joint(KickKind.CHIP, "accRoll");
    if (roll.isEmpty()) {
      return "";
    }
    Estimate e = roll.get();
    if (!e.parameter().estimated()) {
      return String.format(
              Locale.ROOT, "Chips roll with the %s of the flat kicks, %.4f m/s².", ROLL, e.value())
          .replace('-', '−');
    }
    String why =
        calibration.kicks(KickKind.FLAT).isEmpty()
            ? "There are no flat kicks"
            : "The flat kicks do not determine the " + ROLL;
    return e.usable()
        ? String.format(
                Locale.ROOT,
                "%s; the chips themselves give a %s of %.4f ± %.4f m/s².",
                why,
                ROLL,
                e.value(),
                e.standardError())
            .replace('-', '−')
        : why + ", and the chips do not determine it either.";
  }

  private double published(KickKind kind, String name) {
    List<Parameter> parameters =
        kind == KickKind.FLAT
            ? outcome.initial().flat().map(FlatModel::parameters).orElse(List.of())
            : outcome.initial().chip().map(ChipModel::parameters).orElse(List.of());
    return parameters.stream()
        .filter(p -> p.name().equals(name))
        .mapToDouble(Parameter::value)
        .findFirst()
        .orElse(Double.NaN);
  }

  private CalibrationReport.Camera camera(CameraView view) {
    CameraStream stream = outcome.data().streams().get(view.id());
    long seen = 0;
    for (CalibratedKick kick : calibration.kicks()) {
      Observations observations = kick.fit().kick().observations();
      for (int i = 0; i < observations.size(); i++) {
        seen += observations.camera(i) == view.id() ? 1 : 0;
      }
    }
    JointFit.Offset o =
        calibration
            .joint()
            .map(j -> j.offsets().get(view.id()))
            .filter(f -> Double.isFinite(f.errorX()))
            .orElse(new JointFit.Offset(Double.NaN, Double.NaN, Double.NaN, Double.NaN));
    return new CalibrationReport.Camera(
        view.id(),
        seen > 0 ? 1000 * view.noise() : Double.NaN,
        stream == null ? Double.NaN : stream.rateHz(),
        seen,
        1000 * o.x(),
        1000 * o.errorX(),
        1000 * o.y(),
        1000 * o.errorY(),
        view.camera().map(c -> c.positionX()).orElse(Double.NaN),
        view.camera().map(c -> c.positionY()).orElse(Double.NaN),
        view.camera().map(c -> c.consistency()).orElse("no geometry published for this camera"));
  }
}
