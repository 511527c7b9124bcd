package fieldcal.simulation.imaging;

import fieldcal.vision.RobotId;

/**
 * A robot as cameras see it at one time.
 *
 * @param id team and number
 * @param x x in the field frame, m
 * @param y y in the field frame, m
 * @param orientation direction of its front, rad, 0 = along x, counter-clockwise
 * @param height of the pattern above the carpet, m
 */
public record RobotView(RobotId id, double x, double y, double orientation, double height) {
  /** Radius of a robot that hides what is behind it, m (the league's maximum). */
  public static final double RADIUS = 0.09;
}
