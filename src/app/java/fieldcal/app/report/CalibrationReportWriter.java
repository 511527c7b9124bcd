package fieldcal.app.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Writes the calibration report: one HTML file with charts, styles and data inside, which opens without a network. The
 * same report gives the same bytes. Thread safe.
 */
public final class CalibrationReportWriter {

  /**
   * Writes the page, replacing an older one.
   *
   * @param report what to show
   * @param file the HTML file to write; its directory must exist
   * @throws IOException if the file cannot be written
   */
  public void write(CalibrationReport report, Path file) throws IOException {
    Files.writeString(file, ReportPage.of(report));
  }
}
