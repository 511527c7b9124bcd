package fieldcal.gamelog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.proto.KickedBall;
import fieldcal.proto.RobotId;
import fieldcal.proto.Team;
import fieldcal.proto.TrackedBall;
import fieldcal.proto.TrackedFrame;
import fieldcal.proto.TrackerWrapperPacket;
import fieldcal.proto.Vector2;
import fieldcal.proto.Vector3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Trackers' frames in a recording: what they say, who says it, and what is no such frame. */
class TrackerStatisticsTest {
  private static final int TRACKER = MessageType.SSL_VISION_TRACKER_2020.code();

  @TempDir private Path folder;

  private static Vector3 vector(double x, double y, double z) {
    return Vector3.newBuilder().setX((float) x).setY((float) y).setZ((float) z).build();
  }

  private static TrackedFrame.Builder frame(double time) {
    return TrackedFrame.newBuilder()
        .setFrameNumber(1)
        .setTimestamp(LogBuilder.EPOCH.unixSeconds(time))
        .addBalls(TrackedBall.newBuilder().setPos(vector(1, 2, 0)).setVel(vector(3, 0, 0)));
  }

  private static KickedBall kick(double start) {
    return KickedBall.newBuilder()
        .setPos(Vector2.newBuilder().setX(1).setY(2))
        .setVel(vector(3, 4, 0))
        .setStartTimestamp(LogBuilder.EPOCH.unixSeconds(start))
        .setStopPos(Vector2.newBuilder().setX(5).setY(6))
        .setRobotId(RobotId.newBuilder().setId(7).setTeam(Team.BLUE))
        .build();
  }

  private static byte[] packet(String source, TrackedFrame.Builder frame) {
    return TrackerWrapperPacket.newBuilder()
        .setUuid("one")
        .setSourceName(source)
        .setTrackedFrame(frame)
        .build()
        .toByteArray();
  }

  private RecordingSummary read(LogBuilder log, RecordingListener listener) throws IOException {
    Path file = Files.write(folder.resolve("match.log"), log.bytes());
    try (RecordingReader reader = RecordingReader.open(file)) {
      return reader.read(listener);
    }
  }

  private static LogBuilder twoTrackers() {
    LogBuilder log = new LogBuilder();
    for (int i = 0; i < 100; i++) {
      double time = 1 + 0.01 * i;
      TrackedFrame.Builder good = frame(time);
      if (i >= 20 && i < 60) {
        // The same kick, whose start is estimated better and better; then another one.
        good.setKickedBall(kick(i < 40 ? 1.2 + 0.0001 * i : 1.4));
      }
      log.record(time + 0.012, TRACKER, packet("TIGERs", good));
      if (i % 2 == 0) {
        log.record(time + 0.030, TRACKER, packet("", frame(time).clearBalls()));
      }
    }
    return log;
  }

  /** 255 at most, as in vision's messages; the field is unsigned. */
  @ParameterizedTest
  @ValueSource(ints = {256, Integer.MAX_VALUE, Integer.MIN_VALUE, -1})
  void aRobotOfAnImpossibleNumberIsLeftOut(int number) {
    KickedBall kicked =
        kick(1).toBuilder()
            .setRobotId(RobotId.newBuilder().setId(number).setTeam(Team.BLUE))
            .build();
    byte[] bytes = packet("TIGERs", frame(1).setKickedBall(kicked));
    TrackerFrame decoded =
        new TrackerDecoder(LogBuilder.EPOCH).decode(bytes, 0, bytes.length).orElseThrow();
    assertThat(decoded.kick().orElseThrow().robot()).isEmpty();
  }

  @Test
  void eachSourceIsCounted() throws IOException {
    RecordingStatistics statistics = new RecordingStatistics();
    read(twoTrackers(), statistics);
    assertThat(statistics.trackers()).hasSize(2);
    TrackerStatistics silent = statistics.trackers().get(0);
    assertThat(silent.source()).isEmpty();
    assertThat(silent.frames()).isEqualTo(50);
    assertThat(silent.rate()).isEqualTo(50, within(0.1));
    assertThat(silent.delay()).isEqualTo(0.030, within(0.001));
    assertThat(silent.ballShare()).isZero();
    assertThat(silent.kicks()).isZero();
    TrackerStatistics tigers = statistics.trackers().get(1);
    assertThat(tigers.source()).isEqualTo("TIGERs");
    assertThat(tigers.rate()).isEqualTo(100, within(0.1));
    assertThat(tigers.delay()).isEqualTo(0.012, within(0.001));
    assertThat(tigers.ballShare()).isEqualTo(1);
    assertThat(tigers.kicks()).isEqualTo(2);
  }

  @Test
  void whatAFrameSaysComesOut() throws IOException {
    List<TrackerFrame> frames = new ArrayList<>();
    read(
        new LogBuilder()
            .record(0.5, TRACKER, packet("TIGERs", frame(1.5).setKickedBall(kick(1.25)))),
        new Listener(frames, true));
    TrackerFrame frame = frames.get(0);
    assertThat(frame.time()).isEqualTo(1.5, within(1e-6));
    assertThat(frame.ball()).contains(new TrackerFrame.Ball(1, 2, 0, 3, 0, 0));
    TrackerFrame.Kick kick = frame.kick().orElseThrow();
    assertThat(kick.speed()).isEqualTo(5, within(1e-6));
    assertThat(kick.start()).isEqualTo(1.25, within(1e-6));
    assertThat(kick.stop()).isNaN();
    assertThat(kick.stopX()).isEqualTo(5);
    assertThat(kick.robot()).contains(new fieldcal.vision.RobotId(fieldcal.vision.Team.BLUE, 7));
  }

  @Test
  void whatIsNoFrameIsCountedAndSkipped() throws IOException {
    List<TrackerFrame> frames = new ArrayList<>();
    LogBuilder log =
        new LogBuilder()
            .record(1, TRACKER, new byte[] {1, 2, 3})
            .record(2, TRACKER, new byte[0])
            .record(3, TRACKER, packet("a", frame(1).setTimestamp(Double.NaN)))
            .record(4, TRACKER, packet("a", frame(1).setTimestamp(Double.POSITIVE_INFINITY)))
            .record(
                5,
                TRACKER,
                packet(
                    "a",
                    frame(1)
                        .clearBalls()
                        .addBalls(TrackedBall.newBuilder().setPos(vector(Double.NaN, 0, 0)))));
    RecordingSummary summary = read(log, new Listener(frames, true));
    assertThat(summary.problems().count(LogProblem.MALFORMED_TRACKER)).isEqualTo(4);
    assertThat(frames).hasSize(1);
    assertThat(frames.get(0).ball()).isEmpty();
  }

  @Test
  void whoDoesNotAskIsNotTold() throws IOException {
    List<TrackerFrame> frames = new ArrayList<>();
    RecordingSummary summary =
        read(twoTrackers().record(9, TRACKER, new byte[] {1}), new Listener(frames, false));
    assertThat(frames).isEmpty();
    assertThat(summary.problems().count(LogProblem.MALFORMED_TRACKER)).isZero();
  }

  /** Keeps what it is told. */
  private record Listener(List<TrackerFrame> frames, boolean wantsTrackers)
      implements RecordingListener {
    @Override
    public void onTracker(TrackerFrame frame, double receivedTime) {
      frames.add(frame);
    }
  }
}
