package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.play.KickResult;
import fieldcal.app.play.PlayRun;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.play.SessionSnapshot;
import fieldcal.app.play.SessionSnapshot.Undecided;
import fieldcal.kick.KickKind;
import fieldcal.play.PlannedKick;
import fieldcal.play.PlayPhase;
import fieldcal.play.PlayState;
import fieldcal.play.PlayWorld;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.PlayedKick;
import fieldcal.play.WaitingFor;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** What the operator reads while the play goes on. */
class PlayTextTest {
  private final StringWriter out = new StringWriter();
  private long nanos;

  private PlayText text(boolean onTerminal) {
    return new PlayText(new PrintWriter(out), onTerminal, () -> nanos);
  }

  private SessionSnapshot at(double time, String waiting, List<Double> ballWanted) {
    return at(time, waiting, ballWanted, new Undecided(List.of(), List.of(), List.of()));
  }

  private SessionSnapshot at(
      double time, String waiting, List<Double> ballWanted, Undecided undecided) {
    PlayState state =
        new PlayState(
            PlayPhase.POSITION,
            Optional.of(waiting).filter(w -> !w.isEmpty()),
            WaitingFor.NOTHING,
            1,
            2,
            0,
            12,
            Optional.empty(),
            0,
            remarks);
    PlayWorld world = new PlayWorld(time, time, Optional.empty(), List.of(), Permission.RUN);
    return new SessionSnapshot(
        time,
        state,
        false,
        world,
        Optional.empty(),
        List.of(),
        ballWanted,
        kicks,
        Map.of(),
        undecided);
  }

  private List<KickResult> kicks = List.of();
  private List<String> remarks = List.of();

  private static KickResult kick(int number, boolean counts, String reason, boolean used) {
    PlayedKick played =
        new PlayedKick(
            number,
            new PlannedKick(3, 0.7, false),
            new RobotId(Team.YELLOW, 3),
            number,
            0,
            0,
            0,
            number + 1,
            PlayedKick.End.STOPPED);
    return new KickResult(played, Optional.empty(), Optional.of(counts), reason, used, false);
  }

  /** Two of them are used by the calibration, which says so below. */
  @Test
  void aKickThatDoesNotCountAndOneThatIsNotUsedAreNotConfused() {
    PlayText text = text(true);
    kicks =
        List.of(
            kick(1, true, "", true),
            kick(2, false, "does not determine the vertical damping", true),
            kick(3, false, "differs from the others", false));
    try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none())) {
      text.follow(at(1, "", List.of()), progress);
      kicks = List.of(kicks.get(0), kick(2, true, "", true), kicks.get(2));
      text.follow(at(2, "", List.of()), progress);
      kicks = List.of(kicks.get(0), kick(2, false, "R", true), kicks.get(2));
      text.follow(at(3, "", List.of()), progress);
    }
    PlaySession.Outcome outcome =
        new PlaySession.Outcome(at(4, "", List.of()), Optional.empty(), Optional.empty());
    text.result(
        new PlayRun.Result(outcome, Optional.empty(), List.of(), Path.of("out")),
        SessionRequest.of(KickKind.CHIP, 12),
        Optional.empty(),
        Optional.empty());
    assertThat(out.toString())
        .contains("chip 3.00 m/s  does not count: does not determine the vertical damping")
        .contains("  2  was judged again, and counts")
        .contains("  2  was judged again, and does not count: R")
        .contains("1 good kick of 2 made, and 1 used for the parameters that it determines.")
        .doesNotContain("not used");
  }

  @Test
  void whatIsWrongWithARobotIsSaidOnceAndAtOnce() {
    PlayText text = text(true);
    remarks = List.of("yellow 3 did not kick, twice in a row: check its kicker");
    try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none())) {
      text.follow(at(1, "", List.of()), progress);
      text.follow(at(2, "", List.of()), progress);
    }
    assertThat(out.toString().lines().map(String::strip)).containsExactlyElementsOf(remarks);
  }

  @Test
  void aCauseThatLastsIsToldOnce() {
    PlayText text = text(true);
    try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none())) {
      for (int i = 0; i < 100; i++) {
        text.follow(
            at(0.1 * i, i < 50 ? "yellow 1 does not stand still" : "", List.of()), progress);
      }
    }
    assertThat(out.toString().lines())
        .singleElement()
        .asString()
        .endsWith("2.1 s: yellow 1 does not stand still");
  }

  @Test
  void whoeverHasToLayTheBallIsToldWhere() {
    PlayText text = text(true);
    try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none())) {
      for (int i = 0; i < 30; i++) {
        text.follow(at(0.1 * i, "the ball is in the goal", List.of(1.0, -2.5)), progress);
      }
    }
    assertThat(out.toString())
        .contains("please place the ball at (1.0, −2.5) m: the ball is in the goal");
  }

  @Test
  void whoReadsAFileSeesALineEveryFewSeconds() {
    PlayText text = text(false);
    try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none())) {
      for (int i = 0; i < 200; i++) {
        nanos += 100_000_000L;
        text.follow(at(0.1 * i, "", List.of()), progress);
      }
    }
    assertThat(out.toString().lines()).hasSize(3);
    assertThat(out.toString()).contains("1 of 12 good kicks  moving into position");
  }

  @Test
  void onlyWhatTheNextKickDistinguishesIsSaidToBeDistinguished() {
    Undecided undecided =
        new Undecided(
            List.of("offset A or offset B", "slope or nap"), List.of("slope or nap"), List.of());
    PlayText text = text(true);
    try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none())) {
      text.follow(at(1, "", List.of(), undecided), progress);
    }
    assertThat(out.toString().lines().map(String::strip))
        .containsExactly(
            "undecided: offset A or offset B; no kick of this play can distinguish them",
            "undecided: slope or nap; the next kick is chosen to distinguish them");
  }
}
