/**
 * What really happened on the simulated field: the kicks, why they ended, where the ball was.
 *
 * <p>Tests and people compare results with it; no code that is being judged reads it.
 */
package fieldcal.simulation.truth;
