package fieldcal.app.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.cli.EditedLog;
import fieldcal.app.cli.Main;
import fieldcal.effect.ObservedCamera;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingGap;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** What a diagnosis needs besides kicks: the cameras as published, and when the session began. */
class KickCollectorTest {
  @TempDir private static Path folder;

  /** A field with four cameras. */
  private static Path four;

  /** Another field with two, which have the ids of the first two of the other. */
  private static Path two;

  @BeforeAll
  static void simulate() {
    four = simulated("four.log.gz", "--cameras=4", "--seed=1");
    two = simulated("two.log.gz", "--cameras=2", "--seed=2");
  }

  private static Path simulated(String name, String... options) {
    Path log = folder.resolve(name);
    List<String> args =
        new ArrayList<>(List.of("simulate", "--scenario=flat", "--kicks=2", "--out=" + log));
    args.addAll(Arrays.asList(options));
    CommandLine quiet = Main.commandLine().setOut(new PrintWriter(Writer.nullWriter()));
    assertThat(quiet.execute(args.toArray(String[]::new))).isZero();
    return log;
  }

  private static CollectedKicks collected(Path... logs) throws IOException {
    return new KickCollector((log, read, total) -> {}).collect(List.of(logs));
  }

  @Test
  void camerasAreKnownAsPublished() throws IOException {
    CollectedKicks data = collected(four);
    assertThat(data.observers()).extracting(ObservedCamera::id).containsExactly(0, 1, 2, 3);
    assertThat(data.observers())
        .allSatisfy(
            o -> {
              assertThat(o.cameraCount()).isEqualTo(4);
              assertThat(o.hasLens()).isTrue();
              assertThat(o.distortion()).isCloseTo(0.12, within(0.05));
              assertThat(Math.abs(o.axisZ())).isGreaterThan(0.9);
            });
  }

  @Test
  void theSessionBeginsWithTheFirstFrame() throws IOException {
    CollectedKicks data = collected(four);
    assertThat(data.sessionStart()).isBetween(0.0, 1.1);
    assertThat(data.kicks().get(0).time()).isGreaterThan(data.sessionStart());
    // A later recording does not begin another one.
    assertThat(collected(four, two).sessionStart()).isEqualTo(data.sessionStart());
  }

  @Test
  void camerasOfAnotherFieldKeepTheirOwnNumbersAndCount() throws IOException {
    List<ObservedCamera> observers = collected(four, two).observers();
    assertThat(observers).extracting(ObservedCamera::id).containsExactly(0, 1, 2, 3, 100, 101);
    assertThat(observers).extracting(ObservedCamera::cameraCount).containsExactly(4, 4, 4, 4, 2, 2);
    // Known by its number here, not by the one in its geometry.
    assertThat(observers.get(4).camera().orElseThrow().positionX())
        .isNotEqualTo(observers.get(0).camera().orElseThrow().positionX());
  }

  /** The same recording with two gaps; the recorder says that the second one is its own. */
  /** A kick cannot lead from one field to the other. */
  @Test
  void onlyCamerasOfOneFieldLookAtItTogether() throws IOException {
    assertThat(collected(four, two).together())
        .containsEntry(0, Set.of(0, 1, 2, 3))
        .containsEntry(3, Set.of(0, 1, 2, 3))
        .containsEntry(100, Set.of(100, 101))
        .containsEntry(101, Set.of(100, 101));
  }

  @Test
  void framesThatTheRecorderLostAreNoSilenceOfTheCameras() throws IOException {
    Path log = folder.resolve("gaps.log");
    double first = Double.NaN;
    boolean marked = false;
    try (GameLogReader reader = GameLogReader.open(four);
        GameLogWriter writer = GameLogWriter.create(log)) {
      while (reader.next()) {
        double time = 1e-9 * reader.receivedNanos();
        first = Double.isNaN(first) ? time : first;
        double since = time - first;
        if (since > 2 && since < 2.5 || since > 4 && since < 4.5) {
          continue;
        }
        if (since > 4 && !marked) {
          marked = true;
          writer.write(reader.receivedNanos(), MessageType.BLANK, RecordingGap.mark());
        }
        byte[] payload =
            Arrays.copyOfRange(
                reader.buffer(),
                reader.payloadOffset(),
                reader.payloadOffset() + reader.payloadLength());
        writer.write(reader.receivedNanos(), reader.type(), payload);
      }
    }
    assertThat(collected(log).problems())
        .filteredOn(p -> p.what().contains("0.25 s"))
        .extracting(p -> p.count() + " " + p.what())
        .containsExactly(
            "1 all cameras silent for more than 0.25 s",
            "1 the recorder's machine was busy and lost more than 0.25 s of frames");
  }

  /** It is reported as what it is. */
  @Test
  void aClockThatJumpsForwardIsNoSilenceOfTheCameras() throws IOException {
    Path log = folder.resolve("jump.log");
    Epoch epoch = collected(four).epoch();
    VisionDecoder decoder = new VisionDecoder(epoch);
    VisionEncoder encoder = new VisionEncoder(epoch);
    try (GameLogReader reader = GameLogReader.open(four);
        GameLogWriter writer = GameLogWriter.create(log)) {
      while (reader.next()) {
        if (reader.type() != MessageType.SSL_VISION_2014) {
          continue;
        }
        VisionPacket packet =
            decoder.decode(reader.buffer(), reader.payloadOffset(), reader.payloadLength());
        packet = packet.frame().map(KickCollectorTest::jumped).map(VisionPacket::of).orElse(packet);
        writer.write(reader.receivedNanos(), reader.type(), encoder.encode(packet));
      }
    }
    List<String> said = collected(log).problems().stream().map(DataProblem::what).toList();
    assertThat(said).noneMatch(what -> what.contains("silent"));
    assertThat(said).anyMatch(what -> what.contains("jumps forward"));
  }

  private static VisionFrame jumped(VisionFrame f) {
    return EditedLog.later(f, f.captureTime() > 3 ? 3600 : 0);
  }
}
