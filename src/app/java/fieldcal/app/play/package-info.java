/**
 * The calibration play as a session: play, field, recording and live fits together.
 *
 * <p>{@link fieldcal.app.play.PlaySession} runs {@link fieldcal.play.CalibrationPlay} on a {@link fieldcal.app.play.PlayField} (the embedded simulation, or a simulator on the network), writes
 * everything that vision sends to a game log as it comes, fits each kick as soon as its ball is done, and shows itself in immutable {@link fieldcal.app.play.SessionSnapshot}s.
 */
package fieldcal.app.play;
