/**
 * Simulated recordings as files: game log, truth and commands.
 *
 * <p>Used by the command {@code simulate} and by tests that need files.
 */
package fieldcal.app.simulation;
