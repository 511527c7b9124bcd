package fieldcal.gamelog;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class GameLogRoundTripTest {
  @TempDir Path folder;

  static List<LogMessage> readAll(GameLogReader reader) throws IOException {
    List<LogMessage> messages = new ArrayList<>();
    for (Optional<LogMessage> next = reader.readMessage();
        next.isPresent();
        next = reader.readMessage()) {
      messages.add(next.get());
    }
    return messages;
  }

  @ParameterizedTest
  @ValueSource(strings = {"plain.log", "packed.log.gz"})
  void whatIsWrittenIsRead(String name) throws IOException {
    List<LogMessage> messages = randomMessages(1, 3000, 70_000);
    Path file = folder.resolve(name);
    try (GameLogWriter writer = GameLogWriter.create(file)) {
      for (LogMessage message : messages) {
        writer.write(message);
      }
    }

    try (GameLogReader reader = GameLogReader.open(file)) {
      assertThat(readAll(reader)).isEqualTo(messages);
      assertThat(reader.problems().kinds()).isEmpty();
      assertThat(reader.bytesRead()).isEqualTo(reader.totalBytes()).isEqualTo(Files.size(file));
      assertThat(reader.next()).isFalse();
    }
  }

  @Test
  void compressionIsToldByContentNotByName() throws IOException {
    byte[] log = new LogBuilder().record(1, 4, new byte[100]).bytes();
    Path file = LogBuilder.write(folder.resolve("named.log"), LogBuilder.gzip(log));

    try (GameLogReader reader = GameLogReader.open(file)) {
      assertThat(readAll(reader)).hasSize(1);
    }
  }

  @Test
  void severalGzipMembersAreOneLog() throws IOException {
    byte[] log = new LogBuilder().record(1, 4, new byte[100]).record(2, 3, new byte[7]).bytes();
    byte[] first = LogBuilder.gzip(java.util.Arrays.copyOf(log, 60));
    byte[] second = LogBuilder.gzip(java.util.Arrays.copyOfRange(log, 60, log.length));
    byte[] both = java.util.Arrays.copyOf(first, first.length + second.length);
    System.arraycopy(second, 0, both, first.length, second.length);
    Path file = LogBuilder.write(folder.resolve("members.log.gz"), both);

    try (GameLogReader reader = GameLogReader.open(file)) {
      assertThat(readAll(reader)).hasSize(2);
      assertThat(reader.problems().kinds()).isEmpty();
    }
  }

  @ParameterizedTest
  @EnumSource(MessageType.class)
  void allTypesKeepTheirNumbers(MessageType type) throws IOException {
    Path file = new LogBuilder().record(1, type.code(), new byte[9]).write(folder.resolve("a.log"));

    try (GameLogReader reader = GameLogReader.open(file)) {
      assertThat(reader.next()).isTrue();
      assertThat(reader.type()).isEqualTo(type);
      assertThat(reader.receivedNanos()).isEqualTo(LogBuilder.EPOCH.unixNanosOf(1));
      assertThat(reader.offset()).isEqualTo(16);
    }
  }

  @Test
  void unknownTypesKeepTheirNumber() throws IOException {
    Path file = new LogBuilder().record(1, 42, new byte[9]).write(folder.resolve("a.log"));

    try (GameLogReader reader = GameLogReader.open(file)) {
      assertThat(reader.next()).isTrue();
      assertThat(reader.type()).isEqualTo(MessageType.UNKNOWN);
      assertThat(reader.typeCode()).isEqualTo(42);
    }
  }

  @Test
  void anIndexLargerThanAnyMessageIsSkipped() throws IOException {
    Path file =
        new LogBuilder()
            .record(1, 4, new byte[9])
            .record(2, 6, new byte[5_000_000])
            .record(3, 4, new byte[8])
            .write(folder.resolve("a.log"));

    try (GameLogReader reader = GameLogReader.open(file)) {
      assertThat(readAll(reader))
          .extracting(message -> message.payload().length)
          .containsExactly(9, 8);
      assertThat(reader.problems().kinds()).isEmpty();
    }
  }

  static List<LogMessage> randomMessages(long seed, int count, int maxPayload) {
    SplittableRandom random = new SplittableRandom(seed);
    List<LogMessage> messages = new ArrayList<>();
    long nanos = 1_763_712_345_000_000_000L;
    for (int i = 0; i < count; i++) {
      byte[] payload =
          new byte[random.nextInt(50) == 0 ? random.nextInt(maxPayload) : random.nextInt(700)];
      random.nextBytes(payload);
      nanos += random.nextInt(20_000_000);
      messages.add(new LogMessage(nanos, MessageType.ofCode(1 + random.nextInt(6)), payload));
    }
    return messages;
  }
}
