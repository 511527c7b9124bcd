package fieldcal.app.report.diagnosis;

import fieldcal.app.files.WholeFile;
import fieldcal.app.report.ReportPage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes the diagnosis report: one HTML file with charts, styles and data inside, which opens without a network. The same report gives the same bytes. Thread safe.
 */
public final class DiagnosisReportWriter {
  private static final ReportPage PAGE =
      new ReportPage(
          "What the ball model gets wrong",
          "diagnosis.json",
          "diagnosis/diagnosis.html",
          "diagnosis/diagnosis.css",
          List.of("diagnosis/diagnosis-plots.js", "diagnosis/diagnosis.js"));

  /** A writer. */
  public DiagnosisReportWriter() {}

  /**
   * Writes the page, replacing an older one.
   *
   * @param report what to show
   * @param file the HTML file to write; its directory must exist
   * @throws IOException if the file cannot be written
   */
  public void write(DiagnosisReport report, Path file) throws IOException {
    String sources = String.join(", ", report.provenance().sources());
    WholeFile.write(PAGE.html("Diagnosis: " + sources, report), file);
  }
}
