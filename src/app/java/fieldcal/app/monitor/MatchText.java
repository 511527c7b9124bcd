package fieldcal.app.monitor;

import fieldcal.app.limits.LimitWords;
import fieldcal.app.wording.Amount;
import fieldcal.app.wording.Harmless;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.RefereeWords;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.BallParameter;
import fieldcal.live.BallSnapshot;
import fieldcal.live.CameraHealth;
import fieldcal.live.KickCounts;
import fieldcal.live.LimitWarning;
import fieldcal.live.LiveKick;
import fieldcal.live.LiveSnapshot;
import fieldcal.live.LiveWarning;
import fieldcal.live.MovementSnapshot;
import fieldcal.live.ParameterEstimate;
import fieldcal.live.SampleTree;
import fieldcal.movement.Envelope;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.TeamLimits;
import fieldcal.movement.TurnLimits;
import fieldcal.vision.Team;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** A match in lines: what matters most first, tables of at most 80 characters, sentences as wide as wanted. */
final class MatchText {
  /** A smaller error would be shown as 0.00, m/s or m/s². */
  private static final double ROUNDED_TO_NOTHING = 0.005;

  /** Sentences stay in one line, however long. */
  static final int UNBROKEN = Integer.MAX_VALUE;

  /** Characters in a line from which on the table of the ball has room for the middle 50 % of the kicks. */
  private static final int WIDE = 100;

  private static final int NEWEST_KICKS = 3;
  private static final String CONTINUED = " ".repeat(9);
  private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss");

  private final ZoneId zone;

  /** Times of day are told in this zone. */
  MatchText(ZoneId zone) {
    this.zone = zone;
  }

  /** The whole state, sentences broken at a number of characters. */
  List<String> lines(MatchStatus status, int width) {
    LiveSnapshot s = status.snapshot();
    List<String> lines = new ArrayList<>();
    add(lines, "%s  %s", clock(s.time()), status.feed().title());
    sentence(lines, referee(status), width);
    warnings(lines, s, width);
    status.feed().notes().forEach(note -> sentence(lines, note, width));
    ball(lines, s.ball(), width);
    robots(lines, s.movement(), width);
    cameras(lines, s, width);
    kicks(lines, s.ball(), width);
    return lines;
  }

  /** The whole state at the end, and what to do where a match was too short. */
  List<String> summary(MatchStatus status, int width) {
    List<String> lines = lines(status, width);
    String few =
        status.snapshot().ball().parameters().stream()
            .filter(e -> !e.enough())
            .map(e -> words(e.parameter()) + " (" + e.samples() + ")")
            .collect(Collectors.joining(", "));
    if (!few.isEmpty()) {
      lines.add("");
      String pool =
          "Fewer than %d kicks determine the %s. --state FILE keeps them for the next match on this"
              + " carpet.";
      sentence(lines, String.format(Locale.ROOT, pool, SampleTree.ENOUGH, few), width);
    }
    return lines;
  }

  private static void sentence(List<String> lines, String text, int width) {
    String rest = text;
    while (rest.length() > width) {
      int space = rest.lastIndexOf(' ', width);
      if (space <= CONTINUED.length()) {
        break;
      }
      lines.add(rest.substring(0, space).stripTrailing());
      rest = CONTINUED + rest.substring(space).strip();
    }
    lines.add(rest);
  }

  /** A point in time for people. */
  String clock(double unixSeconds) {
    return Double.isFinite(unixSeconds)
        ? CLOCK.format(Instant.ofEpochMilli(Math.round(1000 * unixSeconds)).atZone(zone))
        : "--:--:--";
  }

  private static void add(List<String> lines, String format, Object... args) {
    lines.add(String.format(Locale.ROOT, format, args));
  }

  private static String referee(MatchStatus status) {
    if (status.referee().isEmpty()) {
      return "no referee messages: everything counts, including breaks";
    }
    RefereeState r = status.referee().get();
    String counts =
        status.snapshot().phase().counts() ? "play counts" : "not in play, nothing counts now";
    return String.format(
        Locale.ROOT,
        "%s: %s   %s %d : %d %s",
        RefereeWords.of(r),
        counts,
        name(r.yellow(), Team.YELLOW),
        r.yellow().score(),
        r.blue().score(),
        name(r.blue(), Team.BLUE));
  }

  private static String name(RefereeState.TeamState team, Team colour) {
    return team.name().isBlank() ? colour.label() : Harmless.line(team.name());
  }

  /** As it was when the warning began: a step of the newest kicks may not have moved the median of all yet. */
  private void warnings(List<String> lines, LiveSnapshot s, int width) {
    lines.add("");
    for (LiveWarning w : s.ball().warnings()) {
      warning(lines, w.time(), ParameterWords.spelledOut(w.text()), w.advice(), width);
    }
    for (LimitWarning w : s.movement().warnings()) {
      warning(lines, w.time(), w.text(), w.advice(), width);
    }
  }

  private void warning(List<String> lines, double since, String text, String advice, int width) {
    sentence(lines, "WARNING  since " + clock(since) + ": " + text, width);
    sentence(lines, CONTINUED + advice, width);
  }

  private static void ball(List<String> lines, BallSnapshot ball, int width) {
    KickCounts c = ball.counts();
    lines.add("");
    String aside = c.outsidePlay() > 0 ? ", " + c.outsidePlay() + " outside of play" : "";
    String dropped = c.dropped() > 0 ? ", " + c.dropped() + " dropped" : "";
    add(
        lines,
        "BALL     %d kicks: %d used, %d determine no parameter, %d waiting%s%s",
        c.found(),
        c.used(),
        c.unused(),
        c.waiting(),
        aside,
        dropped);
    add(
        lines,
        "  %-38s %7s %9s %-12s %5s%s",
        "",
        "median",
        "published",
        "measured",
        "kicks",
        width < WIDE ? "" : "    middle 50 %");
    for (ParameterEstimate e : ball.parameters()) {
      lines.add(parameter(e, width));
    }
    if (ball.parameters().stream().anyMatch(ParameterEstimate::maybeSpun)) {
      String spin =
          "  * may have spin: kicked after dribbling or catching; too few other kicks to compare"
              + " with";
      sentence(lines, spin, width);
    }
  }

  private static String parameter(ParameterEstimate e, int width) {
    BallParameter p = e.parameter();
    String within =
        e.samples() < 2 || width < WIDE
            ? ""
            : value(e.lowerQuartile()) + " … " + value(e.upperQuartile());
    return String.format(
            Locale.ROOT,
            "  %-38s %7s %9s %-12s %5s %-2s %s",
            words(p) + (p.unit().isEmpty() ? "" : ", " + p.unit()),
            e.samples() == 0 ? "–" : value(e.median()),
            e.published().map(MatchText::value).orElse("–"),
            e.enough() ? deviation(e) : e.samples() == 0 ? "" : "too few yet",
            e.enough() ? "" + e.samples() : e.samples() + "/" + SampleTree.ENOUGH,
            e.maybeSpun() ? "*" : "",
            within)
        .stripTrailing();
  }

  private static String words(BallParameter p) {
    return ParameterWords.words(p.modelName());
  }

  private static String value(double v) {
    return Amount.minus(String.format(Locale.ROOT, "%.3f", v));
  }

  /** In words: of negative accelerations a sign alone would mislead. */
  static String deviation(ParameterEstimate e) {
    double percent = 100 * e.deviation();
    if (Double.isNaN(percent)) {
      return "";
    }
    if (Math.abs(percent) < 0.5) {
      return "as published";
    }
    return String.format(
        Locale.ROOT, "%.0f %% %s", Math.abs(percent), percent > 0 ? "more" : "less");
  }

  private void robots(List<String> lines, MovementSnapshot movement, int width) {
    lines.add("");
    add(
        lines,
        "%-9s %-20s %-20s %s",
        "ROBOTS",
        "velocity, m/s",
        "acceleration, m/s²",
        "braking, m/s²");
    for (Team team : Team.values()) {
      TeamLimits now = movement.limits().get(team);
      TeamLimits before = movement.beforeBreak().get(team);
      TeamLimits shown = now != null && now.acceleration().known() || before == null ? now : before;
      String since = shown != null && shown == before ? "before the break" : "";
      if (shown == null) {
        add(lines, "  %-7s not measured yet", team.label());
        continue;
      }
      add(
          lines,
          "  %-7s %-20s %-20s %-20s %s",
          team.label(),
          limit(shown.velocity(), shown.leagueVelocity()),
          limit(shown.acceleration(), shown.leagueAcceleration()),
          limit(shown.braking(), shown.leagueBraking()),
          since);
      for (LimitDeviation d : shown.deviations()) {
        String named =
            String.format(
                Locale.ROOT,
                "          %s: %s (%.2f ± %.2f)",
                d.effect().id(),
                d.effect().sentence(),
                d.coefficient(),
                d.standardError());
        sentence(lines, named, width);
      }
      String turning = turning(shown.turning());
      if (!turning.isEmpty()) {
        sentence(lines, "          turning: " + turning, width);
      }
      for (Envelope e : shown.envelopes()) {
        if (e.shaped()) {
          sentence(lines, "          " + LimitWords.sentence(e), width);
        }
      }
      for (RobotDifference r : shown.robots()) {
        sentence(lines, "          " + LimitWords.sentence(r), width);
      }
    }
    String since =
        String.format(
            Locale.ROOT,
            "  since %s%s; in brackets: the league's estimate, which includes noise",
            clock(movement.countingSince()),
            movement.breaks() > 0 ? " (last break)" : "");
    lines.add(since);
  }

  /** What is known of it. */
  private static String turning(TurnLimits limits) {
    List<String> known = new ArrayList<>();
    if (limits.velocity().known()) {
      known.add(limit(limits.velocity()) + " rad/s");
    }
    if (limits.acceleration().known()) {
      known.add("speeding up by " + limit(limits.acceleration()) + " rad/s²");
    }
    if (limits.braking().known()) {
      known.add("slowing down by " + limit(limits.braking()) + " rad/s²");
    }
    return String.join(", ", known);
  }

  private static String limit(LimitEstimate own) {
    return own.known()
        ? String.format(
            Locale.ROOT,
            "%s%.1f ± %.1f",
            own.reached() ? "" : "≥ ",
            own.value(),
            own.standardError())
        : "–";
  }

  private static String limit(LimitEstimate own, LimitEstimate league) {
    String mine =
        own.known()
            ? String.format(
                Locale.ROOT,
                own.standardError() < ROUNDED_TO_NOTHING ? "%s%.3f ± %.3f" : "%s%.2f ± %.2f",
                own.reached() ? "" : "≥ ",
                own.value(),
                own.standardError())
            : "–";
    return league.known() ? String.format(Locale.ROOT, "%s (%.2f)", mine, league.value()) : mine;
  }

  private static void cameras(List<String> lines, LiveSnapshot s, int width) {
    lines.add("");
    add(
        lines,
        "%-11s %8s %10s %18s %8s %10s",
        "CAMERAS",
        "rate",
        "noise",
        "offset x, y",
        "gaps",
        "longest");
    if (s.cameras().isEmpty()) {
      lines.add("  no frame yet");
    }
    for (CameraHealth c : s.cameras()) {
      String silent =
          c.silentFor() > 1 ? String.format(Locale.ROOT, "  SILENT for %.0f s", c.silentFor()) : "";
      String apart =
          c.disagrees()
              ? String.format(
                  Locale.ROOT,
                  "  %.0f mm apart from camera %d",
                  c.apartMm(),
                  c.apartFrom().getAsInt())
              : "";
      String uncalibrated = c.calibrated() ? "" : "  no usable calibration";
      add(
          lines,
          "  %-9d %5s Hz %7s mm %15s mm %8d %10s%s%s%s",
          c.id(),
          number("%.1f", c.rateHz()),
          number("%.2f", c.noiseMm()),
          number("%.1f", c.offsetXMm()) + ", " + number("%.1f", c.offsetYMm()),
          c.gaps(),
          c.gaps() == 0 ? "–" : number("%.2f s", c.longestGap()),
          silent,
          apart,
          uncalibrated);
    }
    for (String fault : CameraFaultText.lines(s.cameraFaults())) {
      sentence(lines, fault(fault), width);
    }
    if (s.strayFrames() > 0 || s.clockJumps() > 0) {
      add(
          lines,
          "  %d frames left out for their time stamps; the clock restarted %d times",
          s.strayFrames(),
          s.clockJumps());
    }
  }

  /** A line of {@link CameraFaultText} as it stands in the state. */
  static String fault(String line) {
    return "  " + line;
  }

  private static String number(String format, double value) {
    // A small negative number would be shown as -0.0.
    String text = String.format(Locale.ROOT, format, value).replaceFirst("^-(0\\.0+)$", "$1");
    return Double.isFinite(value) ? Amount.minus(text) : "–";
  }

  private void kicks(List<String> lines, BallSnapshot ball, int width) {
    List<LiveKick> kicks = ball.kicks();
    if (kicks.isEmpty()) {
      return;
    }
    lines.add("");
    lines.add("LAST KICKS");
    for (int i = kicks.size() - 1; i >= Math.max(0, kicks.size() - NEWEST_KICKS); i--) {
      sentence(lines, "  " + kick(kicks.get(i)), width);
    }
  }

  /** One kick in one line. */
  String kick(LiveKick k) {
    List<String> determined = new ArrayList<>();
    k.samples()
        .forEach((p, s) -> determined.add(ParameterWords.withValue(p.modelName(), s.value())));
    String what = k.unused().orElse(String.join(", ", determined));
    return String.format(
        Locale.ROOT,
        "%s  #%-4d %-4s %4.1f m/s %-9s %s%s",
        clock(k.time()),
        k.id(),
        k.kind().map(kind -> kind.id()).orElse("?"),
        k.speed(),
        k.robot().map(Object::toString).orElse("unknown"),
        what,
        k.possiblySpinning() ? " (may have spin)" : "");
  }
}
