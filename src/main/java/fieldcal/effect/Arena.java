package fieldcal.effect;

import fieldcal.vision.RobotId;
import java.util.Arrays;
import java.util.List;

/**
 * What a recording offers to effects that look for their place in it: where and when balls were seen, by which cameras, kicked by whom.
 *
 * @param x0 smallest x at which a ball was seen, m
 * @param x1 largest x, m
 * @param y0 smallest y, m
 * @param y1 largest y, m
 * @param kickTimes session times of the kicks, ascending, s
 * @param flats whether there are flat kicks
 * @param chips whether there are chips
 * @param cameras those that saw enough to be judged, as published
 * @param robots those of which commands are known
 */
public record Arena(
    double x0,
    double x1,
    double y0,
    double y1,
    double[] kickTimes,
    boolean flats,
    boolean chips,
    List<ObservedCamera> cameras,
    List<RobotId> robots) {

  /**
   * Copies what can change. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the bounds are not numbers in order
   */
  public Arena {
    if (!(x0 <= x1 && y0 <= y1)) {
      throw new IllegalArgumentException("bounds: " + x0 + ", " + x1 + ", " + y0 + ", " + y1);
    }
    kickTimes = kickTimes.clone();
    Arrays.sort(kickTimes);
    cameras = List.copyOf(cameras);
    robots = List.copyOf(robots);
  }

  /**
   * Session times of the kicks.
   *
   * @return ascending, s; a copy
   */
  @Override
  public double[] kickTimes() {
    return kickTimes.clone();
  }

  /**
   * Instants at which something may have changed between one kick and the next, spread over the session.
   *
   * @param most how many at most, positive
   * @return session times in the middle between two kicks, ascending, s; empty for a single kick
   * @throws IllegalArgumentException when {@code most} is not positive
   */
  public double[] instantsBetweenKicks(int most) {
    if (most < 1) {
      throw new IllegalArgumentException("must be positive: " + most);
    }
    int gaps = Math.max(0, kickTimes.length - 1);
    int count = Math.min(gaps, most);
    double[] instants = new double[count];
    for (int i = 0; i < count; i++) {
      int gap = (int) ((i + 0.5) * gaps / count);
      instants[i] = 0.5 * (kickTimes[gap] + kickTimes[gap + 1]);
    }
    return instants;
  }

  /**
   * Whether cameras can be compared with each other.
   *
   * @return true from two cameras on
   */
  public boolean hasSeveralCameras() {
    return cameras.size() > 1;
  }
}
