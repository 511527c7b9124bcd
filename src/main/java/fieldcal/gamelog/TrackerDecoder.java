package fieldcal.gamelog;

import com.google.protobuf.InvalidProtocolBufferException;
import fieldcal.proto.KickedBall;
import fieldcal.proto.TrackedBall;
import fieldcal.proto.TrackedFrame;
import fieldcal.proto.TrackerWrapperPacket;
import fieldcal.vision.Epoch;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionDecoder;
import java.util.Objects;
import java.util.Optional;

/** Decodes the bytes of trackers' messages. Immutable. */
final class TrackerDecoder {
  /** Longest name, in characters; the rest is cut off, so that a tracker that counts its frames in its name does not fill the memory. */
  private static final int LONGEST_NAME = 60;

  /** Latest time, s of Unix time; a later one is invalid. In the year 2262 nanoseconds overflow. */
  private static final double LATEST = 9.2e9;

  private final Epoch epoch;

  TrackerDecoder(Epoch epoch) {
    this.epoch = Objects.requireNonNull(epoch, "epoch");
  }

  /**
   * Decodes a message.
   *
   * @return nothing if the bytes are no tracker's message, or hold no frame with a time; a ball or a kick that is not finite is left out
   */
  Optional<TrackerFrame> decode(byte[] buffer, int offset, int length) {
    TrackerWrapperPacket packet;
    try {
      packet = TrackerWrapperPacket.newBuilder().mergeFrom(buffer, offset, length).buildPartial();
    } catch (InvalidProtocolBufferException e) {
      return Optional.empty();
    }
    TrackedFrame frame = packet.getTrackedFrame();
    if (!packet.hasTrackedFrame() || !(Math.abs(frame.getTimestamp()) < LATEST)) {
      return Optional.empty();
    }
    double time = epoch.seconds(frame.getTimestamp());
    return Optional.of(
        new TrackerFrame(
            shortened(packet.getSourceName()),
            shortened(packet.getUuid()),
            time,
            frame.getBallsCount() == 0 ? Optional.empty() : ball(frame.getBalls(0)),
            frame.hasKickedBall() ? kick(frame.getKickedBall()) : Optional.empty(),
            frame.getRobotsCount()));
  }

  private static String shortened(String name) {
    return name.length() <= LONGEST_NAME ? name : name.substring(0, LONGEST_NAME);
  }

  private static Optional<TrackerFrame.Ball> ball(TrackedBall b) {
    double x = b.getPos().getX();
    double y = b.getPos().getY();
    double z = b.getPos().getZ();
    if (!Double.isFinite(x + y + z)) {
      return Optional.empty();
    }
    boolean moving = b.hasVel();
    return Optional.of(
        new TrackerFrame.Ball(
            x,
            y,
            z,
            moving ? b.getVel().getX() : Double.NaN,
            moving ? b.getVel().getY() : Double.NaN,
            moving ? b.getVel().getZ() : Double.NaN));
  }

  private Optional<TrackerFrame.Kick> kick(KickedBall k) {
    double finite =
        k.getPos().getX()
            + k.getPos().getY()
            + k.getVel().getX()
            + k.getVel().getY()
            + k.getVel().getZ()
            + k.getStartTimestamp();
    if (!Double.isFinite(finite)) {
      return Optional.empty();
    }
    boolean rests = k.hasStopPos();
    return Optional.of(
        new TrackerFrame.Kick(
            k.getPos().getX(),
            k.getPos().getY(),
            k.getVel().getX(),
            k.getVel().getY(),
            k.getVel().getZ(),
            epoch.seconds(k.getStartTimestamp()),
            k.hasStopTimestamp() ? epoch.seconds(k.getStopTimestamp()) : Double.NaN,
            rests ? k.getStopPos().getX() : Double.NaN,
            rests ? k.getStopPos().getY() : Double.NaN,
            k.hasRobotId() ? robot(k.getRobotId()) : Optional.empty()));
  }

  private static Optional<RobotId> robot(fieldcal.proto.RobotId id) {
    if (Integer.toUnsignedLong(id.getId()) > VisionDecoder.MAX_ROBOT_NUMBER) {
      return Optional.empty();
    }
    return switch (id.getTeam()) {
      case YELLOW -> Optional.of(new RobotId(Team.YELLOW, id.getId()));
      case BLUE -> Optional.of(new RobotId(Team.BLUE, id.getId()));
      default -> Optional.empty();
    };
  }
}
