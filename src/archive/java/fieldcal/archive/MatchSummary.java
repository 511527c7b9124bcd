package fieldcal.archive;

import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.archive.venue.CameraFacts;
import fieldcal.archive.venue.MatchFacts;
import fieldcal.archive.venue.Measured;
import fieldcal.archive.venue.VenueStudy;
import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.apache.commons.math3.special.Erf;

/**
 * What the driver keeps of a log: a few kilobytes, however long the match was.
 *
 * @param log the log
 * @param facts of its match; null when it could not be read
 * @param kicks that were found
 * @param teams yellow and blue; null where unknown
 * @param speeds kicks of each team whose fit is trusted, in bins of {@link #BIN}
 * @param fast kicks near the rule's greatest speed, of those whose fit is trusted
 * @param trackers that sent during the match
 * @param problems how often each was found
 * @param fatal why it could not be read; null when it could
 */
record MatchSummary(
    LogFile log,
    MatchFacts facts,
    long kicks,
    List<String> teams,
    Map<String, long[]> speeds,
    List<FastKick> fast,
    List<TrackerFacts> trackers,
    Map<String, Long> problems,
    String fatal)
    implements Serializable {

  /** Width of a bin of speeds, m/s. */
  static final double BIN = 0.25;

  /** Bins of speeds: to 10 m/s, which no kicker reaches; faster ones are in the last. */
  static final int BINS = 40;

  /** Rules of the Small Size League, ball speed: a robot must not kick the ball faster than this, m/s. */
  static final double FASTEST_ALLOWED = 6.5;

  /** A kick may be too fast when it is, or would be with so many standard errors more. */
  private static final double NEAR = 2;

  /** Fits whose speed is less certain do not show whether the rule was kept, m/s. */
  private static final double UNCERTAIN = 0.5;

  static MatchSummary of(LogFile log, ArchiveFolder folder) throws IOException {
    Map<String, Long> problems = new TreeMap<>();
    String fatal = null;
    for (Row row : folder.rows(Tables.PROBLEMS, log)) {
      if ((Boolean) row.get("fatal")) {
        fatal = row.text("what");
      }
      problems.merge(row.text("what").replaceAll(":.*|\\d+(\\.\\d+)?", "").strip(), 1L, Long::sum);
    }
    Optional<Row> match = log.log() == null ? Optional.empty() : folder.match(log);
    if (match.isEmpty()) {
      return new MatchSummary(
          log, null, 0, List.of(), Map.of(), List.of(), List.of(), problems, fatal);
    }
    Map<String, long[]> speeds = new TreeMap<>();
    List<FastKick> fast = new ArrayList<>();
    List<Row> kicks = folder.rows(Tables.KICKS, log);
    for (Row kick : kicks) {
      count(log, match.get(), kick, speeds, fast);
    }
    List<String> teams = new ArrayList<>();
    teams.add(match.get().text("yellow"));
    teams.add(match.get().text("blue"));
    return new MatchSummary(
        log,
        facts(log, match.get(), folder.rows(Tables.CAMERAS, log)),
        kicks.size(),
        teams,
        new HashMap<>(speeds),
        fast,
        new ArrayList<>(
            folder.rows(Tables.TRACKERS, log).stream().map(MatchSummary::tracker).toList()),
        new HashMap<>(problems),
        null);
  }

  private static void count(
      LogFile log, Row match, Row kick, Map<String, long[]> speeds, List<FastKick> fast) {
    if (!(Boolean) kick.get("trusted")) {
      return;
    }
    double speed = kick.number("speed");
    double error = kick.number("speed_error");
    if (!(error < UNCERTAIN)) {
      return;
    }
    String team = kick.text("team");
    speeds
        .computeIfAbsent(team == null ? "" : team, key -> new long[BINS])[
        (int) Math.min(BINS - 1, speed / BIN)]++;
    if (speed + NEAR * error > FASTEST_ALLOWED) {
      double odds = 0.5 * Erf.erfc((FASTEST_ALLOWED - speed) / (error * Math.sqrt(2)));
      Integer robot = (Integer) kick.get("robot");
      fast.add(
          new FastKick(
              log.tournament(),
              log.name(),
              kick.whole("time"),
              team,
              robot == null ? -1 : robot,
              kick.text("kind"),
              speed,
              error,
              odds,
              rolling(match, kick),
              (Boolean) kick.get("may_spin")));
    }
  }

  /** How fast a flat kick is when it begins to roll, m/s, by its own switch to rolling or that of the match; NaN for chips and without either. */
  private static double rolling(Row match, Row kick) {
    double own = kick.number("k_switch");
    double known = Double.isFinite(own) ? own : match.number("k_switch");
    return "flat".equals(kick.text("kind")) ? known * kick.number("speed") : Double.NaN;
  }

  private static TrackerFacts tracker(Row row) {
    return new TrackerFacts(
        row.text("source"),
        Set.of(row.text("log")),
        row.whole("samples"),
        row.number("delay"),
        row.number("position_error_without_delay"),
        row.number("velocity_error"),
        row.whole("kicks"),
        row.whole("matched"),
        row.whole("missed"),
        row.whole("invented"),
        row.number("speed_bias"),
        row.number("speed_scatter"),
        row.whole("stops"),
        row.number("stop_position_error"),
        row.number("stop_time_error"));
  }

  private static MatchFacts facts(LogFile log, Row match, List<Row> cameras) {
    Map<String, Measured> model = new TreeMap<>();
    Map<String, Double> published = new TreeMap<>();
    for (String parameter : VenueStudy.PARAMETERS) {
      Measured measured = measured(match, parameter);
      if (measured.known()) {
        model.put(parameter, measured);
      }
      if (Double.isFinite(match.number("published_" + parameter))) {
        published.put(parameter, match.number("published_" + parameter));
      }
    }
    long start = match.whole("start");
    return new MatchFacts(
        log.log(),
        log.tournament(),
        log.name(),
        start,
        start + Math.round(1e6 * match.number("duration")),
        match.number("field_length"),
        match.number("field_width"),
        match.text("geometry"),
        cameras.stream().map(MatchSummary::camera).toList(),
        model,
        published);
  }

  private static Measured measured(Row row, String column) {
    return new Measured(row.number(column), row.number(column + "_error"));
  }

  private static CameraFacts camera(Row row) {
    double lost = row.whole("lost");
    return new CameraFacts(
        (int) row.whole("camera"),
        row.number("x"),
        row.number("y"),
        row.number("height"),
        row.text("calibration"),
        measured(row, "offset_x"),
        measured(row, "offset_y"),
        row.number("rate"),
        row.number("ball_noise"),
        row.number("jitter"),
        lost / Math.max(1, lost + row.whole("frames")),
        row.whole("gaps"),
        row.number("distortion"));
  }
}
