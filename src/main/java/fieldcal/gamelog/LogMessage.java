package fieldcal.gamelog;

import java.util.Arrays;
import java.util.Objects;

/**
 * One message of a game log.
 *
 * @param receivedNanos when the recorder received it, Unix time, ns
 * @param type what it is
 * @param payload its bytes, as they came over the network; a copy is neither made nor given away, do not change it
 */
public record LogMessage(long receivedNanos, MessageType type, byte[] payload) {

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws NullPointerException if one is null
   */
  public LogMessage {
    Objects.requireNonNull(type, "type");
    Objects.requireNonNull(payload, "payload");
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof LogMessage message
        && receivedNanos == message.receivedNanos
        && type == message.type
        && Arrays.equals(payload, message.payload);
  }

  @Override
  public int hashCode() {
    return Objects.hash(receivedNanos, type, Arrays.hashCode(payload));
  }

  @Override
  public String toString() {
    return "LogMessage[" + receivedNanos + " ns, " + type + ", " + payload.length + " bytes]";
  }
}
