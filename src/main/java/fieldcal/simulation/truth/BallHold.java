package fieldcal.simulation.truth;

import fieldcal.vision.RobotId;

/**
 * A robot had the ball at its dribbler.
 *
 * @param robot who
 * @param from session time, s
 * @param to session time, s
 */
public record BallHold(RobotId robot, double from, double to) {}
