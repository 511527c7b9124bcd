/**
 * The robots of the simulated field: how they move within their limits, hold, kick, stop and deflect the ball.
 *
 * <p>They are driven by {@link fieldcal.simulation.robot.RobotCommand}s, one per robot and tick, as a team's AI would send them.
 */
package fieldcal.simulation.robot;
