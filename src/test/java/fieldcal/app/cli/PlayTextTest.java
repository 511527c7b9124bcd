package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.play.SessionSnapshot;
import fieldcal.app.play.SessionSnapshot.Undecided;
import fieldcal.play.PlayPhase;
import fieldcal.play.PlayState;
import fieldcal.play.PlayWorld;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.WaitingFor;
import java.io.PrintWriter;
import java.io.StringWriter;
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
        List.of(),
        Map.of(),
        undecided);
  }

  private List<String> remarks = List.of();

  @Test
  void whatIsWrongWithARobotIsSaidOnceAndAtOnce() {
    PlayText text = text(true);
    remarks = List.of("yellow 3 did not kick for the second time in a row; check its kicker");
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
        .contains("please place the ball at (1.0, -2.5) m: the ball is in the goal");
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
