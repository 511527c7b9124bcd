package fieldcal.archive.match;

import fieldcal.app.recording.DataProblem;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Table;
import fieldcal.archive.table.Tables;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.fit.JointFit;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.RefereeStatistics;
import fieldcal.kick.KickKind;
import fieldcal.vision.BallModels;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.Team;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What a match is in the tables. */
public final class MatchTables {
  private final String log;
  private final MatchData match;

  private MatchTables(String log, MatchData match) {
    this.log = log;
    this.match = match;
  }

  /**
   * The rows of a log that was read.
   *
   * @param log its fingerprint
   * @param match what it holds
   * @return the rows of every table; of the table matches one, whose venue and carpet are missing: one match does not know them
   */
  public static Map<Table, List<Row>> of(String log, MatchData match) {
    MatchTables tables = new MatchTables(log, match);
    RobotRows robots = new RobotRows(log, match);
    Map<Table, List<Row>> rows = new LinkedHashMap<>();
    List<Row> problems = tables.problems();
    rows.put(Tables.KICKS, new KickRows(log, match).rows());
    rows.put(Tables.MATCHES, List.of(tables.match(problems.size())));
    rows.put(Tables.CAMERAS, tables.cameras());
    rows.put(Tables.ROBOTS, robots.robots());
    rows.put(Tables.LIMITS_HISTOGRAMS, robots.histograms());
    rows.put(Tables.TRACKERS, TrackerRows.of(log, match));
    rows.put(Tables.PROBLEMS, problems);
    return rows;
  }

  /**
   * The row of a log that could not be read.
   *
   * @param log its fingerprint; null when it cannot be opened
   * @param file the log
   * @param why in words
   * @return a row of the table problems
   */
  public static Row broken(String log, Path file, String why) {
    String name = file.getFileName().toString();
    return Tables.PROBLEMS
        .row()
        .set("log", log)
        .set("file", name)
        .set("fatal", true)
        .set("place", name)
        .set("what", withoutFolder(file, why))
        .set("count", 1L);
  }

  /** The tables hold the file's name alone: the same logs in another folder give the same tables. */
  private static String withoutFolder(Path file, String text) {
    String name = file.getFileName().toString();
    String plain = text == null ? "" : text.replace(file.toString(), name);
    return plain.startsWith(name + ": ") ? plain.substring(name.length() + 2) : plain;
  }

  private List<Row> problems() {
    List<Row> rows = new ArrayList<>();
    String name = match.file().getFileName().toString();
    for (DataProblem problem : match.data().problems()) {
      rows.add(
          Tables.PROBLEMS
              .row()
              .set("log", log)
              .set("file", name)
              .set("fatal", false)
              .set("place", problem.where().replace(match.file().toString(), name))
              .set("what", problem.what())
              .set("count", problem.count())
              .set("advice", problem.advice().isEmpty() ? null : problem.advice()));
    }
    return rows;
  }

  private Row match(int problems) {
    RecordingFacts facts = match.data().recordings().get(0);
    Optional<FieldGeometry> geometry = match.data().geometry();
    Row row =
        Tables.MATCHES
            .row()
            .set("log", log)
            .set("file", match.file().getFileName().toString())
            .set("origin", facts.isSimulated() ? "simulation" : "field")
            .set("start", Math.floorDiv(facts.startUnixNanos(), 1000))
            .set("duration", match.data().duration())
            .set("playing", facts.playing())
            .set("yellow", match.teams().get(Team.YELLOW))
            .set("blue", match.teams().get(Team.BLUE))
            .set("score_yellow", match.referee().map(r -> r.last().yellow().score()))
            .set("score_blue", match.referee().map(r -> r.last().blue().score()))
            .set("stage", match.referee().map(MatchTables::lastStage))
            .set("field_length", geometry.map(FieldGeometry::length))
            .set("field_width", geometry.map(FieldGeometry::width))
            .set("geometry", geometry.map(Fingerprint::of));
    published(row, match.data().published());
    model(row, match.calibration().flat());
    model(row, match.calibration().chip());
    return row.set("kicks", match.calibration().kicks().size())
        .set("flat_kicks", selected(KickKind.FLAT))
        .set("chips", selected(KickKind.CHIP))
        .set("published_error_1s", KickRows.publishedErrorOfAll(match))
        .set("rms_mm", match.calibration().joint().map(JointFit::rmsMm))
        .set("robot_noise", match.movement().noiseKnown() ? match.movement().noise() : null)
        .set("robot_noise_standing", match.movement().statistics().standingNoiseMm() / 1000)
        .set("frames", match.frames())
        .set("file_bytes", match.bytes())
        .set("problems", problems);
  }

  private static String lastStage(RefereeStatistics referee) {
    return referee.last().stage().name();
  }

  private int selected(KickKind kind) {
    return (int) match.calibration().kicks(kind).stream().filter(CalibratedKick::selected).count();
  }

  private static void published(Row row, BallModels models) {
    models
        .flat()
        .ifPresent(
            flat ->
                row.set("published_acc_slide", flat.accSlide())
                    .set("published_acc_roll", flat.accRoll())
                    .set("published_k_switch", flat.kSwitch()));
    models
        .chip()
        .ifPresent(
            chip ->
                row.set("published_damping_xy_first_hop", chip.dampingXyFirstHop())
                    .set("published_damping_xy_other_hops", chip.dampingXyOtherHops())
                    .set("published_damping_z", chip.dampingZ()));
  }

  private static void model(Row row, Map<String, Average> averages) {
    averages.forEach(
        (parameter, average) -> {
          String name = KickRows.column(parameter);
          if (average.n() > 0) {
            row.set(name, average.mean()).set(name + "_error", average.standardError());
          }
        });
  }

  private List<Row> cameras() {
    List<Row> rows = new ArrayList<>();
    for (CameraStatistics camera : match.cameras()) {
      Row row =
          Tables.CAMERAS
              .row()
              .set("log", log)
              .set("camera", camera.id())
              .set("frames", camera.frames())
              .set("rate", camera.rate())
              .set("lost", camera.lostFrames())
              .set("gaps", camera.gaps())
              .set("longest_gap", camera.longestGap())
              .set("jitter", camera.jitter())
              .set("latency", camera.latency())
              .set("clock_difference", camera.clockDifference())
              .set("clock_rate", camera.clockRate())
              .set("ball_detections", camera.ballDetections())
              .set("robot_detections", camera.robotDetections())
              .set("ball_noise", camera.ballNoise());
      match
          .calibration()
          .joint()
          .map(joint -> joint.offsets().get(camera.id()))
          .ifPresent(
              offset ->
                  row.set("offset_x", offset.x())
                      .set("offset_x_error", offset.errorX())
                      .set("offset_y", offset.y())
                      .set("offset_y_error", offset.errorY()));
      match
          .data()
          .geometry()
          .flatMap(geometry -> geometry.camera(camera.id()))
          .ifPresent(calibration -> pose(row, calibration));
      rows.add(row);
    }
    return rows;
  }

  private static void pose(Row row, CameraCalibration calibration) {
    row.set("focal_length", calibration.focalLength())
        .set("distortion", calibration.distortion())
        .set("lens_sign", (int) Math.signum(calibration.distortion()))
        .set("calibration", Fingerprint.of(calibration));
    try {
      Camera camera = Camera.of(calibration);
      row.set("x", camera.positionX())
          .set("y", camera.positionY())
          .set("height", camera.positionZ());
    } catch (IllegalArgumentException unusable) {
      // Neither pose nor position can be right; the problem of the log says so, the row has none.
      row.set("x", null).set("y", null).set("height", null);
    }
  }
}
