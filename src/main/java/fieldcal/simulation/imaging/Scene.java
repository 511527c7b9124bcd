package fieldcal.simulation.imaging;

import java.util.List;

/** What there is to see. */
public interface Scene {

  /**
   * The ball's position at a time in the recent past.
   *
   * @param time session time, s
   * @param xyz gets the position, m (z = height of the lowest point)
   * @return false when there is no ball to be seen
   */
  boolean ballAt(double time, double[] xyz);

  /**
   * The robots at a time in the recent past.
   *
   * @param time session time, s
   * @return yellow first, by number
   */
  List<RobotView> robotsAt(double time);
}
