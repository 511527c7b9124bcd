package fieldcal.app.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class CalibrationReportWriterTest {
  /** Kept for a look at it: the page of a whole session. */
  @Test
  void writesTheSampleSession() throws IOException {
    Path file =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "build", "sample-report.html");
    new CalibrationReportWriter().write(SampleReport.session(20251121), file);
    assertThat(Files.size(file)).isLessThan(8_000_000);
  }
}
