/**
 * The kicks of a calibration for other programs to look at: CSV tables for spreadsheets, pandas and PlotJuggler, and MCAP recordings that Foxglove and PlotJuggler replay. Used by {@code calibrate}.
 */
package fieldcal.app.replay;
