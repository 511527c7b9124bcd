package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A recording that begins, or leaves nothing behind. */
class SessionRecorderTest {
  private static final Epoch EPOCH = new Epoch(1_700_000_000_000_000_000L);

  @TempDir private Path directory;

  @Test
  void takesTheNextFreeName() throws IOException {
    try (SessionRecorder first = SessionRecorder.begin(directory, "session", EPOCH);
        SessionRecorder second = SessionRecorder.begin(directory, "session", EPOCH)) {
      assertThat(first.log()).hasFileName("session.log").exists();
      assertThat(second.log()).hasFileName("session-2.log").exists();
      assertThat(second.commands()).hasFileName("session-2.commands.csv").exists();
    }
  }

  @Test
  void leavesNoEmptyRecordingWhenTheCommandsCannotBeWritten() throws IOException {
    Path taken = Files.createDirectory(directory.resolve("session.commands.csv"));
    assertThatThrownBy(() -> SessionRecorder.begin(directory, "session", EPOCH))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(taken.toString());
    assertThat(directory.resolve("session.log")).doesNotExist();
    assertThat(taken).exists();
  }
}
