package fieldcal.app.diagnose;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.Verdict;
import fieldcal.verdict.Finding;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FormerDiagnosisTest {
  private static final String FOUND =
      "{\"schema\": \"fieldcal.diagnosis/1\", \"verdict\": \"explained\", \"sources\":"
          + " [\"somewhere/a.log\"], \"causes\": [{\"effect\": \"air_drag\"}],"
          + " \"kicks\": {\"dropped\": [\"12.5\"]}}";

  @TempDir private Path folder;

  private void write(String text) throws IOException {
    Files.writeString(folder.resolve(FormerDiagnosis.FILE), text);
  }

  @Test
  void itSaysWhatWasFoundAndOfWhichKicks() throws IOException {
    write(FOUND);
    FormerDiagnosis former = FormerDiagnosis.read(folder).orElseThrow();
    assertThat(former.finding()).isEqualTo(new Finding(Verdict.EXPLAINED, List.of("air_drag")));
    assertThat(former.isOf(Set.of("12.5"), List.of(Path.of("elsewhere/a.log")))).isTrue();
    assertThat(former.isOf(Set.of(), List.of(Path.of("a.log")))).isFalse();
    assertThat(former.isOf(Set.of("12.5"), List.of(Path.of("b.log")))).isFalse();
    assertThat(former.isOf(Set.of("12.5"), List.of(Path.of("a.log"), Path.of("b.log")))).isFalse();
  }

  @Test
  void whatDoesNotSayOfWhichKicksItIsDoesNotCount() throws IOException {
    assertThat(FormerDiagnosis.read(folder)).isEmpty();
    for (String other : List.of("", "{}", "[]", FOUND.replace("dropped", "left"))) {
      write(other);
      assertThat(FormerDiagnosis.read(folder)).as(other).isEmpty();
    }
  }
}
