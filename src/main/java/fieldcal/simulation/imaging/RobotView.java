package fieldcal.simulation.imaging;

import fieldcal.vision.RobotId;

/**
 * A robot as cameras see it at one time.
 *
 * @param id team and number
 * @param x m
 * @param y m
 * @param orientation rad
 * @param height of the pattern above the carpet, m
 */
public record RobotView(RobotId id, double x, double y, double orientation, double height) {
  /** Radius of a robot that hides what is behind it, m (the league's maximum). */
  public static final double RADIUS = 0.09;
}
