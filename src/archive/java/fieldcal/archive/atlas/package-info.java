/** {@code archive.html}: the page of an archive, in the frame of all reports. Plain numbers and words, drawn by {@code atlas.js}. */
package fieldcal.archive.atlas;
