/**
 * Reports for the operator, each a single page that opens offline.
 *
 * <p>{@link fieldcal.app.report.ReportPage} is the frame that all share, with charts, styles and data inlined. The calibration report ({@code report.html}):
 * {@link fieldcal.app.report.CalibrationReport} is the view model, plain numbers and words without any logic of the calibration; {@link
 * fieldcal.app.report.CalibrationReportWriter} writes the page. The page's plots ({@code
 * calibration-plots.js}) know only the JSON of the view model, so that the browser console draws with the same ones. The diagnosis report is {@link
 * fieldcal.app.report.diagnosis}.
 *
 * <p>Used by the command line.
 */
package fieldcal.app.report;
