/**
 * fieldcal, a library that calibrates ball and robot motion for teams of the RoboCup Small Size League.
 *
 * <p>Packages that carry {@link fieldcal.PublicApi} are for hosts; {@code docs/library.md} shows how to use them. All values are in SI units, all results are immutable.
 */
package fieldcal;
