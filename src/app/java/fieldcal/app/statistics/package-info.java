/**
 * What recordings look like in numbers: noise, intervals, losses, residuals, distances, speeds, each as samples of kicks or of stretches of time; and tests whether two recordings look alike. Used
 * by {@code app.twin}, which compares a field with its simulated twin, and by {@code app.compare}, which compares a field with a simulator.
 */
package fieldcal.app.statistics;
