/**
 * SSL game logs: files in which a match's network messages are kept as they were received.
 *
 * <p>{@link fieldcal.gamelog.RecordingReader} streams a recording as values: frames in the order of their capture times, geometry
 * when it changes, what the referee said. {@link fieldcal.gamelog.GameLogReader} and {@link fieldcal.gamelog.GameLogWriter} are the
 * layer below, records of bytes. Both need constant memory, and both go on after damage: what was damaged is in
 * {@link fieldcal.gamelog.ProblemAccount}, with its place in the file. {@link fieldcal.gamelog.RecordingStatistics} shows how good
 * a recording is.
 *
 * <p>Used by the commands and by {@code simulation}'s callers to write recordings.
 */
@PublicApi
package fieldcal.gamelog;

import fieldcal.PublicApi;
