/**
 * Whether a calibrated model may be published.
 *
 * <p>{@link fieldcal.verdict.VerdictRule} weighs {@link fieldcal.verdict.Evidence}: the calibration, the recordings it was made from,
 * what is published now, and what a diagnosis found. Its answer, a {@link fieldcal.verdict.PublishVerdict}, is one decision with its
 * reasons, each a typed value with the numbers it was decided by. Every tool shows this answer; none decides on its own.
 *
 * <p>Above {@code calibration} and {@code diagnosis}, since both are evidence; used by the operator tools.
 */
package fieldcal.verdict;
