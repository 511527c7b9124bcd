package fieldcal.app.net;

import java.net.InetSocketAddress;
import java.util.List;

/**
 * What came from one sender of a group.
 *
 * @param address who
 * @param packets how many
 * @param wrong of these, those that are no message of the kind that belongs here
 * @param ignored of these, those left out because another sender says the same
 * @param silentFor for how long it had sent nothing when the newest packet of the group came, s
 * @param cameras the cameras that are listened to from here, ascending; empty for a referee
 */
public record SourceCounts(
    InetSocketAddress address,
    long packets,
    long wrong,
    long ignored,
    double silentFor,
    List<Integer> cameras) {

  /** Copies the list. {@inheritDoc} */
  public SourceCounts {
    cameras = List.copyOf(cameras);
  }
}
