package fieldcal.gamelog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each kind of damage, built on purpose. */
class DamagedLogTest {
  private static final int HEADER = 16;

  @TempDir Path folder;

  @Test
  void aMissingFileIsOneLine() {
    assertFatal(folder.resolve("none.log"), "none.log: no such file");
  }

  @Test
  void aFolderIsOneLine() {
    assertFatal(folder, "is a directory");
  }

  @Test
  void anEmptyFileIsOneLine() {
    assertFatal(file(new byte[0]), "is empty");
    assertFatal(file(LogBuilder.gzip(new byte[0])), "nothing in it can be decompressed");
  }

  @Test
  void whatIsNoLogIsOneLine() {
    assertFatal(file("hello, world".getBytes()), "is not an SSL game log");
    assertFatal(file(LogBuilder.gzip("hello, world".getBytes())), "is not an SSL game log");
    assertFatal(file("PK\3\4 and so on".getBytes()), "is a zip archive; unpack it first");
    assertFatal(file(new byte[] {0x1f, (byte) 0x8b, 8}), "gzip header is cut off");
    assertFatal(file("SSL_LOG_FILE".getBytes()), "(byte 12): ends within the header");
    assertFatal(file("SSL_LOG".getBytes()), "(byte 7): ends within the header");
    assertFatal(file("SSL_LOG_FILE\0\0\0\2".getBytes()), "version 2");
  }

  @Test
  void aLogWithoutMessagesIsNone() throws IOException {
    Read read = read(new LogBuilder().bytes());

    assertThat(read.sizes).isEmpty();
    assertThat(read.problems.kinds()).isEmpty();
  }

  @Test
  void aTruncatedGzipIsReadUpToThere() throws IOException {
    byte[] packed = LogBuilder.gzip(records(2000).bytes());
    Read read = read(Arrays.copyOf(packed, packed.length / 2));

    assertThat(read.sizes).hasSizeBetween(800, 1200);
    assertThat(read.problems.count(LogProblem.TRUNCATED_GZIP)).isEqualTo(1);
    assertThat(read.problems.first(LogProblem.TRUNCATED_GZIP).get(0).offset())
        .isGreaterThan(100_000);
  }

  /** A host may run in a language that writes numbers with other digits. */
  @Test
  void problemsHaveTheSameDigitsInEveryLanguage() throws IOException {
    byte[] packed = LogBuilder.gzip(records(2000).bytes());
    byte[] cut = Arrays.copyOf(packed, packed.length / 2);
    List<String> expected = read(cut).problems.lines();
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag("fa-IR"));
    try {
      assertThat(read(cut).problems.lines()).isEqualTo(expected);
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void damagedGzipDataIsReadUpToThere() throws IOException {
    byte[] packed = LogBuilder.gzip(records(2000).bytes());
    Arrays.fill(packed, packed.length / 2, packed.length / 2 + 100, (byte) 0xff);
    Read read = read(packed);

    assertThat(read.sizes).hasSizeBetween(800, 1999);
    assertThat(read.problems.kinds()).isNotEmpty();
  }

  @Test
  void whatUnpacksToFarTooMuchIsRefused() throws IOException {
    // 64 MB of zeros in 64 KB behind a record: a bomb. Without the limit they are read as garbage.
    byte[] bomb = LogBuilder.gzip(records(1).record(9, 4, new byte[1 << 26]).bytes());
    Path file = file(bomb);

    assertThatThrownBy(() -> readAll(file, GameLogReader.LARGEST_RATIO))
        .isInstanceOf(GameLogException.class)
        .hasMessageContaining(file.toString())
        .hasMessageContaining("unpacks to more than 100 times its size")
        .hasMessageContaining("gunzip");
    readAll(file, Double.POSITIVE_INFINITY);
    assertThatThrownBy(() -> GameLogReader.open(file, Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void ofSmallFilesTheRatioDoesNotMatter() throws IOException {
    Path file = file(LogBuilder.gzip(records(1).record(9, 4, new byte[1 << 20]).bytes()));

    readAll(file, GameLogReader.LARGEST_RATIO);
  }

  private static void readAll(Path file, double largestRatio) throws IOException {
    try (GameLogReader log = GameLogReader.open(file, largestRatio)) {
      while (log.next()) {
        // Only whether it can be read.
      }
    }
  }

  @Test
  void bytesAfterTheGzipDataAreReported() throws IOException {
    byte[] packed = LogBuilder.gzip(records(20).bytes());
    byte[] padded = Arrays.copyOf(packed, packed.length + 1000);
    Arrays.fill(padded, packed.length, padded.length, (byte) 'x');
    Read read = read(padded);

    assertThat(read.sizes).hasSize(20);
    assertThat(read.problems.first(LogProblem.BYTES_AFTER_GZIP).get(0).detail())
        .isEqualTo("1000 bytes");
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 15, 16, 17, 100, 215})
  void aRecordLongerThanTheFileIsReported(int left) throws IOException {
    LogBuilder log = records(3);
    int whole = log.size();
    byte[] bytes = Arrays.copyOf(log.record(9, 4, new byte[200]).bytes(), whole + left);
    Read read = read(bytes);

    assertThat(read.sizes).hasSize(3);
    assertThat(read.problems.kinds()).containsExactly(LogProblem.TRUNCATED_RECORD);
    assertThat(read.problems.first(LogProblem.TRUNCATED_RECORD).get(0).offset()).isEqualTo(whole);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 4, 8, 12, 16, 17, 200, 131_073, 300_000, 1_000_000})
  void garbageBetweenRecordsCostsNoRecord(int length) throws IOException {
    byte[] garbage = new byte[length];
    new SplittableRandom(length).nextBytes(garbage);
    assertGarbageIsSkipped(garbage);
  }

  @ParameterizedTest
  @ValueSource(ints = {16, 32, 4096, 500_000})
  void zerosBetweenRecordsCostNoRecord(int length) throws IOException {
    assertGarbageIsSkipped(new byte[length]);
  }

  @Test
  void garbageAtTheEndIsReported() throws IOException {
    byte[] garbage = new byte[5000];
    new SplittableRandom(3).nextBytes(garbage);
    Read read = read(records(5).raw(garbage).bytes());

    assertThat(read.sizes).hasSize(5);
    assertThat(read.problems.kinds()).containsExactly(LogProblem.GARBAGE);
  }

  @ParameterizedTest
  @ValueSource(
      ints = {
        0,
        1,
        199,
        201,
        500,
        100_000,
        4_000_000,
        5_000_000,
        -1,
        Integer.MIN_VALUE,
        Integer.MAX_VALUE
      })
  void aWrongLengthCostsOneRecord(int wrong) throws IOException {
    LogBuilder log = records(5);
    int at = log.size();
    byte[] bytes = log.record(5, 4, filled(200)).bytes();
    bytes = append(bytes, records(2000));
    ByteBuffer.wrap(bytes).putInt(at + 12, wrong);
    Read read = read(bytes);

    assertThat(read.sizes.size()).isBetween(2005, 2006);
    assertThat(read.problems.kinds()).isNotEmpty();
    assertThat(read.problems.kinds().stream().map(read.problems::first).flatMap(List::stream))
        .allSatisfy(
            occurrence -> assertThat(occurrence.offset()).isBetween((long) at, at + HEADER + 200L));
  }

  @Test
  void aDamagedTypeCostsOneRecord() throws IOException {
    LogBuilder log = records(5);
    int at = log.size();
    byte[] bytes = append(log.record(5, 4, filled(200)).bytes(), records(20));
    bytes[at + 8] = 77;
    Read read = read(bytes);

    assertThat(read.sizes).hasSize(25);
    assertThat(read.problems.kinds()).containsExactly(LogProblem.GARBAGE);
    assertThat(read.problems.lines().get(0))
        .isEqualTo(
            "1 × some bytes are not a record; reading goes on with the next record; first at byte "
                + at
                + " (216 bytes)");
  }

  /** A compressed file is shorter than what it holds: a place in it without a word lies beyond its end. */
  @Test
  void aPlaceInACompressedFileSaysWhatItCounts() {
    assertThat(new ProblemAccount(java.nio.file.Path.of("a.log.gz")).place(2309651))
        .isEqualTo("byte 2309651 of the unpacked log");
    assertThat(new ProblemAccount(java.nio.file.Path.of("a.log")).place(16)).isEqualTo("byte 16");
  }

  @Test
  void mutatedLogsNeverThrowOrHang() throws IOException {
    long seed = 20261121;
    SplittableRandom random = new SplittableRandom(seed);
    byte[] plain = records(40).bytes();
    byte[] packed = LogBuilder.gzip(plain);
    for (int round = 0; round < 3000; round++) {
      byte[] bytes = (round % 4 == 0 ? packed : plain).clone();
      for (int hits = 1 + random.nextInt(6); hits > 0; hits--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      if (random.nextInt(3) == 0) {
        bytes = Arrays.copyOf(bytes, random.nextInt(bytes.length));
      }
      try {
        assertThat(read(bytes).sizes.size()).as("seed %d, round %d", seed, round).isLessThan(200);
      } catch (GameLogException e) {
        assertThat(e.getMessage()).doesNotContain("\n").contains("mutant");
      }
    }
  }

  private void assertGarbageIsSkipped(byte[] garbage) throws IOException {
    LogBuilder log = records(5);
    int at = log.size();
    Read read = read(append(log.raw(garbage).bytes(), records(7)));

    assertThat(read.sizes).hasSize(12);
    assertThat(read.problems.kinds()).containsExactly(LogProblem.GARBAGE);
    assertThat(read.problems.first(LogProblem.GARBAGE).get(0))
        .isEqualTo(new ProblemAccount.Occurrence(at, garbage.length + " bytes"));
  }

  private void assertFatal(Path file, String text) {
    assertThatThrownBy(() -> GameLogReader.open(file).close())
        .isInstanceOf(GameLogException.class)
        .hasMessageContaining(text)
        .hasMessageContaining(file.getFileName().toString())
        .satisfies(e -> assertThat(e.getMessage()).doesNotContain("\n"));
  }

  private Path file(byte[] bytes) {
    return LogBuilder.write(folder.resolve("mutant.log"), bytes);
  }

  private record Read(List<Integer> sizes, ProblemAccount problems) {}

  private Read read(byte[] bytes) throws IOException {
    try (GameLogReader reader = GameLogReader.open(file(bytes))) {
      List<Integer> sizes =
          GameLogRoundTripTest.readAll(reader).stream()
              .map(message -> message.payload().length)
              .toList();
      return new Read(sizes, reader.problems());
    }
  }

  private static LogBuilder records(int count) {
    LogBuilder log = new LogBuilder();
    for (int i = 0; i < count; i++) {
      log.record(1 + 0.01 * i, i % 10 == 0 ? 3 : 4, filled(40 + i % 400));
    }
    return log;
  }

  private static byte[] filled(int length) {
    byte[] bytes = new byte[length];
    new SplittableRandom(length).nextBytes(bytes);
    return bytes;
  }

  /** The first log with the records of the second. */
  private static byte[] append(byte[] first, LogBuilder second) {
    byte[] tail = second.bytes();
    byte[] both = Arrays.copyOf(first, first.length + tail.length - 16);
    System.arraycopy(tail, 16, both, first.length, tail.length - 16);
    return both;
  }
}
