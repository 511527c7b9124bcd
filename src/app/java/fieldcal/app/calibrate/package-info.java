/**
 * What the {@code calibrate} command does, without the command line: files in, calibration, files out.
 *
 * <p>{@link fieldcal.app.calibrate.CalibrationSession} runs it; the other classes read and write one kind of file each. The
 * browser console uses the same pieces.
 */
package fieldcal.app.calibrate;
