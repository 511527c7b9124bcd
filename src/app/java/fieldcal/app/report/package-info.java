/**
 * The calibration as one page for the operator: {@code report.html}, a single file that opens offline.
 *
 * <p>{@link fieldcal.app.report.CalibrationReport} is the view model, plain numbers and words without any logic of the
 * calibration; {@link fieldcal.app.report.Verdict} puts it into one sentence; {@link
 * fieldcal.app.report.CalibrationReportWriter} writes the page, with the charts, styles and data inlined. The page's
 * plots ({@code plots.js}) know only the JSON of the view model, so that the browser console draws with the same ones.
 *
 * <p>Used by the command line; depends on no package of the library.
 */
package fieldcal.app.report;
