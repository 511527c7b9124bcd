/**
 * Many game logs at once, on Apache Spark: {@link fieldcal.archive.SparkArchive} finds the logs, gives each to one task, and writes what follows from all of them. One log is one task, since
 * a compressed log cannot be split; what a task does with it is in {@link fieldcal.archive.match}, what it writes in {@link fieldcal.archive.table}.
 *
 * <p>Used by the command {@code archive} through {@link fieldcal.app.archive.ArchiveEngine}.
 */
package fieldcal.archive;
