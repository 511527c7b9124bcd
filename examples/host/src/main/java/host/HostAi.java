package host;

import fieldcal.ball.FlatModel;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.LogMessage;
import fieldcal.gamelog.MessageType;
import fieldcal.live.BallParameter;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.live.LiveSnapshot;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionPacket;
import host.ssl.SslVisionDetection.SSL_DetectionFrame;
import host.ssl.SslVisionWrapper.SSL_WrapperPacket;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** A team's AI in small: reads vision with its own messages, and lets fieldcal watch the same bytes. */
public final class HostAi {
  private final LiveMonitor monitor;
  private final VisionDecoder decoder;
  private long ownBalls;
  private long fieldcalBalls;

  private HostAi(Epoch epoch) {
    monitor = new LiveMonitor(LiveSettings.defaults(), epoch, new LiveListener() {});
    decoder = new VisionDecoder(epoch);
  }

  /**
   * Watches a recording.
   *
   * @param args the recording
   * @throws IOException when it cannot be read
   */
  public static void main(String[] args) throws IOException {
    HostAi ai = watch(Path.of(args[0]));
    LiveSnapshot now = ai.snapshot();
    System.out.printf(
        "%d balls by the host's messages, %d by fieldcal's%n",
        ai.ownBalls, ai.fieldcalBalls);
    System.out.printf(
        "%d kicks found; rolling deceleration %.3f m/s²%n",
        now.ball().counts().found(), now.ball().of(BallParameter.ACC_ROLL).median());
    System.out.printf(
        "a pass over 4 m that arrives with 1.5 m/s starts with %.2f m/s%n",
        FlatModel.typical().kickSpeedToArrive(4.0, 1.5));
    if (ai.ownBalls == 0 || ai.ownBalls != ai.fieldcalBalls || now.ball().counts().found() == 0) {
      throw new IllegalStateException("the host and fieldcal do not see the same");
    }
  }

  /**
   * Watches a recording to its end.
   *
   * @param recording of vision's packets
   * @return the AI after it
   * @throws IOException when it cannot be read
   */
  static HostAi watch(Path recording) throws IOException {
    try (GameLogReader log = GameLogReader.open(recording)) {
      HostAi ai = null;
      Optional<LogMessage> message;
      while ((message = log.readMessage()).isPresent()) {
        if (message.get().type() == MessageType.SSL_VISION_2014) {
          if (ai == null) {
            ai = new HostAi(Epoch.atSecondOf(message.get().receivedNanos()));
          }
          ai.onVision(message.get().payload());
        }
      }
      if (ai == null) {
        throw new IOException(recording + ": no vision in it");
      }
      ai.monitor.finish();
      return ai;
    }
  }

  /** A packet, as the vision thread gets it. */
  private void onVision(byte[] packet) throws IOException {
    SSL_DetectionFrame own = SSL_WrapperPacket.parseFrom(packet).getDetection();
    ownBalls += own.getBallsCount();

    VisionPacket vision = decoder.decode(packet);
    vision.geometry().ifPresent(monitor::geometry);
    vision.frame().ifPresent(frame -> fieldcalBalls += frame.balls().size());
    vision.frame().ifPresent(monitor::accept);
    monitor.poll();
  }

  /** What fieldcal knows by now. */
  LiveSnapshot snapshot() {
    return monitor.snapshot();
  }
}
