package fieldcal.app.limits;

import fieldcal.app.report.Problem;
import fieldcal.app.report.Provenance;
import fieldcal.app.report.ReportPage;
import fieldcal.app.report.Rounded;
import fieldcal.movement.Envelope;
import fieldcal.movement.Grid;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.SpeedCap;
import fieldcal.movement.TeamLimits;
import fieldcal.movement.TeamStatistics;
import fieldcal.vision.Epoch;
import fieldcal.vision.Team;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** {@code limits.html}: both teams' limits, and pictures of what they rest on. The same outcome gives the same bytes. */
final class LimitsPage {
  private static final ReportPage PAGE =
      new ReportPage(
          "Movement limits", "limits.json", "limits.html", "limits.css", List.of("limits.js"));

  private LimitsPage() {}

  /** What the scripts find in the page. */
  private record Contents(
      Provenance provenance,
      boolean refereeSeen,
      @Rounded(3) double noiseMm,
      @Rounded(3) double standingNoiseMm,
      List<TeamView> teams,
      String leaguesEstimate,
      Picture standing,
      List<Problem> problems) {}

  private record TeamView(
      String team,
      String oneLimit,
      Estimate velocity,
      Estimate acceleration,
      Estimate braking,
      Estimate leagueVelocity,
      Estimate leagueAcceleration,
      Estimate leagueBraking,
      List<EffectView> effects,
      List<CapView> caps,
      Estimate turnVelocity,
      Estimate turnAcceleration,
      Estimate turnBraking,
      List<EnvelopeView> envelopes,
      List<RobotView> robots,
      long manoeuvres,
      Picture ownFrame,
      Picture againstSpeed) {}

  private record Estimate(
      @Rounded(4) double value,
      @Rounded(4) double standardError,
      long samples,
      boolean reached,
      String note) {
    static Estimate of(LimitEstimate e) {
      return new Estimate(e.value(), e.standardError(), e.samples(), e.reached(), e.note());
    }
  }

  private record EffectView(
      String effect,
      String sentence,
      @Rounded(4) double coefficient,
      @Rounded(4) double standardError,
      String seenIn,
      @Rounded(3) double shareWithout,
      @Rounded(3) double shareWith) {
    static EffectView of(TeamLimits limits, LimitDeviation d) {
      return new EffectView(
          d.effect().id(),
          LimitWords.sentence(limits, d),
          d.coefficient(),
          d.standardError(),
          d.seenIn(),
          d.shareBefore(),
          d.shareAfter());
    }
  }

  private record CapView(
      int robot, @Rounded(3) double speed, @Rounded(3) double standardError, long samples) {
    static CapView of(SpeedCap c) {
      return new CapView(c.robot(), c.speed(), c.standardError(), c.samples());
    }
  }

  private record EnvelopeView(
      String seenIn, String sentence, boolean shaped, List<Direction> points) {
    static EnvelopeView of(Envelope e) {
      String sentence = e.points().isEmpty() ? "" : LimitWords.sentence(e);
      return new EnvelopeView(
          e.seenIn(), sentence, e.shaped(), e.points().stream().map(Direction::of).toList());
    }
  }

  /** A direction of an envelope. */
  private record Direction(
      @Rounded(4) double angle,
      @Rounded(4) double value,
      @Rounded(4) double standardError,
      @Rounded(1) double manoeuvres) {
    static Direction of(Envelope.Point p) {
      return new Direction(p.angle(), p.value(), p.standardError(), p.manoeuvres());
    }
  }

  private record RobotView(String sentence) {}

  /** The cells that hold something: x, y, count. */
  private record Picture(
      @Rounded(4) double cellX,
      @Rounded(4) double cellY,
      @Rounded(4) double[] x,
      @Rounded(4) double[] y,
      long[] count) {
    static Picture of(Grid grid) {
      Grid.Occupied cells = grid.occupied();
      return new Picture(cells.widthX(), cells.widthY(), cells.x(), cells.y(), cells.count());
    }
  }

  static byte[] of(LimitsOutcome outcome) throws IOException {
    List<TeamView> teams = new ArrayList<>();
    for (Team team : Team.values()) {
      teams.add(view(outcome.nameOf(team), outcome.limits(team), outcome.statistics().of(team)));
    }
    Contents contents =
        new Contents(
            provenance(outcome),
            outcome.statistics().refereeSeen(),
            outcome.noiseMm(),
            outcome.statistics().standingNoiseMm(),
            teams,
            LimitWords.LEAGUES_ESTIMATE,
            Picture.of(outcome.statistics().standing()),
            outcome.problems().stream().map(Problem::of).toList());
    return PAGE.html(title(outcome), contents).getBytes(StandardCharsets.UTF_8);
  }

  private static Provenance provenance(LimitsOutcome outcome) {
    String version = Epoch.class.getPackage().getImplementationVersion();
    return new Provenance(
        outcome.logs().stream().map(Path::toString).toList(),
        "fieldcal " + (version == null ? "(development)" : version),
        0,
        outcome.recordedUnix(),
        outcome.duration());
  }

  private static String title(LimitsOutcome outcome) {
    return String.format(
        Locale.ROOT,
        "Limits: yellow %s m/s, blue %s m/s",
        speed(outcome.yellow().velocity()),
        speed(outcome.blue().velocity()));
  }

  private static String speed(LimitEstimate e) {
    return e.known() ? String.format(Locale.ROOT, "%.2f", e.value()) : "?";
  }

  private static TeamView view(String name, TeamLimits limits, TeamStatistics statistics) {
    return new TeamView(
        name,
        LimitWords.oneLimit(limits),
        Estimate.of(limits.velocity()),
        Estimate.of(limits.acceleration()),
        Estimate.of(limits.braking()),
        Estimate.of(limits.leagueVelocity()),
        Estimate.of(limits.leagueAcceleration()),
        Estimate.of(limits.leagueBraking()),
        limits.deviations().stream().map(d -> EffectView.of(limits, d)).toList(),
        limits.speedCaps().stream().map(CapView::of).toList(),
        Estimate.of(limits.turning().velocity()),
        Estimate.of(limits.turning().acceleration()),
        Estimate.of(limits.turning().braking()),
        limits.envelopes().stream().map(EnvelopeView::of).toList(),
        limits.robots().stream().map(r -> new RobotView(LimitWords.sentence(r))).toList(),
        limits.manoeuvres(),
        Picture.of(statistics.ownFrame()),
        Picture.of(statistics.againstSpeed()));
  }
}
