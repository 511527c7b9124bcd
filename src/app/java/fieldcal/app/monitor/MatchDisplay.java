package fieldcal.app.monitor;

import fieldcal.gamelog.RefereeState;
import fieldcal.live.LiveListener;

/** Shows a match to somebody. Told of single events by the thread that fits, of the whole by the one that feeds. */
public interface MatchDisplay extends LiveListener, AutoCloseable {

  /**
   * The present state; comes several times a second of the clock on the wall.
   *
   * @param status what there is to show
   */
  void show(MatchStatus status);

  /**
   * The referee changed stage or command.
   *
   * @param state what it says now
   * @param time Unix time, s
   */
  default void referee(RefereeState state, double time) {}

  /** The referee has been silent for so long that everything counts again. */
  default void refereeLost() {}

  /**
   * Whether anybody can still see it.
   *
   * @return false once the reader of a pipe has closed it
   */
  default boolean watched() {
    return true;
  }

  /**
   * The last state.
   *
   * @param status what there is to show
   */
  void summary(MatchStatus status);

  /** Leaves the screen as it was. */
  @Override
  default void close() {}
}
