package fieldcal.app.report;

import fieldcal.app.files.WholeFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes the calibration report: one HTML file with charts, styles and data inside, which opens without a network. The
 * same report gives the same bytes. Thread safe.
 */
public final class CalibrationReportWriter {
  private static final ReportPage PAGE =
      new ReportPage(
          "Ball calibration",
          "calibration.json",
          "calibration.html",
          "calibration.css",
          List.of("calibration-plots.js", "calibration-views.js", "calibration.js"));

  /** What the page holds. */
  record Contents(CalibrationReport report) {}

  /**
   * What the page's scripts draw from, without the kicks, for pages that draw the same.
   *
   * @param report what to show
   * @return JSON with {@code report}, whose kicks are an empty list; numbers are rounded, unknown ones are null
   * @throws IOException if a value cannot be written as JSON
   */
  public static String jsonWithoutKicks(CalibrationReport report) throws IOException {
    return ReportJson.of(new Contents(report.withoutKicks()));
  }

  /**
   * One kick as the page's scripts draw it.
   *
   * @param kick what to show
   * @return JSON
   * @throws IOException if a value cannot be written as JSON
   */
  public static String json(CalibrationReport.Kick kick) throws IOException {
    return ReportJson.of(kick);
  }

  /**
   * Writes the page, replacing an older one.
   *
   * @param report what to show
   * @param file the HTML file to write; its directory must exist
   * @throws IOException if the file cannot be written
   */
  public void write(CalibrationReport report, Path file) throws IOException {
    String title =
        report.provenance().sources().isEmpty()
            ? "Ball calibration"
            : "Ball calibration: " + String.join(", ", report.provenance().sources());
    WholeFile.write(PAGE.html(title, new Contents(report)), file);
  }
}
