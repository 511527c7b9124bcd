package fieldcal.app.diagnose;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.recording.VisionContent;
import fieldcal.diagnosis.Verdict;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.verdict.Finding;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FormerDiagnosisTest {
  private static final String FOUND =
      "{\"schema\": \"fieldcal.diagnosis/1\", \"verdict\": \"explained\", \"sources\":"
          + " [\"somewhere/a.log\"], \"recordings\": [\"5000000000 ns, 700 bytes\"], \"causes\":"
          + " [{\"effect\": \"air_drag\"}], \"kicks\": {\"dropped\": [\"12.5\"]}}";

  @TempDir private Path folder;

  private void write(String text) throws IOException {
    Files.writeString(folder.resolve(FormerDiagnosis.FILE), text);
  }

  @Test
  void itSaysWhatWasFoundAndOfWhichKicks() throws IOException {
    write(FOUND);
    FormerDiagnosis former = FormerDiagnosis.read(folder).orElseThrow();
    assertThat(former.finding()).isEqualTo(new Finding(Verdict.EXPLAINED, List.of("air_drag")));
    RecordingFacts same = facts("renamed.log", 5, 700);
    assertThat(former.isOf(Set.of("12.5"), List.of(same))).isTrue();
    assertThat(former.isOf(Set.of(), List.of(same))).isFalse();
    assertThat(former.isOf(Set.of("12.5"), List.of(same, facts("b.log", 9, 700)))).isFalse();
  }

  /** A recording that replaces another one often has its name. */
  @Test
  void aFileOfTheSameNameWithOtherContentIsAnother() throws IOException {
    write(FOUND);
    FormerDiagnosis former = FormerDiagnosis.read(folder).orElseThrow();
    assertThat(former.isOf(Set.of("12.5"), List.of(facts("a.log", 6, 700)))).isFalse();
    assertThat(former.isOf(Set.of("12.5"), List.of(facts("a.log", 5, 800)))).isFalse();
  }

  private static RecordingFacts facts(String name, long start, long bytes) {
    return new RecordingFacts(
        Path.of(name),
        RecordingOrigin.FIELD,
        0,
        Optional.empty(),
        start * 1_000_000_000L,
        bytes,
        false,
        VisionContent.NONE,
        List.of());
  }

  @Test
  void whatDoesNotSayOfWhichKicksItIsDoesNotCount() throws IOException {
    assertThat(FormerDiagnosis.read(folder)).isEmpty();
    for (String other :
        List.of(
            "",
            "{}",
            "[]",
            FOUND.replace("dropped", "left"),
            FOUND.replace("recordings", "logs"))) {
      write(other);
      assertThat(FormerDiagnosis.read(folder)).as(other).isEmpty();
    }
  }
}
