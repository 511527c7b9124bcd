/**
 * The tables of the archive: {@link fieldcal.archive.table.Tables} says which there are and what their columns mean, {@link fieldcal.archive.table.ParquetFile} writes and reads them. Knows Parquet,
 * but neither Spark nor game logs.
 */
package fieldcal.archive.table;
