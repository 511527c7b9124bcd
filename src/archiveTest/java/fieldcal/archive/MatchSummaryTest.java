package fieldcal.archive;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.recording.VisionContent;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.gamelog.RecordingOrigin;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the driver keeps of a log. */
class MatchSummaryTest {
  private static final LogFile LOG =
      new LogFile("/cup/a.log", "a.log", "cup", 1, 0, "0123456789abcdef", null);

  @TempDir private Path folder;

  private static Row kick(int number, boolean trusted) {
    return Tables.KICKS
        .row()
        .set("log", LOG.log())
        .set("kick", number)
        .set("time", 1L)
        .set("team", "A")
        .set("kind", "flat")
        .set("x", 0.0)
        .set("y", 0.0)
        .set("speed", 7.5)
        .set("speed_error", 0.05)
        .set("end", "lost")
        .set("duration", 1.0)
        .set("from_rest", true)
        .set("may_spin", false)
        .set("cameras", List.of(0))
        .set("observations", 9)
        .set("used", 9)
        .set("trusted", trusted)
        .set("selected", false);
  }

  private static Row match() {
    return Tables.MATCHES
        .row()
        .set("log", LOG.log())
        .set("file", LOG.name())
        .set("origin", "field")
        .set("start", 0L)
        .set("duration", 1.0)
        .set("playing", 0.0)
        .set("kicks", 2)
        .set("flat_kicks", 0)
        .set("chips", 0)
        .set("frames", 0L)
        .set("file_bytes", 1L)
        .set("problems", 0);
  }

  /** A bad fit must not accuse a team of having kicked too fast. */
  @Test
  void kicksWhoseFitIsNotTrustedDoNotCount() throws IOException {
    ArchiveFolder archive = new ArchiveFolder(folder.toString());
    archive.prepare();
    RecordingFacts facts =
        new RecordingFacts(
            Path.of(LOG.path()),
            RecordingOrigin.FIELD,
            0,
            Optional.empty(),
            0,
            1,
            false,
            VisionContent.NONE,
            List.of());
    archive.commit(
        LOG,
        Map.of(
            Tables.KICKS, List.of(kick(1, true), kick(2, false)), Tables.MATCHES, List.of(match())),
        facts,
        "1");
    MatchSummary summary = MatchSummary.of(LOG, archive);
    assertThat(summary.kicks()).isEqualTo(2);
    assertThat(Arrays.stream(summary.speeds().get("A")).sum()).isEqualTo(1);
    assertThat(summary.fast()).hasSize(1);
  }
}
