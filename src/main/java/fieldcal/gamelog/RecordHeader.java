package fieldcal.gamelog;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.time.Instant;

/** The 16 bytes before each message: int64 time (ns), int32 type, int32 size, all big endian; and what such bytes can look like. */
final class RecordHeader {
  static final int LENGTH = 16;

  /** No message is larger, bytes: UDP packets end at 64 KiB; 4 MiB leaves room for what recorders may add. An index may be larger. */
  static final int MAX_PAYLOAD = 1 << 22;

  /** Largest message that is looked for in damaged data, bytes: a larger one that is found by chance would skip more than it could save. */
  static final int MAX_SEARCHED_PAYLOAD = 1 << 17;

  private static final int MAX_TYPE = 63;
  private static final long DAY = 86_400_000_000_000L;
  private static final long HOUR = 3_600_000_000_000L;
  private static final long YEAR_2000 =
      Instant.parse("2000-01-01T00:00:00Z").getEpochSecond() * 1_000_000_000L;
  private static final long YEAR_2100 =
      Instant.parse("2100-01-01T00:00:00Z").getEpochSecond() * 1_000_000_000L;

  private static final VarHandle LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);

  private RecordHeader() {}

  static long nanos(byte[] buffer, int at) {
    return (long) LONG.get(buffer, at);
  }

  static int type(byte[] buffer, int at) {
    return (int) INT.get(buffer, at + 8);
  }

  static int size(byte[] buffer, int at) {
    return (int) INT.get(buffer, at + 12);
  }

  static void write(byte[] buffer, long nanos, int type, int size) {
    LONG.set(buffer, 0, nanos);
    INT.set(buffer, 8, type);
    INT.set(buffer, 12, size);
  }

  /** Whether these bytes, at a place where a header must be, are a header. Zeros are not: a recorder that crashed leaves them. */
  static boolean isPlausible(byte[] buffer, int at) {
    int type = type(buffer, at);
    int size = size(buffer, at);
    long nanos = nanos(buffer, at);
    boolean zeros = type == 0 && size == 0 && nanos == 0;
    return nanos >= 0
        && type >= 0
        && type <= MAX_TYPE
        && size >= 0
        && (size <= MAX_PAYLOAD || type == MessageType.SSL_INDEX_2021.code())
        && !zeros;
  }

  /** The same for bytes found where no header is due: a known type, a usual size, and a time near the last good one or of our century. */
  static boolean isLikely(byte[] buffer, int at, long lastNanos) {
    if (buffer[at + 8] != 0 || buffer[at + 9] != 0 || buffer[at + 10] != 0) {
      return false;
    }
    int type = buffer[at + 11];
    int size = size(buffer, at);
    long nanos = nanos(buffer, at);
    return type >= MessageType.UNKNOWN.code()
        && type <= MessageType.SSL_INDEX_2021.code()
        && size > 0
        && size <= MAX_SEARCHED_PAYLOAD
        && (nanos >= YEAR_2000 && nanos <= YEAR_2100 || Math.abs(nanos - lastNanos) <= DAY);
  }

  /** Records whose times differ by more do not follow each other (see {@link #canFollow}), s. */
  static final double LONGEST_STEP = HOUR * 1e-9;

  /** Whether the header at one place can be followed by that at another. */
  static boolean canFollow(byte[] buffer, int at, int next) {
    return isPlausible(buffer, next) && Math.abs(nanos(buffer, next) - nanos(buffer, at)) <= HOUR;
  }
}
