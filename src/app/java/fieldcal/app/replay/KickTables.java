package fieldcal.app.replay;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CommandFile.Command;
import fieldcal.app.files.WholeFile;
import fieldcal.ball.BallState;
import fieldcal.calibration.CalibratedKick;
import fieldcal.fit.CameraView;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * {@code kicks.csv}, one row per kick, and {@code observations.csv}, one row per detection of a ball: in the order of the calibration and of the time, written row by row. {@code docs/export.md}
 * describes every column.
 */
public final class KickTables {
  private static final List<String> PARAMETERS =
      List.of(
          "accSlide", "accRoll", "kSwitch", "dampingXyFirstHop", "dampingXyOtherHops", "dampingZ");

  private final CalibrationOutcome outcome;
  private final Epoch epoch;

  /**
   * The tables of a calibration.
   *
   * @param outcome the calibration
   */
  public KickTables(CalibrationOutcome outcome) {
    this.outcome = outcome;
    epoch = outcome.data().epoch();
  }

  /**
   * Writes both tables.
   *
   * @param directory made if needed; tables of an earlier run are replaced
   * @throws IOException when one cannot be written; the old one is as it was
   */
  public void write(Path directory) throws IOException {
    WholeFile.stream(directory.resolve("kicks.csv"), this::kicks);
    WholeFile.stream(directory.resolve("observations.csv"), this::observations);
  }

  private void kicks(Writer to) throws IOException {
    CsvRow row = new CsvRow(to);
    for (String name :
        List.of(
            "kick",
            "kind",
            "source",
            "t_unix",
            "team",
            "robot",
            "end",
            "observations",
            "used_observations",
            "rms_mm",
            "x_m",
            "y_m",
            "vx_mps",
            "vy_mps",
            "vz_mps",
            "speed_mps",
            "direction_deg",
            "elevation_deg")) {
      row.text(name);
    }
    for (String name : PARAMETERS) {
      row.text(inFiles(name)).text(inFiles(name) + "_standard_error");
    }
    row.text("selected").text("rejected_because");
    row.text("commanded_speed_mps").text("commanded_direction_deg").text("commanded_elevation_deg");
    row.end();
    for (CalibratedKick kick : outcome.calibration().kicks()) {
      kick(row, kick);
    }
  }

  private void kick(CsvRow row, CalibratedKick calibrated) throws IOException {
    KickFit fit = calibrated.fit();
    Kick kick = fit.kick();
    boolean fitted = fit.failure().isEmpty();
    row.integer(kick.id()).text(fit.kind().id()).text(outcome.data().sources().get(kick.id()));
    row.nanos(epoch.unixNanosOf(start(fit)));
    row.text(kick.robot().map(r -> r.team().name().toLowerCase(Locale.ROOT)));
    row.text(kick.robot().map(r -> Integer.toString(r.number())));
    row.text(kick.end().id()).integer(kick.observations().size());
    row.integer(fitted ? fit.statistics().used() : 0);
    row.number(fitted ? fit.rmsMm() : Double.NaN);
    row.number(fitted ? fit.estimate("x").value() : kick.x());
    row.number(fitted ? fit.estimate("y").value() : kick.y());
    double vx = fitted ? fit.estimate("vx").value() : kick.vx();
    double vy = fitted ? fit.estimate("vy").value() : kick.vy();
    double vz = fitted && fit.kind() == KickKind.CHIP ? fit.estimate("vz").value() : 0;
    double ground = Math.hypot(vx, vy);
    row.number(vx).number(vy).number(vz).number(Math.hypot(ground, vz));
    row.number(Math.toDegrees(Math.atan2(vy, vx))).number(Math.toDegrees(Math.atan2(vz, ground)));
    for (String name : PARAMETERS) {
      Optional<Estimate> e =
          fit.modelEstimates().stream()
              .filter(x -> x.name().equals(name) && x.usable())
              .findFirst();
      row.number(e.map(Estimate::value).orElse(Double.NaN));
      row.number(e.map(Estimate::standardError).orElse(Double.NaN));
    }
    row.flag(calibrated.selected()).text(calibrated.rejected());
    Optional<Command> told = outcome.command(kick);
    row.number(told.map(Command::speed).orElse(Double.NaN));
    row.number(told.map(c -> Math.toDegrees(c.direction())).orElse(Double.NaN));
    row.number(told.map(c -> Math.toDegrees(c.elevation())).orElse(Double.NaN));
    row.end();
  }

  private static String inFiles(String name) {
    return name.replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
  }

  static double start(KickFit fit) {
    return fit.failure().isEmpty() ? fit.estimate("t0").value() : fit.kick().time();
  }

  private void observations(Writer to) throws IOException {
    CsvRow row = new CsvRow(to);
    for (String name :
        List.of(
            "t_unix",
            "kick",
            "t_s",
            "camera",
            "x_m",
            "y_m",
            "offset_x_m",
            "offset_y_m",
            "used",
            "residual_x_mm",
            "residual_y_mm",
            "path_x_m",
            "path_y_m",
            "path_z_m",
            "path_speed_mps")) {
      row.text(name);
    }
    row.end();
    for (CalibratedKick kick : outcome.calibration().kicks()) {
      observations(row, kick.fit());
    }
  }

  private void observations(CsvRow row, KickFit fit) throws IOException {
    Observations seen = fit.kick().observations();
    boolean fitted = fit.failure().isEmpty();
    double start = start(fit);
    for (int i = 0; i < seen.size(); i++) {
      CameraView view = outcome.calibration().cameras().get(seen.camera(i));
      row.nanos(epoch.unixNanosOf(seen.time(i))).integer(fit.kick().id());
      row.number(seen.time(i) - start).integer(seen.camera(i));
      row.number(seen.x(i)).number(seen.y(i)).number(view.offsetX()).number(view.offsetY());
      row.flag(fitted && fit.used(i));
      row.number(fitted ? 1000 * fit.residualX(i) : Double.NaN);
      row.number(fitted ? 1000 * fit.residualY(i) : Double.NaN);
      if (fitted) {
        BallState at = fit.trajectory().stateAt(seen.time(i));
        row.number(at.x()).number(at.y()).number(at.z()).number(at.groundSpeed());
      } else {
        row.number(Double.NaN).number(Double.NaN).number(Double.NaN).number(Double.NaN);
      }
      row.end();
    }
  }
}
