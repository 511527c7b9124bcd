package fieldcal.app.wording;

import fieldcal.gamelog.RefereeState;
import fieldcal.proto.Referee;
import java.util.Locale;

/** What the referee says, in the words of the rules. */
public final class RefereeWords {
  private RefereeWords() {}

  /**
   * Stage and command.
   *
   * @param state what the referee says
   * @return for example "first half, free kick for yellow"
   */
  public static String of(RefereeState state) {
    return of(state.stage()) + ", " + of(state.command());
  }

  /**
   * The part of the match.
   *
   * @param stage as the referee sends it
   * @return for example "before the first half"
   */
  public static String of(Referee.Stage stage) {
    return switch (stage) {
      case NORMAL_FIRST_HALF_PRE -> "before the first half";
      case NORMAL_FIRST_HALF -> "first half";
      case NORMAL_HALF_TIME -> "half time";
      case NORMAL_SECOND_HALF_PRE -> "before the second half";
      case NORMAL_SECOND_HALF -> "second half";
      case EXTRA_TIME_BREAK -> "break before extra time";
      case EXTRA_FIRST_HALF_PRE -> "before the first half of extra time";
      case EXTRA_FIRST_HALF -> "first half of extra time";
      case EXTRA_HALF_TIME -> "half time of extra time";
      case EXTRA_SECOND_HALF_PRE -> "before the second half of extra time";
      case EXTRA_SECOND_HALF -> "second half of extra time";
      case PENALTY_SHOOTOUT_BREAK -> "break before the penalty shoot-out";
      case PENALTY_SHOOTOUT -> "penalty shoot-out";
      case POST_GAME -> "after the game";
    };
  }

  /**
   * What the robots have to do.
   *
   * @param command as the referee sends it
   * @return for example "kick-off for blue"
   */
  public static String of(Referee.Command command) {
    return switch (command) {
      case PREPARE_KICKOFF_YELLOW, PREPARE_KICKOFF_BLUE -> "kick-off" + team(command);
      case PREPARE_PENALTY_YELLOW, PREPARE_PENALTY_BLUE -> "penalty kick" + team(command);
      case DIRECT_FREE_YELLOW, DIRECT_FREE_BLUE -> "free kick" + team(command);
      case INDIRECT_FREE_YELLOW, INDIRECT_FREE_BLUE -> "indirect free kick" + team(command);
      case TIMEOUT_YELLOW, TIMEOUT_BLUE -> "timeout" + team(command);
      case GOAL_YELLOW, GOAL_BLUE -> "goal" + team(command);
      case BALL_PLACEMENT_YELLOW, BALL_PLACEMENT_BLUE -> "ball placement" + team(command);
      case HALT, STOP, NORMAL_START, FORCE_START ->
          command.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    };
  }

  private static String team(Referee.Command command) {
    return command.name().endsWith("_YELLOW") ? " for yellow" : " for blue";
  }
}
