/**
 * From one kick to a trajectory with parameters, errors and residuals.
 *
 * <p>The three types of an estimation are kept apart: {@link fieldcal.fit.FitProblem} says which kick is to be explained by which
 * model, seen by which cameras; {@link fieldcal.fit.KickFitter} searches (CMA-ES) and polishes (Levenberg–Marquardt); {@link
 * fieldcal.fit.KickFit} is the answer: estimates, covariance or the reason why there is none, a residual per observation, counts.
 *
 * <p>Positions are fitted, never speeds: each detection at its own time stamp, through its own camera, weighted by that camera's
 * noise. Used by {@code calibration}, {@code diagnosis} and {@code live}.
 */
@PublicApi
package fieldcal.fit;

import fieldcal.PublicApi;
