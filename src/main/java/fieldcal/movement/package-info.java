/**
 * How fast the robots of both teams move: limits of velocity, acceleration and braking from raw detections.
 *
 * <p>{@link fieldcal.movement.MovementObserver} takes the frames of all cameras one by one. It fits each robot's path with pieces of constant acceleration ({@link
 * fieldcal.movement.Manoeuvre}) and counts them in {@link fieldcal.movement.MovementStatistics}, beside the league's own three histograms ({@link
 * fieldcal.movement.LeagueStatistics}). Statistics of several recordings merge exactly. {@link fieldcal.movement.LimitEstimator} turns them into {@link
 * fieldcal.movement.TeamLimits}: where the manoeuvres cluster, with standard errors, and what the model of one limit for all speeds and directions gets wrong.
 *
 * <p>Used by {@code live} and by the command {@code limits}; knows nothing but {@code vision}.
 */
@PublicApi
package fieldcal.movement;

import fieldcal.PublicApi;
