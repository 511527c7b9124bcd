package fieldcal.app.recording;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.zip.CRC32C;

/** What vision sent in a recording, in so far as it takes to find the same messages in another one, packed or not, or a part of it. */
public final class VisionContent {
  /** Nothing. */
  public static final VisionContent NONE = new Reading().content();

  /**
   * One message of so many is remembered. Which ones, its checksum decides: so two recordings remember the same messages, wherever they begin. Chosen, since an hour of four cameras (a million messages) then takes 0.25 MB.
   */
  private static final int ONE_OF = 16;

  /** Fewer remembered messages may be geometry, which all recordings of a field share; chosen, since they are those of 1 s of four cameras. */
  private static final int FEWEST = 16;

  /** So many remembered messages show whether anything is in common: of a recording that is half in another one, all of them are missing once in 2^64 times. */
  private static final int PROBES = 64;

  private final long messages;
  private final long checksum;

  /** Checksums of the remembered messages, each once, in order. */
  private final int[] remembered;

  private VisionContent(long messages, long checksum, int[] remembered) {
    this.messages = messages;
    this.checksum = checksum;
    this.remembered = remembered;
  }

  /** Collects the messages of a recording. */
  public static final class Reading {
    private final CRC32C all = new CRC32C();
    private final CRC32C one = new CRC32C();
    private final IntStream.Builder remembered = IntStream.builder();
    private long messages;

    /**
     * Takes the next message.
     *
     * @param buffer holds it
     * @param offset where it begins
     * @param length its bytes
     */
    public void accept(byte[] buffer, int offset, int length) {
      all.update(buffer, offset, length);
      one.reset();
      one.update(buffer, offset, length);
      if (one.getValue() % ONE_OF == 0) {
        remembered.add((int) one.getValue());
      }
      messages++;
    }

    /**
     * What was taken. To be called once.
     *
     * @return all messages
     */
    public VisionContent content() {
      return new VisionContent(
          messages, all.getValue(), remembered.build().sorted().distinct().toArray());
    }
  }

  /**
   * How many messages vision sent.
   *
   * @return 0 or more
   */
  public long messages() {
    return messages;
  }

  /**
   * How much of it another recording holds, too.
   *
   * @param other of any file
   * @return 1 when all messages are in both, 0 when none is, or too few are known to say so
   */
  public double shareIn(VisionContent other) {
    if (messages > 0 && equals(other)) {
      return 1;
    }
    if (remembered.length < FEWEST) {
      return 0;
    }
    long both =
        Arrays.stream(remembered)
            .filter(message -> Arrays.binarySearch(other.remembered, message) >= 0)
            .count();
    return (double) both / remembered.length;
  }

  /** False when surely less than half of it is in another recording: soon known, also where hundreds of recordings are compared. */
  boolean mayBeHalfIn(VisionContent other) {
    int step = Math.max(1, remembered.length / PROBES);
    for (int i = 0; i < remembered.length; i += step) {
      if (Arrays.binarySearch(other.remembered, remembered[i]) >= 0) {
        return true;
      }
    }
    return equals(other);
  }

  /**
   * Writes it, so that it need not be found again.
   *
   * @param out where to
   * @throws IOException when it cannot be written
   */
  public void writeTo(DataOutput out) throws IOException {
    out.writeLong(messages);
    out.writeLong(checksum);
    out.writeInt(remembered.length);
    for (int message : remembered) {
      out.writeInt(message);
    }
  }

  /**
   * Reads what {@link #writeTo} wrote.
   *
   * @param in where from
   * @return the same content
   * @throws IOException when it cannot be read
   */
  public static VisionContent readFrom(DataInput in) throws IOException {
    long messages = in.readLong();
    long checksum = in.readLong();
    int[] remembered = new int[in.readInt()];
    for (int i = 0; i < remembered.length; i++) {
      remembered[i] = in.readInt();
    }
    return new VisionContent(messages, checksum, remembered);
  }

  @Override
  public boolean equals(Object o) {
    return o instanceof VisionContent c && messages == c.messages && checksum == c.checksum;
  }

  @Override
  public int hashCode() {
    return Long.hashCode(messages << Integer.SIZE | checksum);
  }
}
