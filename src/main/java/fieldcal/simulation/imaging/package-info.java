/**
 * The cameras of the simulated field: what they are, what is published of them, when they expose and what vision makes of it.
 *
 * <p>{@link fieldcal.simulation.imaging.CameraRig} hangs one to eight {@link fieldcal.simulation.imaging.SimulatedCamera}s over the field. Each sees the ball through its true
 * calibration, adds noise in its image, and reports through the published one; what a field gets wrong (pose, lens, height of the ball, time stamps) is the difference between the two.
 */
package fieldcal.simulation.imaging;
