package fieldcal.app.cli;

import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.vision.BallDetection;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;

/** Copies of a game log in which every packet was looked at, and changed or left out. */
public final class EditedLog {
  private static final Epoch EPOCH = Epoch.atSecondOf(1.7e9);

  private EditedLog() {}

  /** Other messages are kept. The change answers {@link VisionPacket#EMPTY} for a packet to leave out. */
  public static Path copy(Path from, Path to, UnaryOperator<VisionPacket> change)
      throws IOException {
    VisionDecoder decoder = new VisionDecoder(EPOCH);
    VisionEncoder encoder = new VisionEncoder(EPOCH);
    try (GameLogReader reader = GameLogReader.open(from);
        GameLogWriter writer = GameLogWriter.create(to)) {
      while (reader.next()) {
        if (reader.type() != MessageType.SSL_VISION_2014) {
          writer.write(
              reader.receivedNanos(),
              reader.type().code(),
              reader.buffer(),
              reader.payloadOffset(),
              reader.payloadLength());
          continue;
        }
        VisionPacket packet =
            change.apply(
                decoder.decode(reader.buffer(), reader.payloadOffset(), reader.payloadLength()));
        if (!packet.equals(VisionPacket.EMPTY)) {
          writer.write(reader.receivedNanos(), MessageType.SSL_VISION_2014, encoder.encode(packet));
        }
      }
    }
    return to;
  }

  static VisionPacket withBalls(VisionPacket packet, List<BallDetection> balls) {
    VisionFrame f = packet.frame().orElseThrow();
    return VisionPacket.of(
        new VisionFrame(
            f.cameraId(),
            f.frameNumber(),
            f.captureTime(),
            f.sentTime(),
            f.cameraClockTime(),
            balls,
            f.robots()));
  }

  /** With its frame taken and sent later, s: the same kicks in other bytes. */
  public static VisionPacket later(VisionPacket packet, double by) {
    return packet.frame().map(f -> VisionPacket.of(later(f, by))).orElse(packet);
  }

  /** Taken and sent later, s. */
  public static VisionFrame later(VisionFrame f, double by) {
    return new VisionFrame(
        f.cameraId(),
        f.frameNumber(),
        f.captureTime() + by,
        f.sentTime() + by,
        f.cameraClockTime(),
        f.balls(),
        f.robots());
  }
}
