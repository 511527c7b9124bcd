package fieldcal.gamelog;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;

/** Writes a game log; the format is {@link GameLogReader}'s. Not thread-safe. */
public final class GameLogWriter implements Closeable {
  private static final int BUFFER = 1 << 16;

  private final OutputStream out;
  private final byte[] header = new byte[RecordHeader.LENGTH];

  private GameLogWriter(OutputStream out) throws IOException {
    this.out = out;
    out.write(GameLogReader.MAGIC.getBytes(StandardCharsets.US_ASCII));
    out.write(new byte[] {0, 0, 0, GameLogReader.VERSION});
  }

  /**
   * Creates a log file, or overwrites one.
   *
   * @param file where; compressed if the name ends with {@code .gz}
   * @param options how it is opened, for those who do not want to overwrite
   * @return a writer after the file's header
   * @throws IOException if it cannot be written
   */
  public static GameLogWriter create(Path file, OpenOption... options) throws IOException {
    OutputStream raw = Files.newOutputStream(file, options);
    try {
      return to(raw, file);
    } catch (IOException e) {
      raw.close();
      throw e;
    }
  }

  /**
   * Writes a log to a stream, for those who open the file themselves.
   *
   * @param out where; closed with the writer
   * @param file what the log will be called; compressed if the name ends with {@code .gz}
   * @return a writer after the header
   * @throws IOException if it cannot be written
   */
  public static GameLogWriter to(OutputStream out, Path file) throws IOException {
    boolean gzip = file.getFileName().toString().endsWith(".gz");
    return to(gzip ? new GZIPOutputStream(out, BUFFER) : out);
  }

  /**
   * Writes a log to a stream.
   *
   * @param out where; closed with the writer
   * @return a writer after the header
   * @throws IOException if it cannot be written
   */
  public static GameLogWriter to(OutputStream out) throws IOException {
    return new GameLogWriter(new BufferedOutputStream(out, BUFFER));
  }

  /**
   * Writes a message.
   *
   * @param message what
   * @throws IOException if it cannot be written
   */
  public void write(LogMessage message) throws IOException {
    byte[] payload = message.payload();
    write(message.receivedNanos(), message.type().code(), payload, 0, payload.length);
  }

  /**
   * Writes a message.
   *
   * @param receivedNanos when it was received, Unix time, ns
   * @param type what it is
   * @param payload its bytes
   * @throws IOException if it cannot be written
   */
  public void write(long receivedNanos, MessageType type, byte[] payload) throws IOException {
    write(receivedNanos, type.code(), payload, 0, payload.length);
  }

  /**
   * Writes a message of any type from a part of an array.
   *
   * @param receivedNanos when it was received, Unix time, ns
   * @param typeCode the number of its type
   * @param buffer holds its bytes
   * @param offset the first of them
   * @param length how many
   * @throws IOException if it cannot be written
   */
  public void write(long receivedNanos, int typeCode, byte[] buffer, int offset, int length)
      throws IOException {
    RecordHeader.write(header, receivedNanos, typeCode, length);
    out.write(header);
    out.write(buffer, offset, length);
  }

  /**
   * Hands everything written so far to the operating system: if this process dies, a log that is not compressed can be read up to here.
   *
   * @throws IOException if it cannot be written
   */
  public void flush() throws IOException {
    out.flush();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
