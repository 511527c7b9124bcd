package fieldcal.app.cli;

import fieldcal.app.limits.LimitWords;
import fieldcal.app.limits.LimitsOutcome;
import fieldcal.app.recording.DataProblem;
import fieldcal.movement.Envelope;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.SpeedCap;
import fieldcal.movement.TeamLimits;
import fieldcal.movement.TurnLimits;
import fieldcal.vision.Team;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Prints movement limits for the terminal. */
final class LimitsText {
  private static final String ROW = "%-8s %-22s %-16s %10s   %s";

  private final PrintWriter out;

  LimitsText(PrintWriter out) {
    this.out = out;
  }

  void print(LimitsOutcome outcome, Path directory) {
    line(ROW, "", "", "limit", "manoeuvres", "league's estimate");
    for (Team team : Team.values()) {
      team(outcome.limits(team));
    }
    line("");
    if (Arrays.stream(Team.values()).anyMatch(team -> hasLeagues(outcome.limits(team)))) {
      sentence("%s", LimitWords.LEAGUES_ESTIMATE);
      line("");
    }
    for (Team team : Team.values()) {
      verdict(outcome.nameOf(team), outcome.limits(team));
    }
    noise(outcome);
    if (!outcome.problems().isEmpty()) {
      line("%nIn the data:");
      for (DataProblem p : outcome.problems()) {
        new WrappedText(out).print("  ", "    ", p.toString());
      }
    }
    if (directory != null) {
      line("%nreport: %s", directory.resolve("limits.html"));
    }
    out.flush();
  }

  private void line(String format, Object... args) {
    out.println(String.format(Locale.ROOT, format, args).stripTrailing());
  }

  private void team(TeamLimits limits) {
    if (isUnseen(limits)) {
      line("%-8s no manoeuvre was seen: no robot drove in play", limits.team().label());
      return;
    }
    row(limits.team().label(), "velocity, m/s", limits.velocity(), limits.leagueVelocity());
    row("", "acceleration, m/s²", limits.acceleration(), limits.leagueAcceleration());
    row("", "braking, m/s²", limits.braking(), limits.leagueBraking());
    TurnLimits turning = limits.turning();
    if (turning.velocity().known() || turning.acceleration().known() || turning.braking().known()) {
      turning("turning, rad/s", turning.velocity());
      turning("  speeding up, rad/s²", turning.acceleration());
      turning("  slowing down, rad/s²", turning.braking());
    } else {
      turning("turning", turning.velocity());
    }
  }

  private static boolean isUnseen(TeamLimits limits) {
    return limits.velocity().samples() == 0
        && limits.acceleration().samples() == 0
        && limits.braking().samples() == 0
        && limits.turning().turns() == 0;
  }

  private static boolean hasLeagues(TeamLimits limits) {
    return limits.leagueVelocity().known()
        || limits.leagueAcceleration().known()
        || limits.leagueBraking().known();
  }

  private void turning(String name, LimitEstimate own) {
    line(ROW, "", name, value(own), own.samples(), "");
    note(own.note());
  }

  private static String value(LimitEstimate own) {
    return own.known()
        ? String.format(
            Locale.ROOT,
            "%s%.3f ± %.3f",
            own.reached() ? "" : "≥ ",
            own.value(),
            own.standardError())
        : "–";
  }

  private void row(String team, String name, LimitEstimate own, LimitEstimate league) {
    String theirs = league.known() ? String.format(Locale.ROOT, "%.2f", league.value()) : "–";
    String note =
        Stream.of(own.note(), league.known() ? "" : "the league's estimate " + league.note())
            .filter(text -> !text.isEmpty())
            .collect(Collectors.joining("; "));
    line(ROW, team, name, value(own), own.samples(), theirs);
    note(note);
  }

  /** Why the row above says so; too long to stand beside it. */
  private void note(String text) {
    if (!text.isEmpty()) {
      line("%-10s%s", "", text);
    }
  }

  private void sentence(String format, Object... args) {
    new WrappedText(out).print("", "  ", String.format(Locale.ROOT, format, args));
  }

  private void verdict(String team, TeamLimits limits) {
    if (isUnseen(limits)) {
      return;
    }
    if (!limits.acceleration().known() && !limits.braking().known()) {
      sentence("%s: its robots were not seen for long enough.", team);
      return;
    }
    for (LimitDeviation d : limits.deviations()) {
      sentence(
          "%s: it %s (%s, coefficient %.3f ± %.3f; seen in %s: %.0f %% of the manoeuvres are at"
              + " the limit with it, %.0f %% without).",
          team,
          LimitWords.sentence(limits, d),
          d.effect().id(),
          d.coefficient(),
          d.standardError(),
          d.seenIn(),
          100 * d.shareAfter(),
          100 * d.shareBefore());
    }
    for (Envelope e : limits.envelopes()) {
      if (!e.points().isEmpty()) {
        sentence(
            "%s: %s%s.",
            team,
            LimitWords.sentence(e),
            e.shaped() ? "; no single limit holds for all directions" : "");
      }
    }
    if (limits.deviations().isEmpty() && limits.envelopes().stream().noneMatch(Envelope::shaped)) {
      sentence("%s: %s.", team, LimitWords.oneLimit(limits));
    }
    for (RobotDifference r : limits.robots()) {
      sentence("%s: %s.", team, LimitWords.sentence(r));
    }
    for (SpeedCap cap : limits.speedCaps()) {
      sentence(
          "%s: robot %d never drives faster than %.2f ± %.2f m/s (%d times at that speed).",
          team, cap.robot(), cap.speed(), cap.standardError(), cap.samples());
    }
  }

  private void noise(LimitsOutcome outcome) {
    if (Double.isFinite(outcome.noiseMm())) {
      String standing =
          Double.isFinite(outcome.statistics().standingNoiseMm())
              ? String.format(
                  Locale.ROOT, ", %.2f mm standing", outcome.statistics().standingNoiseMm())
              : "";
      line("Noise of a robot's position: %.2f mm per axis driving%s.", outcome.noiseMm(), standing);
    }
  }
}
