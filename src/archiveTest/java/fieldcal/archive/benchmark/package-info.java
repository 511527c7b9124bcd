/** The benchmark of the archive: draws hundreds of matches with known truth, archives them as a user would, and compares. Not part of the tests. */
package fieldcal.archive.benchmark;
