package fieldcal.gamelog;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Where a recorder may have lost packets, because it was too late to take them. A filler message says so, which other programs ignore; without it, the gap would be taken for a silence of vision.
 */
public final class RecordingGap {
  private static final byte[] MARK =
      "fieldcal.gap: packets lost by the recorder".getBytes(StandardCharsets.US_ASCII);

  private RecordingGap() {}

  /**
   * The payload of the filler message ({@link MessageType#BLANK}) before the first message after such a gap.
   *
   * @return a copy of its bytes
   */
  public static byte[] mark() {
    return MARK.clone();
  }

  /** Whether the message at hand is that mark. */
  static boolean isMark(GameLogReader log) {
    int offset = log.payloadOffset();
    int length = log.payloadLength();
    return log.type() == MessageType.BLANK
        && length == MARK.length
        && Arrays.equals(log.buffer(), offset, offset + length, MARK, 0, MARK.length);
  }
}
