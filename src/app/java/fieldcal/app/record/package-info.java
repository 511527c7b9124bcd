/**
 * Records what a field's network sends as a game log, for {@code record} and for the console.
 *
 * <p>{@link fieldcal.app.record.NetworkRecorder} writes the packets of vision and of the referee as they came. Senders are told apart as everywhere else (see {@code net}), so
 * that a second field on the same group does not get into the recording.
 */
package fieldcal.app.record;
