package fieldcal.app.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class VisionContentTest {
  /** One message for each number. */
  static VisionContent messages(int from, int to) {
    VisionContent.Reading reading = new VisionContent.Reading();
    for (int i = from; i < to; i++) {
      reading.accept(ByteBuffer.allocate(12).putInt(1, i).array(), 1, 11);
    }
    return reading.content();
  }

  @Test
  void aPartIsFoundWhereverItBegins() {
    VisionContent whole = messages(0, 4000);
    assertThat(messages(0, 4000).shareIn(whole)).isEqualTo(1);
    for (int from : new int[] {0, 1, 777, 3000}) {
      assertThat(messages(from, from + 1000).shareIn(whole)).isEqualTo(1);
    }
    assertThat(messages(3500, 4500).shareIn(whole)).isCloseTo(0.5, within(0.15));
    assertThat(messages(4000, 8000).shareIn(whole)).isZero();
  }

  @Test
  void whatWasWrittenIsReadAsItWas() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    messages(0, 1000).writeTo(new DataOutputStream(bytes));
    VisionContent read =
        VisionContent.readFrom(new DataInputStream(new ByteArrayInputStream(bytes.toByteArray())));
    assertThat(read).isEqualTo(messages(0, 1000));
    assertThat(read.shareIn(messages(0, 4000))).isEqualTo(1);
    assertThat(read.mayBeHalfIn(messages(0, 4000))).isTrue();
    assertThat(read.mayBeHalfIn(messages(1000, 4000))).isFalse();
  }

  /** Recordings of a field share their geometry, and some hold hardly more. */
  @Test
  void ofFewMessagesOnlyTheWholeIsRecognised() {
    VisionContent few = messages(0, 100);
    assertThat(few.shareIn(messages(0, 4000))).isZero();
    assertThat(few.shareIn(messages(0, 100))).isEqualTo(1);
    assertThat(VisionContent.NONE.shareIn(messages(0, 0))).isZero();
  }

  @Test
  void noneOfTheRecordingsHoldsFramesOfAnother() throws IOException {
    Path data = Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");
    List<RecordingFacts> all = new ArrayList<>();
    try (Stream<Path> files = Files.list(data)) {
      for (Path log : files.filter(f -> f.toString().endsWith(".log.gz")).sorted().toList()) {
        all.add(RecordingFacts.of(log, LogOpener.USUAL));
      }
    }
    assertThat(all).hasSizeGreaterThan(10);
    for (RecordingFacts one : all) {
      for (RecordingFacts other : all) {
        double share = one.content().shareIn(other.content());
        // Of a thousand remembered checksums, one may be that of another message by chance.
        assertThat(share)
            .as(one.log() + " in " + other.log())
            .isCloseTo(one == other ? 1 : 0, within(0.01));
      }
    }
  }
}
