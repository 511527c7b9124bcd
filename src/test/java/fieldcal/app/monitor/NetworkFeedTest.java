package fieldcal.app.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.net.LoopbackSender;
import fieldcal.app.net.NetworkPlace;
import fieldcal.live.SimulatedMatch;
import fieldcal.proto.Referee;
import fieldcal.simulation.SimulatedPacket;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionEncoder;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.DatagramSocket;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A match that is sent over loopback sockets, many times faster than it was played. */
@Timeout(300)
class NetworkFeedTest {
  private static final long SEED = 4;

  /** On a busy machine a match may take longer than a referee may be silent. */
  private static final int FRAMES_PER_REFEREE = 200;

  @Test
  void aMatchOnTheNetworkIsWatched(@TempDir Path folder) throws Exception {
    SimulatedMatch match = SimulatedMatch.play(SEED, 0.7, -0.28);
    int port = freePort();
    int refereePort = freePort();
    StringWriter text = new StringWriter();
    MonitorRequest request =
        new MonitorRequest(
            Optional.empty(),
            Optional.of(folder.resolve("changes.jsonl")),
            Optional.of(folder.resolve("state.json")));
    try (NetworkFeed feed = new NetworkFeed(place(port), Optional.of(place(refereePort)));
        LineDisplay display = new LineDisplay(new PrintWriter(text), ZoneOffset.UTC)) {
      MonitorSession session = new MonitorSession(request, feed, display);
      CompletableFuture<MatchStatus> watching =
          CompletableFuture.supplyAsync(
              () -> {
                try {
                  return session.run();
                } catch (IOException e) {
                  throw new IllegalStateException(e);
                }
              });
      awaitSilence(session);
      int sent = send(match, session, feed.epoch(), port, refereePort);
      session.stop();
      MatchStatus last = watching.get(120, TimeUnit.SECONDS);
      assertThat(last.snapshot().frames()).as("seed %d", SEED).isGreaterThan((long) (0.9 * sent));
      assertThat(last.snapshot().ball().counts().used()).isGreaterThan(2);
      assertThat(last.referee().orElseThrow().command()).isEqualTo(Referee.Command.NORMAL_START);
      assertThat(last.feed().notes())
          .anyMatch(note -> note.startsWith("vision: ") && note.contains("dropped"))
          .anyMatch(note -> note.contains("of another protocol"));
    }
    assertThat(text.toString())
        .contains("watching 224.5.23.177:" + port)
        .contains("referee is heard: first half, normal start")
        .contains("sliding deceleration −3.");
    assertThat(StateFile.read(folder.resolve("state.json")).size()).isGreaterThan(5);
    assertThat(folder.resolve("changes.jsonl")).content().contains("\"event\":\"summary\"");
  }

  /** Nobody has sent anything: the screen says so. */
  private static void awaitSilence(MonitorSession session) {
    assertThat(session.status().feed().notes())
        .anyMatch(
            note -> note.matches("vision: no packet yet from 224.*177:.*\\(joined on lo\\).*"));
    assertThat(session.status().referee()).isEmpty();
  }

  private static int send(
      SimulatedMatch match, MonitorSession session, Epoch epoch, int port, int refereePort)
      throws Exception {
    // A monitor of the network knows only the clock on the wall; so the match is played now.
    VisionEncoder encoder = new VisionEncoder(epoch);
    int frames = 0;
    try (LoopbackSender vision = new LoopbackSender(port);
        LoopbackSender referee = new LoopbackSender(refereePort)) {
      vision.send(new byte[] {1, 2, 3});
      for (SimulatedPacket packet : match.recording().packets()) {
        if (frames % FRAMES_PER_REFEREE == 0) {
          referee.send(message().toByteArray());
        }
        vision.send(encoder.encode(packet.packet()));
        frames += packet.packet().frame().isPresent() ? 1 : 0;
        // The sockets hold some hundred packets; whoever sends faster than they are taken loses
        // them.
        awaitTaken(session, frames - 60);
      }
      awaitTaken(session, frames);
    }
    return frames;
  }

  /** Whatever the load of the machine; but a packet that is lost is lost. */
  private static void awaitTaken(MonitorSession session, int frames) throws InterruptedException {
    for (int i = 0; i < 3000 && session.status().snapshot().frames() < frames; i++) {
      Thread.sleep(1);
    }
  }

  private static Referee message() {
    Referee.TeamInfo team =
        Referee.TeamInfo.newBuilder()
            .setName("")
            .setScore(0)
            .setRedCards(0)
            .setYellowCards(0)
            .setTimeouts(0)
            .setTimeoutTime(0)
            .setGoalkeeper(0)
            .build();
    return Referee.newBuilder()
        .setPacketTimestamp(System.currentTimeMillis() * 1000)
        .setStage(Referee.Stage.NORMAL_FIRST_HALF)
        .setCommand(Referee.Command.NORMAL_START)
        .setCommandCounter(1)
        .setCommandTimestamp(1)
        .setYellow(team)
        .setBlue(team)
        .build();
  }

  private static NetworkPlace place(int port) {
    return NetworkPlace.parse(LoopbackSender.GROUP + ":" + port, "127.0.0.1");
  }

  private static int freePort() throws IOException {
    try (DatagramSocket any = new DatagramSocket()) {
      return any.getLocalPort();
    }
  }
}
