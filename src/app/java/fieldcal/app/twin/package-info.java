/**
 * A simulated field that behaves like a recorded one: settings of {@code fieldcal.simulation} from a calibration and a diagnosis ({@link fieldcal.app.twin.TwinBuilder}), their file {@code twin.json}
 * ({@link fieldcal.app.twin.TwinFile}), and the check that it does: the same kicks again, compared statistic by statistic.
 */
package fieldcal.app.twin;
