package fieldcal.simulation;

import fieldcal.simulation.imaging.RobotView;
import fieldcal.vision.RobotId;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/** Where a robot was at some times. In between it moves evenly; in longer gaps it is away. Immutable. */
public final class RobotTrack {
  /** Longest gap between two places that is bridged, s: a robot of 3 m/s is then 1 m further. */
  private static final double GAP = 0.3;

  private final RobotId id;
  private final double height;
  private final double[] times;
  private final double[] poses;

  /**
   * A track.
   *
   * @param id team and number
   * @param height of the pattern above the carpet, m
   * @param times session times, ascending, s
   * @param poses x and y in m and the orientation in rad of each time, one after another
   * @throws IllegalArgumentException when the counts differ or times do not ascend
   */
  public RobotTrack(RobotId id, double height, double[] times, double[] poses) {
    this.id = Objects.requireNonNull(id, "id");
    this.height = height;
    this.times = times.clone();
    this.poses = poses.clone();
    if (poses.length != 3 * times.length) {
      throw new IllegalArgumentException(times.length + " times, but " + poses.length + " numbers");
    }
    for (int i = 1; i < times.length; i++) {
      if (!(times[i] > times[i - 1])) {
        throw new IllegalArgumentException(
            "times must ascend: " + times[i - 1] + " s, " + times[i] + " s");
      }
    }
  }

  /** Where it is; empty when it is away. */
  Optional<RobotView> at(double time) {
    int found = Arrays.binarySearch(times, time);
    int before = found >= 0 ? found : -found - 2;
    if (before < 0 || before >= times.length) {
      return Optional.empty();
    }
    if (before == times.length - 1) {
      return time - times[before] > GAP ? Optional.empty() : Optional.of(view(before, before, 0));
    }
    double span = times[before + 1] - times[before];
    return span > GAP
        ? Optional.empty()
        : Optional.of(view(before, before + 1, (time - times[before]) / span));
  }

  private RobotView view(int a, int b, double share) {
    double turn = Math.IEEEremainder(poses[3 * b + 2] - poses[3 * a + 2], 2 * Math.PI);
    return new RobotView(
        id,
        poses[3 * a] + share * (poses[3 * b] - poses[3 * a]),
        poses[3 * a + 1] + share * (poses[3 * b + 1] - poses[3 * a + 1]),
        poses[3 * a + 2] + share * turn,
        height);
  }
}
