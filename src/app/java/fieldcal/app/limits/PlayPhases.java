package fieldcal.app.limits;

import fieldcal.gamelog.RefereeState;
import fieldcal.movement.PlayPhase;
import fieldcal.proto.Referee;

/** What the referee's stage and command mean for counting movements. */
public final class PlayPhases {
  private PlayPhases() {}

  /**
   * The phase of a message.
   *
   * @param state what the referee says
   * @return never {@link PlayPhase#UNKNOWN}
   */
  public static PlayPhase of(RefereeState state) {
    if (state.isBreak()) {
      return PlayPhase.BREAK;
    }
    if (state.isPlaying()) {
      return PlayPhase.RUNNING;
    }
    return state.command() == Referee.Command.HALT ? PlayPhase.HALTED : PlayPhase.STOPPED;
  }
}
