/**
 * The one estimation kernel for many kicks that share a model: a problem (kicks with their own parameters, global parameters with priors, magnitudes that differ
 * from kick to kick), one solver that eliminates the kicks' own parameters, and a solution with covariance, scores of further columns and predictions for kicks that were left out.
 * Knows neither trajectories nor effects: a {@link fieldcal.fit.joint.KickTerm} brings its residuals. Used by the joint calibration, the diagnosis and the choice of the next kick.
 */
package fieldcal.fit.joint;
