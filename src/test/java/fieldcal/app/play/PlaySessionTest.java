package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayPhase;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sessions on the embedded field, as fast as they run. */
class PlaySessionTest {
  @TempDir Path directory;

  private static EmbeddedPlayField field(SessionRequest request, long seed) {
    return new EmbeddedPlayField(
        InteractiveField.of(
            SimulationSettings.DEFAULT.withSeed(seed),
            request.first(),
            request.second(),
            List.of()),
        Double.POSITIVE_INFINITY);
  }

  @Test
  void flatKicksAreMadeRecordedAndFitted() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 3).into(directory);
    List<SessionSnapshot> shown = new ArrayList<>();
    PlaySession.Outcome outcome = new PlaySession(request, field(request, 3), shown::add).run();

    assertThat(outcome.complete()).isTrue();
    SessionSnapshot last = outcome.last();
    assertThat(last.state().good()).isEqualTo(3);
    assertThat(last.kicks()).filteredOn(KickResult::good).hasSize(3);
    assertThat(last.model().get("kSwitch").mean()).isCloseTo(0.65, within(0.01));
    assertThat(shown).extracting(s -> s.state().phase()).contains(PlayPhase.WATCH, PlayPhase.KICK);

    Path log = outcome.log().orElseThrow();
    CollectedKicks found = new KickCollector((file, read, total) -> {}).collect(List.of(log));
    List<CommandFile.Command> told = CommandFile.read(outcome.commands().orElseThrow());
    assertThat(told).hasSize(last.kicks().size());
    assertThat(found.kicks()).hasSameSizeAs(told);
    for (var kick : found.kicks()) {
      double unix = found.epoch().unixSeconds(kick.time());
      assertThat(CommandFile.of(told, unix, kick.robot())).isPresent();
    }
  }

  @Test
  void aSecondSessionDoesNotOverwriteTheFirst() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 1).into(directory);
    Path first = new PlaySession(request, field(request, 1), s -> {}).run().log().orElseThrow();
    long size = Files.size(first);
    Path second = new PlaySession(request, field(request, 2), s -> {}).run().log().orElseThrow();
    assertThat(second).isNotEqualTo(first);
    assertThat(Files.size(first)).isEqualTo(size);
  }

  @Test
  void anAbortEndsItWithItsReason() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.CHIP, 12);
    PlaySession[] session = new PlaySession[1];
    EmbeddedPlayField field = field(request, 5);
    session[0] =
        new PlaySession(
            request,
            field,
            snapshot -> {
              if (snapshot.time() > 3) {
                session[0].abort("enough for today");
              }
            });
    PlaySession.Outcome outcome = session[0].run();
    assertThat(outcome.complete()).isFalse();
    assertThat(outcome.last().state().waiting()).contains("enough for today");
    assertThat(outcome.last().time()).isLessThan(4);
    assertThat(field.field().world().robots()).allSatisfy(r -> assertThat(r.speed()).isLessThan(1));
  }
}
