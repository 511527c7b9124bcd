package fieldcal.app.calibrate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MadeFromTest {
  private static final MadeFrom FRIDAY =
      new MadeFrom(List.of("in/a.log", "in/b.log"), List.of("1 ns, 2 bytes", "3 ns, 4 bytes"));

  @TempDir private Path folder;

  /** A file that was renamed is the same recording, and one that replaced it under its name is not. */
  @Test
  void recordingsAreToldApartByWhatTheyAreAndNamedByTheirFiles() {
    MadeFrom renamed =
        new MadeFrom(List.of("y.log", "z.log"), List.of("3 ns, 4 bytes", "1 ns, 2 bytes"));
    assertThat(FRIDAY.unlike(renamed)).isEmpty();
    MadeFrom fewer = new MadeFrom(List.of("c.log"), List.of("1 ns, 2 bytes"));
    assertThat(FRIDAY.unlike(fewer)).contains("other recordings (a.log and b.log)");
    MadeFrom replaced = new MadeFrom(List.of("C:\\out\\c.log"), List.of("5 ns, 2 bytes"));
    assertThat(replaced.unlike(fewer)).contains("other recordings of the same names (c.log)");
  }

  @Test
  void whatIsNotKnownIsNotCalledAnother() throws IOException {
    assertThat(FRIDAY.unlike(MadeFrom.UNKNOWN)).isEmpty();
    assertThat(MadeFrom.UNKNOWN.unlike(FRIDAY)).isEmpty();
    assertThat(MadeFrom.read(folder.resolve("missing.json"))).isEqualTo(MadeFrom.UNKNOWN);
    Path broken = Files.writeString(folder.resolve("broken.json"), "{\"recordings\": [");
    assertThat(MadeFrom.read(broken)).isEqualTo(MadeFrom.UNKNOWN);
    assertThat(ResultFiles.DIAGNOSIS.ofOthers(folder, FRIDAY)).isEmpty();
  }
}
