package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.RecordingOrigin;
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
    try (SessionRecorder first =
            SessionRecorder.begin(directory, "session", EPOCH, RecordingOrigin.FIELD);
        SessionRecorder second =
            SessionRecorder.begin(directory, "session", EPOCH, RecordingOrigin.FIELD)) {
      assertThat(first.log()).hasFileName("session.log").exists();
      assertThat(second.log()).hasFileName("session-2.log").exists();
      assertThat(second.commands()).hasFileName("session-2.commands.csv").exists();
    }
  }

  /** As after a kill while the play waits for vision. */
  @Test
  void canBeReadBeforeAnythingWasRecorded() throws IOException {
    try (SessionRecorder recorder =
        SessionRecorder.begin(directory, "session", EPOCH, RecordingOrigin.FIELD)) {
      try (GameLogReader log = GameLogReader.open(recorder.log())) {
        assertThat(log.next()).isFalse();
      }
      assertThat(CommandFile.read(recorder.commands())).isEmpty();
    }
  }

  @Test
  void neverTouchesCommandsOfAnotherRecording() throws IOException {
    Path commands = directory.resolve("session.commands.csv");
    Files.writeString(commands, "of a recording that was moved elsewhere");
    try (SessionRecorder recorder =
        SessionRecorder.begin(directory, "session", EPOCH, RecordingOrigin.FIELD)) {
      assertThat(recorder.log()).hasFileName("session-2.log");
    }
    assertThat(commands).hasContent("of a recording that was moved elsewhere");
  }

  @Test
  void leavesNoEmptyRecordingWhenTheCommandsCannotBeWritten() throws IOException {
    // Short enough for the log, too long for the commands.
    String name = "x".repeat(250);
    assertThatThrownBy(() -> SessionRecorder.begin(directory, name, EPOCH, RecordingOrigin.FIELD))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(name + ".commands.csv");
    assertThat(directory).isEmptyDirectory();
  }
}
