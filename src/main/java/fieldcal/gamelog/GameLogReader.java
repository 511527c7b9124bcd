package fieldcal.gamelog;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * Reads a game log ({@code .log}, {@code .log.gz}) record by record, in constant memory.
 *
 * <p>The file is the header {@code SSL_LOG_FILE} and version 1, then records of int64 time (ns), int32 type, int32 size and the
 * message itself, all big endian. Compressed files are recognised by their first bytes, not by their names, and may consist of several
 * gzip members.
 *
 * <p>Damage does not end the reading: where the bytes cannot be a record, the reader searches for the next place at which two records follow each other; {@link #problems()} says what was skipped. Not thread-safe.
 *
 * <pre>{@code
 * try (GameLogReader log = GameLogReader.open(file)) {
 *   while (log.next()) {
 *     use(log.type(), log.buffer(), log.payloadOffset(), log.payloadLength());
 *   }
 * }
 * }</pre>
 */
public final class GameLogReader implements Closeable {
  /**
   * Largest accepted ratio of a log's size to that of its compressed file. Recordings of real and simulated fields reach 11; a file made to exhaust memory or time reaches the maximum of gzip, 1030.
   */
  public static final double LARGEST_RATIO = 100;

  static final String MAGIC = "SSL_LOG_FILE";
  static final int VERSION = 1;
  static final int FILE_HEADER_LENGTH = MAGIC.length() + Integer.BYTES;

  private static final int INITIAL_BUFFER = 1 << 18;
  private static final int HEADER = RecordHeader.LENGTH;

  private final Path file;
  private final LogInput input;
  private final ProblemAccount problems;

  private byte[] buffer = new byte[INITIAL_BUFFER];
  private int position; // where the next record starts
  private int limit; // up to where the buffer is filled
  private long base; // offset in the log of the buffer's first byte
  private int current; // where the current record starts
  private int size; // of its payload
  private long lastNanos;

  private GameLogReader(Path file, LogInput input) {
    this.file = file;
    this.input = input;
    problems = new ProblemAccount(file);
  }

  /**
   * Opens a log and reads its header.
   *
   * @param file the log
   * @return a reader before the first record
   * @throws GameLogException if there is no such file, it cannot be read, is empty, or is no game log
   */
  public static GameLogReader open(Path file) throws GameLogException {
    return open(file, LARGEST_RATIO);
  }

  /**
   * Opens a log with another limit of the compression ratio, and reads its header.
   *
   * @param file the log
   * @param largestRatio largest accepted ratio of the log's size to that of its compressed file; a log of up to 16 MB is always accepted. {@link Double#POSITIVE_INFINITY}: no limit
   * @return a reader before the first record; {@link #next()} throws where the limit is reached
   * @throws GameLogException if there is no such file, it cannot be read, is empty, or is no game log
   * @throws IllegalArgumentException if the limit is below 1 or NaN
   */
  public static GameLogReader open(Path file, double largestRatio) throws GameLogException {
    if (!(largestRatio >= 1)) {
      throw new IllegalArgumentException("the ratio must be at least 1, but is " + largestRatio);
    }
    GameLogReader reader = new GameLogReader(file, LogInput.open(file, largestRatio));
    try {
      reader.readFileHeader();
      return reader;
    } catch (GameLogException e) {
      try {
        reader.close();
      } catch (IOException closing) {
        e.addSuppressed(closing);
      }
      throw e;
    }
  }

  /**
   * Goes to the next record.
   *
   * @return false at the end of the log
   * @throws GameLogException if the file system fails, or a compressed log exceeds the limit of the compression ratio
   */
  public boolean next() throws GameLogException {
    while (true) {
      int available = fill(HEADER);
      if (available < HEADER) {
        if (available > 0) {
          problems.add(
              LogProblem.TRUNCATED_RECORD, offsetOf(position), () -> available + " bytes are left");
          position = limit;
        }
        return false;
      }
      if (!RecordHeader.isPlausible(buffer, position)) {
        skipGarbage();
        continue;
      }
      int payload = RecordHeader.size(buffer, position);
      if (payload > RecordHeader.MAX_PAYLOAD) {
        skipLargeIndex(payload);
        continue;
      }
      int filled = fill(HEADER + payload + HEADER);
      if (isDamaged(payload, filled)) {
        continue;
      }
      if (filled < HEADER + payload) {
        problems.add(
            LogProblem.TRUNCATED_RECORD,
            offsetOf(position),
            () -> String.format(Locale.ROOT, "%d of %d bytes are there", filled - HEADER, payload));
        position = limit;
        return false;
      }
      current = position;
      size = payload;
      position += HEADER + payload;
      lastNanos = RecordHeader.nanos(buffer, current);
      return true;
    }
  }

  /**
   * When the recorder received the current message.
   *
   * @return Unix time, ns
   */
  public long receivedNanos() {
    return RecordHeader.nanos(buffer, current);
  }

  /**
   * What the current message is.
   *
   * @return its type
   */
  public MessageType type() {
    return MessageType.ofCode(typeCode());
  }

  /**
   * The number of the current message's type, also of unknown ones.
   *
   * @return as in the file
   */
  public int typeCode() {
    return RecordHeader.type(buffer, current);
  }

  /**
   * Where the current record starts.
   *
   * @return bytes from the start of the (decompressed) log
   */
  public long offset() {
    return offsetOf(current);
  }

  /**
   * The array that holds the current message, until the next call of {@link #next()}.
   *
   * @return this reader's own buffer; do not change it
   */
  public byte[] buffer() {
    return buffer;
  }

  /**
   * Where the current message starts in {@link #buffer()}.
   *
   * @return index of its first byte
   */
  public int payloadOffset() {
    return current + HEADER;
  }

  /**
   * The length of the current message.
   *
   * @return bytes
   */
  public int payloadLength() {
    return size;
  }

  /**
   * The current message, to be kept.
   *
   * @return a copy
   */
  public LogMessage message() {
    int start = payloadOffset();
    return new LogMessage(receivedNanos(), type(), Arrays.copyOfRange(buffer, start, start + size));
  }

  /**
   * Goes to the next record and copies it; the convenient way for small logs.
   *
   * @return the message; empty at the end
   * @throws GameLogException if the file system fails, or a compressed log exceeds the limit of the compression ratio
   */
  public Optional<LogMessage> readMessage() throws GameLogException {
    return next() ? Optional.of(message()) : Optional.empty();
  }

  /**
   * How far the file is read, as it lies on the disk.
   *
   * @return bytes
   */
  public long bytesRead() {
    return input.bytesRead();
  }

  /**
   * The size of the file as it lies on the disk.
   *
   * @return bytes
   */
  public long totalBytes() {
    return input.totalBytes();
  }

  /**
   * How much of the log was read.
   *
   * @return bytes after decompression
   */
  public long logBytes() {
    return offsetOf(position);
  }

  /**
   * What was wrong so far.
   *
   * @return the live account
   */
  public ProblemAccount problems() {
    return problems;
  }

  @Override
  public void close() throws IOException {
    input.close();
  }

  private void readFileHeader() throws GameLogException {
    int available = fill(FILE_HEADER_LENGTH);
    if (available == 0) {
      throw new GameLogException(file, 0, "nothing in it can be decompressed; get the file again");
    }
    int compared = Math.min(available, MAGIC.length());
    String start = new String(buffer, 0, compared, StandardCharsets.US_ASCII);
    if (!MAGIC.startsWith(start)) {
      throw new GameLogException(
          file,
          0,
          "is not an SSL game log (it does not start with SSL_LOG_FILE); choose a .log or .log.gz"
              + " file");
    }
    if (available < FILE_HEADER_LENGTH) {
      throw new GameLogException(
          file,
          available,
          "ends within the header of a game log; record again or choose another file");
    }
    int version = ByteBuffer.wrap(buffer, MAGIC.length(), Integer.BYTES).getInt();
    if (version != VERSION) {
      throw new GameLogException(
          file,
          MAGIC.length(),
          "is a game log of version "
              + version
              + ", but only version "
              + VERSION
              + " is known; convert it with ssl-logtools");
    }
    position = FILE_HEADER_LENGTH;
  }

  /** Whether the record at the position has a wrong length; then the position is set to the record that starts within it. */
  private boolean isDamaged(int payload, int available) {
    int end = HEADER + payload;
    boolean followed =
        available == end
            || available >= end + HEADER && RecordHeader.isPlausible(buffer, position + end)
            || available > end && available < end + HEADER;
    if (followed) {
      return false;
    }
    int within = findRecord(position + 1, position + Math.min(end, available));
    if (within < 0) {
      return false;
    }
    int actual = within - position - HEADER;
    problems.add(
        LogProblem.DAMAGED_RECORD,
        offsetOf(position),
        () ->
            String.format(
                Locale.ROOT, "says %d bytes, the next record starts after %d", payload, actual));
    position = within;
    return true;
  }

  private void skipGarbage() throws GameLogException {
    long start = offsetOf(position);
    int window = 2 * (RecordHeader.MAX_SEARCHED_PAYLOAD + 2 * HEADER);
    int from = 1;
    while (true) {
      int available = fill(window);
      // Of a full window only the first half is searched: a record there lies within the window
      // with its successor's header.
      boolean last = available < window;
      int found = findRecord(position + from, last ? limit : position + window / 2);
      if (found >= 0 || last) {
        position = found >= 0 ? found : limit;
        long skipped = offsetOf(position) - start;
        problems.add(LogProblem.GARBAGE, start, () -> skipped + " bytes");
        return;
      }
      position += window / 2;
      from = 0;
    }
  }

  /** The first place in the range at which a record starts that another one or the end of the log follows; -1 if there is none. */
  private int findRecord(int from, int to) {
    for (int at = from; at < to && at + HEADER <= limit; at++) {
      if (RecordHeader.isLikely(buffer, at, lastNanos)) {
        int next = at + HEADER + RecordHeader.size(buffer, at);
        if (next == limit || next + HEADER <= limit && RecordHeader.canFollow(buffer, at, next)) {
          return at;
        }
      }
    }
    return -1;
  }

  private void skipLargeIndex(int payload) throws GameLogException {
    long start = offsetOf(position);
    long left = (long) HEADER + payload;
    while (left > 0) {
      int available = fill((int) Math.min(left, INITIAL_BUFFER));
      if (available == 0) {
        problems.add(LogProblem.TRUNCATED_RECORD, start, () -> "an index of " + payload + " bytes");
        return;
      }
      int step = (int) Math.min(left, available);
      position += step;
      left -= step;
    }
  }

  /** Fills the buffer until it holds the wanted number of bytes from the position on, if the log has as many; returns how many there are. */
  private int fill(int wanted) throws GameLogException {
    if (limit - position >= wanted) {
      return limit - position;
    }
    byte[] target =
        wanted <= buffer.length ? buffer : new byte[Math.max(wanted, 2 * buffer.length)];
    System.arraycopy(buffer, position, target, 0, limit - position);
    buffer = target;
    base += position;
    limit -= position;
    position = 0;
    while (limit < wanted) {
      int count = input.read(buffer, limit, buffer.length - limit, problems, base + limit);
      if (count < 0) {
        break;
      }
      limit += count;
    }
    return limit;
  }

  private long offsetOf(int index) {
    return base + index;
  }
}
