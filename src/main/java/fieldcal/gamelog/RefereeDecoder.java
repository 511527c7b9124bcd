package fieldcal.gamelog;

import com.google.protobuf.InvalidProtocolBufferException;
import fieldcal.proto.Referee;
import fieldcal.vision.Epoch;
import java.util.Objects;
import java.util.Optional;

/** Decodes the bytes of referee messages. Immutable. */
public final class RefereeDecoder {
  private static final long NANOS_PER_MICRO = 1000;

  private final Epoch epoch;

  /**
   * Creates a decoder.
   *
   * @param epoch the instant that times count from
   */
  public RefereeDecoder(Epoch epoch) {
    this.epoch = Objects.requireNonNull(epoch, "epoch");
  }

  /**
   * Decodes a message. Only stage and command must be there; whatever else is absent takes the message's default.
   *
   * @param buffer holds the message
   * @param offset its first byte
   * @param length its length, bytes
   * @return what the referee says; nothing if the bytes are no referee message or lack stage or command
   */
  public Optional<RefereeState> decode(byte[] buffer, int offset, int length) {
    Referee message;
    try {
      message = Referee.newBuilder().mergeFrom(buffer, offset, length).buildPartial();
    } catch (InvalidProtocolBufferException e) {
      return Optional.empty();
    }
    // An unknown stage or command reads as absent: proto2 keeps it among the unknown fields.
    if (!message.hasStage() || !message.hasCommand()) {
      return Optional.empty();
    }
    return Optional.of(
        new RefereeState(
            seconds(message.getPacketTimestamp()),
            message.getStage(),
            message.getCommand(),
            Integer.toUnsignedLong(message.getCommandCounter()),
            seconds(message.getCommandTimestamp()),
            message.hasNextCommand() ? Optional.of(message.getNextCommand()) : Optional.empty(),
            team(message.getYellow()),
            team(message.getBlue()),
            message.hasBlueTeamOnPositiveHalf()
                ? Optional.of(message.getBlueTeamOnPositiveHalf())
                : Optional.empty()));
  }

  private double seconds(long unixMicros) {
    return epoch.secondsOfNanos(unixMicros * NANOS_PER_MICRO);
  }

  private static RefereeState.TeamState team(Referee.TeamInfo team) {
    return new RefereeState.TeamState(team.getName(), team.getScore(), team.getGoalkeeper());
  }
}
