package fieldcal.gamelog;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Arrays;
import java.util.Locale;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;

/** The bytes of a log, decompressed if need be. Damage to the compression ends them early and is reported, not thrown. */
final class LogInput implements Closeable {
  private static final int GZIP_BUFFER = 1 << 16;
  private static final int GZIP_TRAILER = 8;

  /** A log that unpacks to no more than this does no harm, however it was packed, bytes. */
  private static final long HARMLESS = 1L << 24;

  private final Path file;
  private final long totalBytes;
  private final CountingStream raw;
  private final Gzip gzip;
  private final InputStream bytes;
  private final double largestRatio;
  private long unpacked;
  private boolean ended;

  private LogInput(Path file, double largestRatio) throws IOException {
    this.file = file;
    this.largestRatio = largestRatio;
    totalBytes = Files.size(file);
    byte[] magic;
    try (InputStream head = Files.newInputStream(file)) {
      magic = head.readNBytes(6);
    }
    requireLog(magic);
    raw = new CountingStream(Files.newInputStream(file));
    try {
      gzip = isGzip(magic) ? new Gzip(raw) : null;
    } catch (IOException e) {
      raw.close();
      throw new GameLogException(
          file, 0, "the gzip header is cut off or damaged; get the file again", e);
    }
    bytes = gzip == null ? raw : gzip;
  }

  static LogInput open(Path file, double largestRatio) throws GameLogException {
    try {
      if (Files.isDirectory(file)) {
        throw new GameLogException(file, "is a directory; name a .log or .log.gz file in it");
      }
      if (Files.exists(file) && !Files.isRegularFile(file)) {
        // Recordings are read more than once, and their size is shown; opening a pipe would wait.
        throw new GameLogException(file, "is a pipe or a device; save it as a file first");
      }
      return new LogInput(file, largestRatio);
    } catch (NoSuchFileException e) {
      throw new GameLogException(file, "no such file; check the name", e);
    } catch (GameLogException e) {
      throw e;
    } catch (IOException e) {
      throw new GameLogException(
          file, "cannot be opened (" + reason(e) + "); check its permissions", e);
    }
  }

  /** Reads at least one byte; returns -1 at the end of the file or where it is damaged. */
  int read(byte[] into, int offset, int length, ProblemAccount problems, long logOffset)
      throws GameLogException {
    if (ended) {
      return -1;
    }
    try {
      int count = bytes.read(into, offset, length);
      if (count < 0) {
        ended = true;
        reportBytesAfterGzip(problems, logOffset);
      } else if (gzip != null) {
        requireRatio(count);
      }
      return count;
    } catch (GameLogException e) {
      throw e;
    } catch (EOFException e) {
      ended = true;
      problems.add(
          LogProblem.TRUNCATED_GZIP, logOffset, () -> "the file has " + totalBytes + " bytes");
      return -1;
    } catch (ZipException e) {
      ended = true;
      problems.add(
          LogProblem.DAMAGED_GZIP,
          logOffset,
          () -> "near byte " + raw.count + " of the file: " + reason(e));
      return -1;
    } catch (IOException e) {
      throw new GameLogException(
          file, raw.count, "cannot be read on (" + reason(e) + "); check the disk", e);
    }
  }

  private void requireRatio(int more) throws GameLogException {
    unpacked += more;
    if (unpacked > HARMLESS && unpacked > largestRatio * raw.count) {
      throw new GameLogException(
          file,
          raw.count,
          String.format(
              Locale.ROOT,
              "unpacks to more than %s times its size, which no recording does; if it is one, raise"
                  + " that limit (--unpack-limit), or unpack it with gunzip and read the .log",
              new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(Locale.ROOT))
                  .format(largestRatio)));
    }
  }

  /** How much of the file was read, bytes as on disk. */
  long bytesRead() {
    return raw.count;
  }

  /** The size of the file when it was opened, bytes. */
  long totalBytes() {
    return totalBytes;
  }

  @Override
  public void close() throws IOException {
    bytes.close();
  }

  private void requireLog(byte[] magic) throws GameLogException {
    if (magic.length == 0) {
      throw new GameLogException(file, 0, "is empty; record again or choose another file");
    }
    String packed =
        startsWith(magic, 'P', 'K')
            ? "zip"
            : startsWith(magic, 'B', 'Z', 'h')
                ? "bzip2"
                : startsWith(magic, 0xfd, '7', 'z', 'X')
                    ? "xz"
                    : startsWith(magic, 0x28, 0xb5, 0x2f, 0xfd) ? "zstd" : null;
    if (packed != null) {
      throw new GameLogException(file, 0, "is a " + packed + " archive; unpack it first");
    }
  }

  private void reportBytesAfterGzip(ProblemAccount problems, long logOffset) throws IOException {
    if (gzip == null) {
      return;
    }
    // The inflater's rest starts with the trailer of the last member.
    long rest = gzip.unread() - GZIP_TRAILER + totalBytes - raw.count;
    if (rest > 0) {
      problems.add(LogProblem.BYTES_AFTER_GZIP, logOffset, () -> rest + " bytes");
    }
  }

  private static boolean isGzip(byte[] magic) {
    return startsWith(magic, 0x1f, 0x8b);
  }

  private static boolean startsWith(byte[] magic, int... expected) {
    byte[] bytes = new byte[expected.length];
    for (int i = 0; i < expected.length; i++) {
      bytes[i] = (byte) expected[i];
    }
    return magic.length >= bytes.length
        && Arrays.equals(magic, 0, bytes.length, bytes, 0, bytes.length);
  }

  private static String reason(IOException e) {
    return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
  }

  /** Reads several members, one after the other, as one. */
  private static final class Gzip extends GZIPInputStream {
    Gzip(InputStream in) throws IOException {
      super(in, GZIP_BUFFER);
    }

    int unread() {
      return inf.getRemaining();
    }
  }

  private static final class CountingStream extends InputStream {
    private final InputStream in;
    private long count;

    CountingStream(InputStream in) {
      this.in = in;
    }

    @Override
    public int read() throws IOException {
      int value = in.read();
      if (value >= 0) {
        count++;
      }
      return value;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
      int read = in.read(into, offset, length);
      if (read > 0) {
        count += read;
      }
      return read;
    }

    @Override
    public int available() throws IOException {
      return in.available();
    }

    @Override
    public void close() throws IOException {
      in.close();
    }
  }
}
