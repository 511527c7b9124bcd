package fieldcal.verdict;

import java.util.List;

/** What a recording shows of its cameras that makes numbers wrong without raising a residual. */
public sealed interface VisionFault {

  /**
   * Time stamps run at another rate than the recorder's clock: if vision's clock is the wrong one, accelerations are wrong by twice the difference.
   *
   * @param cameras ids, ascending
   * @param rate seconds of the recorder's clock per second of theirs; where these differ, the one farthest from 1
   * @param simulator whether the cameras are a simulator's, whose time need not keep pace with the recorder's clock: then its own time counts
   */
  record ClockRate(List<Integer> cameras, double rate, boolean simulator) implements VisionFault {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when the list is null
     */
    public ClockRate {
      cameras = List.copyOf(cameras);
    }
  }

  /**
   * Cameras that report one another's coordinates, or point-mirrored ones.
   *
   * @param cameras ids, ascending
   * @param swapped whether two cameras have each other's number; otherwise one of them is rotated by 180°
   */
  record MixedUp(List<Integer> cameras, boolean swapped) implements VisionFault {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when the list is null
     */
    public MixedUp {
      cameras = List.copyOf(cameras);
    }
  }
}
