package fieldcal.app.archive;

/**
 * How far an archive is.
 *
 * @param logs that are to be read
 * @param logsDone of them
 * @param bytes of their files
 * @param bytesDone of them
 * @param play time between first and last message of the logs that are done, s
 */
public record ArchiveProgress(int logs, int logsDone, long bytes, long bytesDone, double play) {}
