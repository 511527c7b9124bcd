package fieldcal.app.net;

import java.util.List;
import java.util.Optional;

/**
 * How a receiver does.
 *
 * @param received packets
 * @param dropped of these, those that nobody took in time; always the oldest
 * @param rejoined how often the group was joined again because nothing came or the network was away
 * @param joined the interfaces that the group is joined on; empty where the place is no group
 * @param silentFor time since the last packet, or since the beginning when there was none, s
 * @param problem what is wrong with the network now
 */
public record ReceiverCounts(
    long received,
    long dropped,
    long rejoined,
    List<String> joined,
    double silentFor,
    Optional<String> problem) {}
