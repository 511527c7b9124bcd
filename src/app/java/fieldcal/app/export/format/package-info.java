/**
 * Configuration files of other programs: where the value of a key stands in a file, and how a new file is written. Used by {@code fieldcal.app.export}.
 *
 * <p>An edit replaces the characters of single values, so that comments, order and blanks of a file that somebody cares for stay as they are, byte for byte.
 */
package fieldcal.app.export.format;
