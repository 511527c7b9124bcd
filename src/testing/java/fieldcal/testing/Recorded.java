package fieldcal.testing;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.calibration.Average;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.CalibrationProblem;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.testing.Expectations.Value;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * The kicks of a recording, with assertions that calibration, predictions and diagnosis of them stay as they were. Each assertion compares with lines of a text file, {@code name = value ± tolerance}; run once with {@code
 * -Dfieldcal.accept=true}, it writes them. Calibration and diagnosis are computed once, when first needed. Not thread-safe.
 */
public final class Recorded {
  private static final String ACCEPT = "fieldcal.accept";

  /** Horizons of the predictions, s: those of {@code diagnosis.json}. */
  private static final double[] HORIZONS = {0.5, 1, 2};

  /** Tolerance of a prediction error, as a share of it; chosen, above what a refit on another machine changes. */
  private static final double SHARE = 0.05;

  /** Added to this tolerance, mm: a tenth of a camera's noise. */
  private static final double LEAST_MM = 0.2;

  private final Path recording;
  private final Expectations expectations;
  private final ReadKicks read;
  private Calibration calibration;
  private Diagnosis diagnosis;

  private Recorded(Path recording, Expectations expectations, ReadKicks read) {
    this.recording = recording;
    this.expectations = expectations;
    this.read = read;
  }

  /**
   * Reads a recording.
   *
   * @param recording SSL game log, .log or .log.gz
   * @param expected the file with what is expected; need not be there yet
   * @return its kicks
   * @throws IOException when one of the files cannot be read; one line that names file and place
   */
  public static Recorded read(Path recording, Path expected) throws IOException {
    return new Recorded(recording, Expectations.read(expected), ReadKicks.of(recording));
  }

  static Path expectationsOf(Path recording) {
    String name = recording.getFileName().toString().replaceFirst("\\.log(\\.gz)?$", "");
    return recording.resolveSibling(name + ".expected");
  }

  /**
   * The kicks that were found.
   *
   * @return in order of time
   */
  public List<Kick> kicks() {
    return read.kicks();
  }

  /**
   * The calibration of these kicks, as {@code fieldcal calibrate} makes it.
   *
   * @return models, fits and errors
   */
  public Calibration calibration() {
    if (calibration == null) {
      CalibrationProblem problem =
          new CalibrationProblem(
              read.kicks(),
              read.epoch(),
              read.cameras(),
              read.published().flat().orElse(FlatModel.typical()),
              read.published().chip().orElse(ChipModel.typical()),
              Optional.empty(),
              HandSelection.none());
      calibration = new Calibrator(FitSettings.defaults()).calibrate(problem, kick -> {});
    }
    return calibration;
  }

  /**
   * The diagnosis of these kicks, as {@code fieldcal diagnose} makes it without commands.
   *
   * @return verdict, causes and gains
   * @throws IllegalArgumentException when there are too few kicks
   */
  public Diagnosis diagnosis() {
    if (diagnosis == null) {
      List<KickFit> fits =
          calibration().fitted().stream()
              .filter(f -> f.statistics().used() > 2 * f.estimates().size())
              .toList();
      diagnosis =
          new Diagnoser()
              .diagnose(
                  new DiagnosisProblem(
                      fits,
                      calibration().cameras(),
                      read.observers(),
                      read.sessionStart(),
                      Map.of(),
                      DiagnosisProblem.DEFAULT_MAX_CAUSES,
                      FitSettings.defaults().seed()),
                  text -> {});
    }
    return diagnosis;
  }

  /**
   * The number of kicks and every parameter of the models are as expected. Written with one standard error as tolerance.
   *
   * @throws AssertionError with one line for each value that is not
   */
  public void assertModelsStay() {
    Map<String, Value> now = new TreeMap<>();
    now.put("model.kicks", Value.of(read.kicks().size(), 0));
    calibration().flat().forEach((name, average) -> put(now, "model.flat." + name, average));
    calibration().chip().forEach((name, average) -> put(now, "model.chip." + name, average));
    compare("model.", now);
  }

  private static void put(Map<String, Value> now, String name, Average average) {
    if (average.n() > 0) {
      now.put(
          name,
          Double.isFinite(average.standardError())
              ? Value.of(average.mean(), average.standardError())
              : Value.of("one kick only"));
    }
  }

  /**
   * The calibrated models predict these kicks as well as expected.
   *
   * @throws AssertionError with one line for each horizon at which they do not, better ones included
   */
  public void assertPredictionsStay() {
    Optional<FlatModel> flat = calibration().flatModel();
    double roll = flat.map(FlatModel::accRoll).orElseGet(() -> FlatModel.typical().accRoll());
    Optional<ChipModel> chip = calibration().chipModel(roll);
    assertPredictionsStay(
        "fieldcal",
        (kicked, seconds) -> {
          BallTrajectory path =
              kicked.vz() > 0
                  ? ChipTrajectory.fromKick(
                      chip.orElseGet(ChipModel::typical),
                      0,
                      kicked.x(),
                      kicked.y(),
                      kicked.vx(),
                      kicked.vy(),
                      kicked.vz())
                  : FlatTrajectory.fromKick(
                      flat.orElseGet(FlatModel::typical),
                      0,
                      kicked.x(),
                      kicked.y(),
                      kicked.vx(),
                      kicked.vy());
          BallState then = path.stateAt(seconds);
          return new double[] {then.x(), then.y()};
        });
  }

  /**
   * A team's own code predicts these kicks as well as expected: the root mean square distance, in mm, from each kick's fitted path 0.5, 1 and 2 s after the kick.
   *
   * @param name of the predictor, letters and digits; its lines in the file begin with it
   * @param predictor asked for every kick that was seen at least as long as the horizon
   * @throws AssertionError with one line for each horizon at which it does not, better ones included
   */
  public void assertPredictionsStay(String name, KickPredictor predictor) {
    String prefix = "prediction." + name + ".";
    Map<String, Value> now = new TreeMap<>();
    for (KickKind kind : KickKind.values()) {
      for (double horizon : HORIZONS) {
        double error = predictionErrorMm(kind, horizon, predictor);
        if (!Double.isNaN(error)) {
          String line =
              String.format(
                  Locale.ROOT,
                  "%s%s.%.1f s",
                  prefix,
                  kind.name().toLowerCase(Locale.ROOT),
                  horizon);
          now.put(line, Value.of(error, LEAST_MM + SHARE * error));
        }
      }
    }
    compare(prefix, now);
  }

  private double predictionErrorMm(KickKind kind, double horizon, KickPredictor predictor) {
    double sum = 0;
    int n = 0;
    for (KickFit fit : calibration().trusted()) {
      BallTrajectory path = fit.trajectory();
      double begin = path.kickTime();
      if (fit.kind() != kind || fit.kick().endTime() < begin + horizon) {
        continue;
      }
      BallState truth = path.stateAt(begin + horizon);
      double[] predicted = predictor.after(path.stateAt(begin), horizon);
      sum += Math.pow(predicted[0] - truth.x(), 2) + Math.pow(predicted[1] - truth.y(), 2);
      n++;
    }
    return n == 0 ? Double.NaN : 1000 * Math.sqrt(sum / n);
  }

  /**
   * The verdict and the names of the causes are as expected.
   *
   * @throws AssertionError with one line for each that is not
   */
  public void assertDiagnosisStays() {
    Map<String, Value> now = new TreeMap<>();
    now.put("diagnosis.verdict", Value.of(diagnosis().verdict().id()));
    now.put(
        "diagnosis.causes",
        Value.of(
            diagnosis().causes().stream()
                .map(c -> c.effect().id())
                .sorted()
                .collect(Collectors.joining(", "))));
    compare("diagnosis.", now);
  }

  private void compare(String prefix, Map<String, Value> now) {
    if (Boolean.getBoolean(ACCEPT)) {
      try {
        expectations.accept(prefix, now, recording.getFileName().toString());
      } catch (IOException e) {
        throw new UncheckedIOException(e.getMessage(), e);
      }
      return;
    }
    String how = "run the test once with -D" + ACCEPT + "=true and look at what that changes in ";
    if (!expectations.has(prefix)) {
      throw new AssertionError(
          expectations.file() + " expects nothing of “" + prefix + "…” yet: " + how + "it");
    }
    List<String> lines = expectations.differences(prefix, now);
    if (!lines.isEmpty()) {
      throw new AssertionError(
          recording.getFileName()
              + ": "
              + lines.size()
              + (lines.size() == 1 ? " value is" : " values are")
              + " not as expected:\n"
              + String.join("\n", lines)
              + "\nIf this is wanted, "
              + how
              + expectations.file()
              + ".");
    }
  }
}
