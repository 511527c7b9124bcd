/**
 * The diagnosis as one page for the operator: {@code diagnosis.html}, a single file that opens offline.
 *
 * <p>{@link fieldcal.app.report.diagnosis.DiagnosisReportBuilder} turns a diagnosis into the view model {@link
 * fieldcal.app.report.diagnosis.DiagnosisReport}, {@link fieldcal.app.report.diagnosis.DiagnosisReportWriter} writes the page. Words are those of {@link
 * fieldcal.app.wording}. Used by the command line.
 */
package fieldcal.app.report.diagnosis;
