/**
 * How a ball moves after a kick, in closed form: the models with their parameters, and the paths that follow from them.
 *
 * <p>{@link fieldcal.ball.FlatModel} and {@link fieldcal.ball.ChipModel} hold the numbers that a calibration finds; {@link
 * fieldcal.ball.FlatTrajectory} and {@link fieldcal.ball.ChipTrajectory} say where the ball is at any time, answer the
 * questions of an AI (when is it where, how fast, where does it land, how hard to kick) and know the derivatives that a
 * least-squares fit needs. Everything is immutable; nothing depends on other packages. Used by the fit, the calibration, the
 * diagnosis, the live monitor, and by the code of a team.
 */
@PublicApi
package fieldcal.ball;

import fieldcal.PublicApi;
