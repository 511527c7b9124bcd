package fieldcal.simulation.truth;

import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.RobotId;

/**
 * A robot as it is.
 *
 * @param id team and number
 * @param height of its top, m
 * @param limits what it can do
 */
public record RobotTruth(RobotId id, double height, RobotLimits limits) {}
