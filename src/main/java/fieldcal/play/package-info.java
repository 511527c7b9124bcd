/**
 * The calibration play: two robots collect kicks. It is given the world in each tick, and answers what both robots are to do.
 *
 * <p>{@link fieldcal.play.CalibrationPlay} is a plan plus callbacks: no sockets, no threads, no clock. A host (a team's AI, a simulator, the operator's command) calls {@link
 * fieldcal.play.CalibrationPlay#tick} with a {@link fieldcal.play.PlayWorld} as often as it sees the field, and sends the {@link fieldcal.play.RobotOrder}s of the answer. Trouble (a lost ball, a robot
 * taken off, HALT, no vision) is waited out or ends the play with a reason; it never throws while it runs.
 *
 * <p>Each phase of the play is one small step class; {@code Driver}, {@code PathPlanner} and {@code Safety} move the robots round obstacles, and never into each other or out of the margin.
 */
@PublicApi
package fieldcal.play;

import fieldcal.PublicApi;
