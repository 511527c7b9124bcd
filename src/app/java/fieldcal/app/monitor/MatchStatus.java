package fieldcal.app.monitor;

import fieldcal.gamelog.RefereeState;
import fieldcal.live.LiveSnapshot;
import java.util.Objects;
import java.util.Optional;

/**
 * Everything there is to show of a match at one moment.
 *
 * @param snapshot what was measured
 * @param feed where it comes from
 * @param referee what the referee said last; empty without one
 */
public record MatchStatus(LiveSnapshot snapshot, FeedStatus feed, Optional<RefereeState> referee) {

  /** Checks that nothing is missing. {@inheritDoc} */
  public MatchStatus {
    Objects.requireNonNull(snapshot, "snapshot");
    Objects.requireNonNull(feed, "feed");
    Objects.requireNonNull(referee, "referee");
  }
}
