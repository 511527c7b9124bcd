/**
 * From recorded game logs to kicks, for all commands that need them.
 *
 * <p>{@link fieldcal.app.recording.KickCollector} reads one log after the other, tells the cameras of different fields apart,
 * watches the rate of each and keeps account of everything that was wrong with the data.
 */
package fieldcal.app.recording;
