package fieldcal.archive.table;

import static fieldcal.archive.table.ColumnType.BOOLEAN;
import static fieldcal.archive.table.ColumnType.DOUBLE;
import static fieldcal.archive.table.ColumnType.INT;
import static fieldcal.archive.table.ColumnType.INTS;
import static fieldcal.archive.table.ColumnType.LONG;
import static fieldcal.archive.table.ColumnType.TEXT;
import static fieldcal.archive.table.ColumnType.TIME;

import java.util.List;
import java.util.stream.Stream;

/** Which tables the archive has. SI units; angles in radians; instants in UTC. {@code docs/archive.md} lists the same columns, and a test compares. */
public final class Tables {
  private static final String COLOUR = "colour";
  private static final String LOG_MEANING =
      "content of the log: the first 16 hexadecimal digits of its SHA-256";

  private Tables() {}

  /** One row for each kick that was found. */
  public static final Table KICKS = kicks();

  /** One row for each match. */
  public static final Table MATCHES = matches();

  /** One row for each camera of each match. */
  public static final Table CAMERAS = cameras();

  /** One row for each quantity of each team or robot of each match. */
  public static final Table ROBOTS = robots();

  /** One row for each cell that counted something. */
  public static final Table LIMITS_HISTOGRAMS = limitsHistograms();

  /** One row for each tracker that sent frames. */
  public static final Table TRACKERS = trackers();

  /** One row for each thing that was wrong. */
  public static final Table PROBLEMS = problems();

  /** One row for each parameter of each carpet. */
  public static final Table CARPETS = carpets();

  /** One row for each change at a venue. */
  public static final Table CHANGES = changes();

  /** One row for each quantity of each team in each tournament. */
  public static final Table TEAMS = teams();

  /** Those with files for each match. */
  public static final List<Table> OF_MATCHES =
      List.of(KICKS, MATCHES, CAMERAS, ROBOTS, LIMITS_HISTOGRAMS, TRACKERS, PROBLEMS);

  /** What follows from all matches together, one file each. */
  public static final List<Table> OF_ALL = List.of(CARPETS, CHANGES, TEAMS);

  /** All of them. */
  public static final List<Table> ALL =
      Stream.concat(OF_MATCHES.stream(), OF_ALL.stream()).toList();

  private static Table.Builder table(String name, String meaning) {
    return new Table.Builder(name, meaning).always(TEXT, "log", "", LOG_MEANING);
  }

  private static Table.Builder model(Table.Builder builder) {
    return builder
        .estimate("acc_slide", "m/s²", "acceleration while sliding, negative")
        .estimate("acc_roll", "m/s²", "acceleration while rolling, negative")
        .estimate("k_switch", "", "speed at the start of rolling as a fraction of the kick's")
        .estimate("damping_xy_first_hop", "", "horizontal damping at the first impact")
        .estimate("damping_xy_other_hops", "", "horizontal damping at later impacts")
        .estimate("damping_z", "", "vertical damping at an impact");
  }

  private static Table kicks() {
    Table.Builder kicks =
        table("kicks", "A kick that was found.")
            .always(INT, "kick", "", "running number within the log, from 1")
            .always(TIME, "time", "", "when the ball was kicked")
            .maybe(TEXT, "team", "", "name of the kicker's team, from the referee's messages")
            .maybe(TEXT, COLOUR, "", "yellow or blue; missing when no robot was near enough")
            .maybe(INT, "robot", "", "number of the kicker")
            .maybe(TEXT, "kind", "", "flat or chip; missing when the kick could not be fitted")
            .always(DOUBLE, "x", "m", "where the ball was kicked")
            .always(DOUBLE, "y", "m", "where the ball was kicked")
            .estimate("speed", "m/s", "right after the kick, the vertical part of a chip included")
            .maybe(DOUBLE, "direction", "rad", "in the plane, from x towards y")
            .maybe(DOUBLE, "elevation", "rad", "above the plane; 0 for a flat kick")
            .always(TEXT, "end", "", "stopped, left_field, touched_robot, lost or recording_ended")
            .always(DOUBLE, "duration", "s", "from the kick to the end of its observations")
            .always(BOOLEAN, "from_rest", "", "whether the ball lay still before")
            .always(BOOLEAN, "may_spin", "", "whether the ball was dribbled before")
            .always(
                INTS,
                "cameras",
                "",
                "ids of the cameras that saw it, ascending; an id of 100 or more is a camera that"
                    + " was calibrated again during the match")
            .always(INT, "observations", "", "detections of its ball")
            .always(INT, "used", "", "detections that the fit used")
            .maybe(DOUBLE, "rms_mm", "mm", "residual per axis")
            .always(
                BOOLEAN,
                "trusted",
                "",
                "whether its fit is believed as a whole: not when it failed, is 3 times worse than"
                    + " the others of its kind, or leaves out more than 25 % of the detections")
            .always(
                BOOLEAN, "selected", "", "whether a parameter of it enters the model of the match")
            .maybe(TEXT, "not_used_because", "", "why no parameter does");
    return model(kicks)
        .maybe(
            DOUBLE,
            "published_error_1s",
            "m",
            "distance between the ball 1 s after a flat kick and where the published model says"
                + " that it is; missing for chips, shorter kicks, and without a published model")
        .build();
  }

  private static Table matches() {
    Table.Builder matches =
        table("matches", "A game log that could be read.")
            .always(TEXT, "file", "", "name of the log's file")
            .always(TEXT, "origin", "", "field, or simulation where the log says so")
            .always(TIME, "start", "", "when the first message was received")
            .always(DOUBLE, "duration", "s", "from the first message to the last")
            .always(DOUBLE, "playing", "s", "how long the referee let the match run")
            .maybe(TEXT, "yellow", "", "name of the yellow team, from the referee's messages")
            .maybe(TEXT, "blue", "", "name of the blue team, from the referee's messages")
            .maybe(INT, "score_yellow", "", "goals of yellow at the end")
            .maybe(INT, "score_blue", "", "goals of blue at the end")
            .maybe(TEXT, "stage", "", "last stage of the match, as in SSL_Referee")
            .maybe(DOUBLE, "field_length", "m", "as published")
            .maybe(DOUBLE, "field_width", "m", "as published")
            .maybe(
                TEXT,
                "geometry",
                "",
                "fingerprint of field size and camera calibrations: equal for the same geometry")
            .maybe(
                TEXT,
                "venue",
                "",
                "which field, counted by the first match on it; missing without a geometry")
            .maybe(
                TEXT,
                "carpet",
                "",
                "which stretch of matches with the same carpet and kind of ball; missing without a"
                    + " venue");
    for (String name : List.of("acc_slide", "acc_roll")) {
      matches.maybe(DOUBLE, "published_" + name, "m/s²", "of the model that vision published");
    }
    for (String name :
        List.of("k_switch", "damping_xy_first_hop", "damping_xy_other_hops", "damping_z")) {
      matches.maybe(DOUBLE, "published_" + name, "", "of the model that vision published");
    }
    return model(matches)
        .always(INT, "kicks", "", "kicks that were found")
        .always(INT, "flat_kicks", "", "flat kicks that enter the model")
        .always(INT, "chips", "", "chips that enter the model")
        .maybe(
            DOUBLE,
            "published_error_1s",
            "m",
            "root mean square of the kicks' published_error_1s, of kicks whose fit is trusted")
        .maybe(DOUBLE, "rms_mm", "mm", "residual per axis of all kicks together")
        .maybe(DOUBLE, "robot_noise", "m", "noise of one coordinate of a driving robot's position")
        .maybe(
            DOUBLE,
            "robot_noise_standing",
            "m",
            "the same of robots that stand while the referee says halt")
        .always(LONG, "frames", "", "frames of all cameras")
        .always(LONG, "file_bytes", "bytes", "size of the log's file")
        .always(INT, "problems", "", "rows in problems")
        .build();
  }

  private static Table cameras() {
    return table("cameras", "A camera of a match.")
        .always(INT, "camera", "", "its id")
        .always(LONG, "frames", "", "frames that it sent, without duplicates")
        .maybe(DOUBLE, "rate", "Hz", "frames per second outside of gaps")
        .always(LONG, "lost", "", "frames that are missing by their numbers, outside of gaps")
        .always(LONG, "gaps", "", "how often it was silent for more than 0.5 s")
        .always(DOUBLE, "longest_gap", "s", "0 without gaps")
        .maybe(DOUBLE, "jitter", "s", "standard deviation of the capture times about an even pace")
        .maybe(
            DOUBLE,
            "latency",
            "s",
            "median delay from capture to reception; missing where the clocks differ by more")
        .maybe(DOUBLE, "clock_difference", "s", "mean of reception minus capture")
        .maybe(
            DOUBLE, "clock_rate", "", "seconds of the recorder's clock per second of the camera's")
        .always(LONG, "ball_detections", "", "balls that it reported, false ones included")
        .always(LONG, "robot_detections", "", "robots that it reported")
        .maybe(DOUBLE, "ball_noise", "m", "standard deviation per axis of a resting ball")
        .estimate(
            "offset_x", "m", "what it adds to every position, relative to the mean of all cameras")
        .estimate(
            "offset_y", "m", "what it adds to every position, relative to the mean of all cameras")
        .maybe(DOUBLE, "x", "m", "where it hangs, as published")
        .maybe(DOUBLE, "y", "m", "where it hangs, as published")
        .maybe(DOUBLE, "height", "m", "how high it hangs above the carpet, as published")
        .maybe(DOUBLE, "focal_length", "pixels", "as published")
        .maybe(DOUBLE, "distortion", "", "radial distortion, as published")
        .maybe(INT, "lens_sign", "", "−1, 0 or 1: the sign of the distortion; some tools drop it")
        .maybe(TEXT, "calibration", "", "fingerprint of its calibration: equal for the same one")
        .build();
  }

  private static Table robots() {
    return table("robots", "A quantity of a team or of one robot in a match.")
        .always(TEXT, COLOUR, "", "yellow or blue")
        .maybe(TEXT, "team", "", "name of the team, from the referee's messages")
        .maybe(INT, "robot", "", "number of the robot; missing for all robots of the team together")
        .always(
            TEXT,
            "quantity",
            "",
            "velocity_max, acceleration_max, braking_max, the same with angular_ before them (of"
                + " turning) or league_ (the league's estimate), torque_limited, directional,"
                + " acceleration_by_direction, braking_by_direction, speed_cap, or"
                + " robot_acceleration and robot_braking of a robot that differs from its team"
                + " mates")
        .maybe(
            DOUBLE,
            "direction",
            "rad",
            "of a limit by direction: from the robot's front to the left; missing for others")
        .maybe(
            DOUBLE, "value", "m/s, m/s², rad/s, rad/s² or none", "missing when it is undetermined")
        .maybe(DOUBLE, "standard_error", "as value", "missing when it is unknown")
        .always(LONG, "samples", "", "observations that it is based on")
        .maybe(
            BOOLEAN,
            "reached",
            "",
            "false when the robots were never seen at the limit: then the value is a lower bound;"
                + " missing where it has no meaning")
        .maybe(
            TEXT,
            "note",
            "",
            "why it is undetermined or only a bound; for an effect where it was seen")
        .build();
  }

  private static Table trackers() {
    return table(
            "trackers",
            "What a tracker of a team or of an automatic referee reports of the ball, compared with"
                + " the fits of the kicks.")
        .always(TEXT, "source", "", "what the tracker calls itself; may be empty")
        .always(TEXT, "uuid", "", "distinguishes trackers of the same name")
        .always(LONG, "frames", "", "frames that it sent")
        .always(LONG, "samples", "", "frames with a ball during kicks whose fit is trusted")
        .maybe(DOUBLE, "delay", "s", "by how much its ball lags behind on the path, median")
        .maybe(
            DOUBLE,
            "position_error",
            "m",
            "root mean square distance of its ball from the fits, in the plane")
        .maybe(DOUBLE, "position_error_without_delay", "m", "the same with the delay taken out")
        .maybe(
            DOUBLE,
            "velocity_error",
            "m/s",
            "root mean square difference of its ball's velocity from the fits, in the plane")
        .always(INT, "kicks", "", "kicks that it reports")
        .always(INT, "matched", "", "kicks whose fit is trusted and that it reports")
        .always(INT, "missed", "", "kicks whose fit is trusted and that it does not report")
        .always(INT, "invented", "", "kicks that it reports but the detections do not show")
        .maybe(
            DOUBLE,
            "speed_bias",
            "m/s",
            "mean difference: the speed that it reports last minus that of the fit")
        .maybe(DOUBLE, "speed_scatter", "m/s", "standard deviation of this difference")
        .always(
            INT,
            "stops",
            "",
            "matched kicks whose ball stopped, and whose resting place and time it reports 0.3 s"
                + " after the kick")
        .maybe(
            DOUBLE,
            "stop_position_error",
            "m",
            "root mean square distance of the reported resting place from where the fit's ball"
                + " stops")
        .maybe(
            DOUBLE,
            "stop_time_error",
            "s",
            "root mean square difference of the reported time of rest from when the fit's ball"
                + " stops")
        .build();
  }

  private static Table limitsHistograms() {
    return table(
            "limits_histograms",
            "A cell of a histogram of movements, if it is not empty. Counts of several matches"
                + " add up, and limits can be estimated from the sums.")
        .maybe(TEXT, COLOUR, "", "yellow or blue; missing for what both teams share")
        .maybe(TEXT, "team", "", "name of the team, from the referee's messages")
        .always(TEXT, "histogram", "", "which histogram")
        .maybe(INT, "robot", "", "number of the robot, for histograms of each robot")
        .always(INT, "cell", "", "number of the cell; one beyond the last for all that lay outside")
        .maybe(DOUBLE, "x", "of the histogram", "centre of the cell")
        .maybe(
            DOUBLE,
            "y",
            "of the histogram",
            "centre of the cell; missing for histograms of one dimension")
        .always(LONG, "count", "", "how much the cell has counted")
        .build();
  }

  private static Table problems() {
    return new Table.Builder("problems", "Something that was wrong with a log.")
        .maybe(TEXT, "log", "", LOG_MEANING + "; missing when it cannot be opened at all")
        .always(TEXT, "file", "", "name of the log's file")
        .always(
            BOOLEAN,
            "fatal",
            "",
            "whether the log could not be read: then it has no row in any other table")
        .always(TEXT, "place", "", "where in the log; the file's name for all of it")
        .always(TEXT, "what", "", "what was wrong")
        .always(LONG, "count", "", "how often")
        .maybe(TEXT, "advice", "", "what it means, or what to do")
        .build();
  }

  private static Table carpets() {
    return new Table.Builder(
            "carpets", "A parameter of one carpet and ball, pooled over the matches on it.")
        .always(TEXT, "venue", "", "as in matches")
        .always(TEXT, "carpet", "", "as in matches")
        .always(TIME, "first", "", "start of the first match on it")
        .always(TIME, "last", "", "start of the last match on it")
        .always(TEXT, "parameter", "", "as in the columns of matches")
        .always(INT, "matches", "", "matches that determine it")
        .always(DOUBLE, "value", "of the parameter", "mean over the matches, weighted")
        .always(
            DOUBLE, "standard_error", "as value", "of the mean, scatter between matches included")
        .always(
            DOUBLE, "scatter", "as value", "standard deviation between matches beyond their errors")
        .maybe(
            DOUBLE,
            "drift",
            "as value, per day",
            "slope over time; missing with fewer than four matches")
        .maybe(DOUBLE, "drift_error", "as drift", "standard error of drift")
        .maybe(DOUBLE, "published", "as value", "median of what vision published")
        .build();
  }

  private static Table changes() {
    return new Table.Builder("changes", "Something that changed at a venue between two matches.")
        .always(TEXT, "venue", "", "as in matches")
        .always(TEXT, "kind", "", "carpet_or_ball, ball, drift, camera_calibrated or camera_moved")
        .maybe(
            INT,
            "camera",
            "",
            "id of the camera; missing if all changed at once, where it is not known which one"
                + " moved, and for a carpet or ball")
        .always(TIME, "after", "", "end of the last match before the change")
        .always(TIME, "before", "", "start of the first match after the change")
        .always(TEXT, "last_match", "", "log of the last match before the change")
        .always(TEXT, "next_match", "", "log of the first match after the change")
        .always(TEXT, "what", "", "in words, with numbers")
        .maybe(
            DOUBLE,
            "sigmas",
            "",
            "how many standard errors the largest of these differences is; missing for"
                + " calibrations, which are certain")
        .build();
  }

  private static Table teams() {
    return new Table.Builder(
            "teams",
            "A quantity of a team in a tournament, from the histograms of all its matches"
                + " together.")
        .always(TEXT, "tournament", "", "as in the folders")
        .always(TEXT, "team", "", "name of the team, from the referee's messages")
        .maybe(INT, "robot", "", "number of the robot; missing for all robots of the team together")
        .always(TEXT, "quantity", "", "as in robots")
        .maybe(DOUBLE, "direction", "rad", "as in robots")
        .maybe(
            DOUBLE, "value", "m/s, m/s², rad/s, rad/s² or none", "missing when it is undetermined")
        .maybe(DOUBLE, "standard_error", "as value", "missing when it is unknown")
        .always(LONG, "samples", "", "observations that it is based on")
        .maybe(BOOLEAN, "reached", "", "as in robots")
        .maybe(TEXT, "note", "", "as in robots")
        .always(INT, "matches", "", "matches of the team in the tournament")
        .build();
  }
}
