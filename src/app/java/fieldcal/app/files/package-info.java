/** Files that are there whole or not at all; used by everything that writes results. */
package fieldcal.app.files;
