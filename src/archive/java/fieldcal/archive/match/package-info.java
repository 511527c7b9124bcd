/**
 * One game log: {@link fieldcal.archive.match.MatchReader} reads it once, with the library's kick finder, fits and limits, and {@link fieldcal.archive.match.MatchTables} turns what it found into rows.
 * Knows neither Spark nor files of tables.
 */
package fieldcal.archive.match;
