package fieldcal.gamelog;

import fieldcal.proto.Referee;
import java.util.Objects;
import java.util.Optional;

/**
 * What the referee says at one instant.
 *
 * @param time when the message was sent, s since the recording's epoch, on the game controller's clock
 * @param stage the part of the match
 * @param command what the robots have to do
 * @param commandCounter the number of commands so far, unsigned 32 bit; it distinguishes two equal commands in a row
 * @param commandTime when the command was given, s since the recording's epoch
 * @param nextCommand what comes after the current stop, if announced
 * @param yellow the yellow team
 * @param blue the blue team
 * @param blueOnPositiveHalf whether blue defends the goal at positive x, if the referee says so
 */
public record RefereeState(
    double time,
    Referee.Stage stage,
    Referee.Command command,
    long commandCounter,
    double commandTime,
    Optional<Referee.Command> nextCommand,
    TeamState yellow,
    TeamState blue,
    Optional<Boolean> blueOnPositiveHalf) {

  /**
   * One team as the referee reports it.
   *
   * @param name as registered; may be empty
   * @param score goals
   * @param goalkeeper the number of the keeper
   */
  public record TeamState(String name, int score, int goalkeeper) {

    /**
     * Checks the name. {@inheritDoc}
     *
     * @throws NullPointerException if the name is null
     */
    public TeamState {
      Objects.requireNonNull(name, "name");
    }
  }

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws NullPointerException if one is null
   */
  public RefereeState {
    Objects.requireNonNull(stage, "stage");
    Objects.requireNonNull(command, "command");
    Objects.requireNonNull(nextCommand, "nextCommand");
    Objects.requireNonNull(yellow, "yellow");
    Objects.requireNonNull(blue, "blue");
    Objects.requireNonNull(blueOnPositiveHalf, "blueOnPositiveHalf");
  }

  /**
   * Whether the ball may be played: after a start or a free kick, while the clock of a playing stage runs.
   *
   * @return true if robots play
   */
  public boolean isPlaying() {
    return !isBreak()
        && switch (command) {
          case NORMAL_START,
              FORCE_START,
              DIRECT_FREE_YELLOW,
              DIRECT_FREE_BLUE,
              INDIRECT_FREE_YELLOW,
              INDIRECT_FREE_BLUE ->
              true;
          default -> false;
        };
  }

  /**
   * Whether the match pauses for longer: half time, other breaks, after the game, or a timeout. Robots are taken off and changed then.
   *
   * @return true in a break or timeout
   */
  public boolean isBreak() {
    boolean stageBreak =
        switch (stage) {
          case NORMAL_HALF_TIME,
              EXTRA_TIME_BREAK,
              EXTRA_HALF_TIME,
              PENALTY_SHOOTOUT_BREAK,
              POST_GAME ->
              true;
          default -> false;
        };
    return stageBreak
        || command == Referee.Command.TIMEOUT_YELLOW
        || command == Referee.Command.TIMEOUT_BLUE;
  }
}
