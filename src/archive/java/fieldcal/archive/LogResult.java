package fieldcal.archive;

import java.io.Serializable;

/**
 * What became of a log.
 *
 * @param log fingerprint of its content
 * @param broken whether it could not be read
 * @param play time between its first and last message, s
 * @param kicks that were found
 */
record LogResult(String log, boolean broken, double play, long kicks) implements Serializable {}
