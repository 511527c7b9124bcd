package fieldcal.gamelog;

/**
 * Distinguishes current messages of a referee from outdated ones: packets overtake each other on the network, and some controllers send the old state once more beside the new one. Mutable, for the messages of one referee and for one thread.
 */
public final class RefereeOrder {
  /**
   * A message that is older than the one before by more than this was not overtaken: the referee's clock was set back, s. Ten times the usual time between two messages.
   */
  private static final double LONGEST_DELAY = 1;

  private RefereeState last;

  /** Starts with nothing heard. */
  public RefereeOrder() {}

  /**
   * Whether a message is to be believed.
   *
   * @param state the next message that was received
   * @return false when it was sent before the last one that was believed, or at the same time with an older command
   */
  public boolean accept(RefereeState state) {
    if (last != null && state.time() > last.time() - LONGEST_DELAY && older(state)) {
      return false;
    }
    last = state;
    return true;
  }

  private boolean older(RefereeState state) {
    return state.time() < last.time()
        || state.time() == last.time() && state.commandTime() < last.commandTime();
  }
}
