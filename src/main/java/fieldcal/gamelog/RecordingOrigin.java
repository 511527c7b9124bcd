package fieldcal.gamelog;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Where a recording comes from. A recording of a simulated field carries a filler message that says so, which other programs ignore; so it is recognised whatever its
 * name and folder.
 */
public enum RecordingOrigin {
  /** A real field, or a recording without a mark. */
  FIELD,
  /** A simulated field. */
  SIMULATION;

  private static final byte[] MARK =
      "fieldcal.origin: simulation".getBytes(StandardCharsets.US_ASCII);

  /**
   * The payload of the filler message ({@link MessageType#BLANK}) that marks a recording of a simulated field.
   *
   * @return a copy of its bytes
   */
  public static byte[] simulationMark() {
    return MARK.clone();
  }

  /**
   * Whether the message at hand is that mark.
   *
   * @param log at a message
   * @return true for the mark of a simulated field
   */
  public static boolean isSimulationMark(GameLogReader log) {
    int offset = log.payloadOffset();
    int length = log.payloadLength();
    return log.type() == MessageType.BLANK
        && length == MARK.length
        && Arrays.equals(log.buffer(), offset, offset + length, MARK, 0, MARK.length);
  }
}
