package fieldcal.app.hardening;

import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RecordingStatistics;
import fieldcal.proto.KickedBall;
import fieldcal.proto.RobotId;
import fieldcal.proto.Team;
import fieldcal.proto.TrackedBall;
import fieldcal.proto.TrackedFrame;
import fieldcal.proto.TrackedRobot;
import fieldcal.proto.TrackerWrapperPacket;
import fieldcal.proto.Vector2;
import fieldcal.proto.Vector3;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Messages of trackers as recordings hold them, read with all that is judged of them. */
final class TrackerFuzz {
  private static final double START = 1_700_000_000; // s, Unix time

  private TrackerFuzz() {}

  static List<byte[]> messages() {
    List<byte[]> all = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      TrackedFrame.Builder frame =
          TrackedFrame.newBuilder()
              .setFrameNumber(i)
              .setTimestamp(START + 0.01 * i)
              .addBalls(
                  TrackedBall.newBuilder()
                      .setPos(vector(1 + 0.03f * i))
                      .setVel(vector(3))
                      .setVisibility(1))
              .addRobots(
                  TrackedRobot.newBuilder()
                      .setRobotId(RobotId.newBuilder().setId(7).setTeam(Team.BLUE))
                      .setPos(Vector2.newBuilder().setX(1).setY(2))
                      .setOrientation(1));
      if (i > 1) {
        frame.setKickedBall(
            KickedBall.newBuilder()
                .setPos(Vector2.newBuilder().setX(1).setY(2))
                .setVel(vector(3))
                .setStartTimestamp(START)
                .setStopTimestamp(START + 4)
                .setStopPos(Vector2.newBuilder().setX(5).setY(6)));
      }
      all.add(
          TrackerWrapperPacket.newBuilder()
              .setUuid("3f1c")
              .setSourceName("A tracker")
              .setTrackedFrame(frame)
              .build()
              .toByteArray());
    }
    return all;
  }

  private static Vector3 vector(float x) {
    return Vector3.newBuilder().setX(x).setY(2).setZ(0).build();
  }

  /** Reads a recording of one message between good ones. */
  static void read(byte[] message, Path scratch) throws IOException {
    Path log = scratch.resolve("tracker.log");
    List<byte[]> all = messages();
    all.set(1, message);
    try (GameLogWriter writer = GameLogWriter.create(log)) {
      long nanos = (long) (START * 1e9);
      for (byte[] one : all) {
        writer.write(nanos, MessageType.SSL_VISION_TRACKER_2020, one);
        nanos += 10_000_000;
      }
    }
    RecordingStatistics statistics = new RecordingStatistics();
    try (RecordingReader reader = RecordingReader.open(log)) {
      reader.read(statistics);
    }
    statistics.trackers();
  }
}
