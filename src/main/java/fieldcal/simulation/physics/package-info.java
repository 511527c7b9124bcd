/**
 * The ball of the simulated field: a spinning rigid sphere, integrated step by step.
 *
 * <p>{@link fieldcal.simulation.physics.BallIntegrator} moves a {@link fieldcal.simulation.physics.BallBody} through flight, impacts, sliding and rolling under the laws of a
 * {@link fieldcal.simulation.physics.BallPhysics}. It knows nothing of the closed forms that the rest of fieldcal fits to recordings, and shares no code with them: a simulated recording
 * whose cause is hidden would prove nothing if the same formula had made and explained it.
 *
 * <p>Position z is the height of the ball's lowest point above the carpet; spin is the angular velocity vector, rad/s.
 */
package fieldcal.simulation.physics;
